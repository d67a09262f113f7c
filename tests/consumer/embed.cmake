# Builds the README's program by the README's CMakeLists, on a machine that has what the planner needs and no more, and runs it.
include(${CONSUMER}/stranger.cmake)
set(absent PCL AlignabilityPcl embree sdformat12 assimp EXPAT TBB PkgConfig AlignabilityCairomm CLI11)
if(INSTALLED_SHARED)
  list(APPEND absent yaml-cpp TIFF PNG nlohmann_json)
endif()
list(TRANSFORM absent REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")

set(project ${CONSUMER}/embed)
set(program ${project}/build/embed_objective)
file(COPY ${ALIGNABILITY_SOURCE_DIR}/tests/consumer/CMakeLists.txt ${ALIGNABILITY_SOURCE_DIR}/demos/embed_objective.cpp DESTINATION ${project})
execute_process(COMMAND ${CMAKE_COMMAND} --fresh -G ${GENERATOR} -C ${CONSUMER}/stranger.cmake ${absent} -S ${project} -B ${project}/build
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${project}/build COMMAND_ERROR_IS_FATAL ANY)

file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${program} RESOLVED_DEPENDENCIES_VAR libraries)
if(NOT libraries MATCHES "libompl")
  message(FATAL_ERROR "The program's libraries are not found: ${libraries}")
endif()
if(libraries MATCHES "lib(pcl|embree|vtk|sdformat|assimp|cairo)[^;]*")
  message(FATAL_ERROR "A program that only plans loads ${CMAKE_MATCH_0}")
endif()

execute_process(COMMAND ${program} WORKING_DIRECTORY ${ALIGNABILITY_SOURCE_DIR} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "[0-9.]+ m long, cost [0-9.]+\n$")
  message(FATAL_ERROR "The program says ${said}")
endif()

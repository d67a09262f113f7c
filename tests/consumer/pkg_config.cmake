# Builds the README's program by what pkg-config says of the installed package, and runs it.
set(ENV{PKG_CONFIG_PATH} ${LIBRARIES}/pkgconfig)
execute_process(COMMAND pkg-config --cflags --libs alignability-planner OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags)
execute_process(COMMAND ${COMPILER} -std=c++20 ${SANITIZER_FLAG} ${SOURCES}/demos/embed_objective.cpp -o ${PROGRAM} ${flags}
    -Wl,-rpath,${LIBRARIES}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} WORKING_DIRECTORY ${SOURCES} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "[0-9.]+ m long, cost [0-9.]+\n$")
  message(FATAL_ERROR "The program says ${said}")
endif()

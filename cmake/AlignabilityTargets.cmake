# One way to declare a target, so that every room is built and installed alike.

set(alignability_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/alignability)

# What every target of ours is compiled with; nothing of it reaches a consumer.
function(alignability_compile_privately target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    # g++ 12 takes the concatenation of short strings for overlapping copies (GCC bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${ALIGNABILITY_WARNINGS_AS_ERRORS}>:-Werror>
    # A multiply and an add fused on one machine and not on another would give other bytes.
    -ffp-contract=off)
  if(ALIGNABILITY_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${ALIGNABILITY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # Under AddressSanitizer Eigen aligns memory by hand, and what PCL, which was built without, hands over would be freed wrongly.
    target_compile_definitions(${target} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
    target_link_options(${target} PRIVATE -fsanitize=${ALIGNABILITY_SANITIZE})
  endif()
endfunction()

# alignability_add_library(ROOM HEADERS … SOURCES …): the library alignability::ROOM of the folder ROOM.
function(alignability_add_library room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;SOURCES")
  set(target alignability_${room})
  add_library(${target} ${arg_SOURCES})
  add_library(alignability::${room} ALIAS ${target})
  alignability_compile_privately(${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  # Installed libraries find one another wherever the prefix is.
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room} INSTALL_RPATH "$ORIGIN"
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS ${target} EXPORT alignability-${room}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/alignability COMPONENT dev)
  install(EXPORT alignability-${room} NAMESPACE alignability::
    FILE alignability-${room}-targets.cmake DESTINATION ${alignability_package_folder} COMPONENT dev)
endfunction()

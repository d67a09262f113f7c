# What strangers do with the installed package, each a CMake project outside of this one. All stand on the first test.
set(consumer ${PROJECT_BINARY_DIR}/consumer)
if(ALIGNABILITY_SANITIZE)
  set(sanitizer_flag -fsanitize=${ALIGNABILITY_SANITIZE})
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/stranger.cmake.in ${consumer}/stranger.cmake @ONLY)
set(configure ${CMAKE_COMMAND} --fresh -G ${CMAKE_GENERATOR} -C ${consumer}/stranger.cmake)

add_test(NAME Consumer.InstallsThePackage
  COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -D PREFIX=${consumer}/prefix -P ${CMAKE_CURRENT_LIST_DIR}/install.cmake)
set_tests_properties(Consumer.InstallsThePackage PROPERTIES FIXTURES_SETUP package)

add_test(NAME Consumer.FindsTheComponentsAskedForAndWhatTheyNeed
  COMMAND ${configure} -S ${CMAKE_CURRENT_LIST_DIR}/components -B ${consumer}/components)
add_test(NAME Consumer.EmbedsThePlannerWithoutPclAndEmbree
  COMMAND ${CMAKE_COMMAND} -D CONSUMER=${consumer} -D GENERATOR=${CMAKE_GENERATOR}
    -P ${CMAKE_CURRENT_LIST_DIR}/embed.cmake)
set(consumer_tests Consumer.FindsTheComponentsAskedForAndWhatTheyNeed Consumer.EmbedsThePlannerWithoutPclAndEmbree)

if(BUILD_SHARED_LIBS)
  add_test(NAME Consumer.EmbedsThePlannerByPkgConfig
    COMMAND ${CMAKE_COMMAND} -D LIBRARIES=${consumer}/prefix/${CMAKE_INSTALL_LIBDIR} -D COMPILER=${CMAKE_CXX_COMPILER}
      -D SANITIZER_FLAG=${sanitizer_flag} -D SOURCES=${PROJECT_SOURCE_DIR} -D PROGRAM=${consumer}/by_pkg_config
      -P ${CMAKE_CURRENT_LIST_DIR}/pkg_config.cmake)
  list(APPEND consumer_tests Consumer.EmbedsThePlannerByPkgConfig)
endif()

# A header reads the same under a sanitizer.
if(NOT ALIGNABILITY_SANITIZE)
  add_test(NAME Consumer.FindsAllThatTheHeadersInclude
    COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_LIST_DIR}/headers ${consumer}/headers
      --build-generator ${CMAKE_GENERATOR} --build-options -C ${consumer}/stranger.cmake)
  list(APPEND consumer_tests Consumer.FindsAllThatTheHeadersInclude)
endif()
if(cli IN_LIST ALIGNABILITY_ROOMS)
  add_test(NAME Consumer.RunsTheInstalledProgram COMMAND ${consumer}/prefix/${CMAKE_INSTALL_BINDIR}/alignability --version)
  set(shared ${consumer}/prefix/${CMAKE_INSTALL_DATADIR})
  add_test(NAME Consumer.FindsManPagesAndCompletions
    COMMAND ${CMAKE_COMMAND} -E sha1sum ${consumer}/prefix/${CMAKE_INSTALL_MANDIR}/man1/alignability-validate-map.1
      ${shared}/bash-completion/completions/alignability ${shared}/zsh/vendor-completions/_alignability
      ${shared}/fish/vendor_completions.d/alignability.fish)
  list(APPEND consumer_tests Consumer.RunsTheInstalledProgram Consumer.FindsManPagesAndCompletions)
endif()
# Under a sanitizer Python would have to be told of it; tests/python does that.
if(python IN_LIST ALIGNABILITY_ROOMS AND NOT ALIGNABILITY_SANITIZE)
  add_test(NAME Consumer.ImportsTheInstalledPythonPackage COMMAND ${Python_EXECUTABLE} -c "import alignability; print(alignability.Robot())")
  set_tests_properties(Consumer.ImportsTheInstalledPythonPackage PROPERTIES
    ENVIRONMENT PYTHONPATH=${consumer}/prefix/${ALIGNABILITY_PYTHON_FOLDER} PASS_REGULAR_EXPRESSION "Robot.radius=0.0")
  list(APPEND consumer_tests Consumer.ImportsTheInstalledPythonPackage)
endif()
set_tests_properties(${consumer_tests} PROPERTIES FIXTURES_REQUIRED package TIMEOUT 600)

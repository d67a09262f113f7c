# pybind11_add_module, for Debian's Python where there is one, to which NumPy belongs, whatever comes first on the PATH;
# -DPython_EXECUTABLE=… takes another.
find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT Python_EXECUTABLE)
  unset(Python_EXECUTABLE CACHE)
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 QUIET CONFIG)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AlignabilityPython REQUIRED_VARS Python_EXECUTABLE Python_INCLUDE_DIRS pybind11_FOUND)

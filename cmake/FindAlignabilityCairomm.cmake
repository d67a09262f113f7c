# The target PkgConfig::cairomm: cairomm comes without a package for CMake.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(cairomm QUIET IMPORTED_TARGET cairomm-1.16)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AlignabilityCairomm REQUIRED_VARS cairomm_FOUND)

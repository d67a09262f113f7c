# The target ompl::ompl: libompl and its headers. What OMPL itself gives CMake names Boost libraries and a bare `ode` too.
find_path(OMPL_HEADERS ompl/base/OptimizationObjective.h PATH_SUFFIXES ompl-1.5 ompl-1.6 ompl-1.7 ompl)
find_library(OMPL_LIBRARY ompl)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AlignabilityOmpl REQUIRED_VARS OMPL_LIBRARY OMPL_HEADERS)
if(AlignabilityOmpl_FOUND AND NOT TARGET ompl::ompl)
  add_library(ompl::ompl UNKNOWN IMPORTED GLOBAL)
  set_target_properties(ompl::ompl PROPERTIES IMPORTED_LOCATION ${OMPL_LIBRARY})
  target_include_directories(ompl::ompl SYSTEM INTERFACE ${OMPL_HEADERS})
  # OMPL's headers include Eigen's and Boost's.
  target_link_libraries(ompl::ompl INTERFACE Eigen3::Eigen Boost::headers)
endif()

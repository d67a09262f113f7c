# The target ompl::ompl: libompl and its headers. Installed with the package, for whoever embeds the planner.
if(NOT TARGET ompl::ompl)
  find_path(OMPL_HEADERS ompl/base/OptimizationObjective.h PATH_SUFFIXES ompl-1.5 ompl-1.6 ompl-1.7 ompl REQUIRED)
  find_library(OMPL_LIBRARY ompl REQUIRED)
  add_library(ompl::ompl UNKNOWN IMPORTED GLOBAL)
  set_target_properties(ompl::ompl PROPERTIES IMPORTED_LOCATION ${OMPL_LIBRARY})
  target_include_directories(ompl::ompl SYSTEM INTERFACE ${OMPL_HEADERS})
  # OMPL's headers include Eigen's and Boost's, and its state serialization links the latter.
  target_link_libraries(ompl::ompl INTERFACE Eigen3::Eigen Boost::headers)
endif()

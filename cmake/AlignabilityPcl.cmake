# pcl::NAME for the few libraries of PCL that are linked.
find_path(PCL_HEADERS pcl/point_types.h PATH_SUFFIXES pcl-1.12 pcl-1.13 pcl-1.14 pcl-1.15 REQUIRED)
foreach(name common kdtree search features segmentation)
  find_library(PCL_${name}_LIBRARY pcl_${name} REQUIRED)
  add_library(pcl::${name} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(pcl::${name} PROPERTIES IMPORTED_LOCATION ${PCL_${name}_LIBRARY})
  target_include_directories(pcl::${name} SYSTEM INTERFACE ${PCL_HEADERS})
  target_link_libraries(pcl::${name} INTERFACE Eigen3::Eigen Boost::headers)
endforeach()

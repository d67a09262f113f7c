# What each room stands on. Read by the build, for the rooms that it builds, and by the installed package, for the components asked for.
#
#   ROOM_beneath   other rooms
#   ROOM_public    packages whose headers its own include: needed by whoever compiles against it
#   ROOM_private   packages of its sources alone: needed by whoever links it, if it is a static library
#
# A package is written as find_package takes it. Those called Alignability… are find modules beside this file.

set(alignability_rooms core costmap planner lidar alignability localization pictures report cli python)  # in the order the data flows: an arrow never points back

set(alignability_core_public "Eigen3 3.4 CONFIG")
set(alignability_core_private yaml-cpp)

set(alignability_costmap_beneath core)
set(alignability_costmap_private yaml-cpp TIFF PNG)

set(alignability_planner_beneath costmap)
set(alignability_planner_public "Boost 1.74 CONFIG" AlignabilityOmpl)
set(alignability_planner_private nlohmann_json yaml-cpp)

set(alignability_lidar_beneath core)
set(alignability_lidar_private "Boost 1.74 CONFIG" TBB "embree 3" EXPAT sdformat12 assimp nlohmann_json AlignabilityPcl)

set(alignability_alignability_beneath costmap lidar)
set(alignability_alignability_private "Boost 1.74 CONFIG" TBB AlignabilityPcl yaml-cpp)

set(alignability_localization_beneath costmap lidar)
set(alignability_localization_private "Boost 1.74 CONFIG" yaml-cpp)

set(alignability_pictures_beneath costmap)
set(alignability_pictures_private AlignabilityCairomm)

set(alignability_report_beneath planner pictures)
set(alignability_report_private nlohmann_json)

set(alignability_cli_beneath alignability planner localization pictures report)
set(alignability_cli_private AlignabilityPcl CLI11 nlohmann_json)

set(alignability_python_beneath alignability planner localization)
set(alignability_python_private AlignabilityPcl AlignabilityPython)

# alignability_with_beneath(VARIABLE ROOM…): those rooms and all beneath them, each after those it stands on.
function(alignability_with_beneath variable)
  set(wanted ${ARGN})
  set(ordered)
  set(downwards ${alignability_rooms})
  list(REVERSE downwards)
  foreach(room IN LISTS downwards)
    if(room IN_LIST wanted)
      list(APPEND wanted ${alignability_${room}_beneath})
      list(PREPEND ordered ${room})
    endif()
  endforeach()
  set(${variable} ${ordered} PARENT_SCOPE)
endfunction()

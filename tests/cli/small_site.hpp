// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "tests/core/temporary_folder.hpp"

namespace alignability::test {

/// Writes into a folder what the commands read: world.sdf, a room of 8 × 6 m with a block in it; sensor.yaml, coarse and quick;
/// problem.yaml, from one side of the block to the other on the maps occupancy.yaml and alignability.yaml, which are still to be made.
inline void write_small_site(const TemporaryFolder& folder) {
  const auto box = [](const std::string& name, const std::string& pose, const std::string& size) {
    return "<model name='" + name + "'><static>true</static><pose>" + pose +
           " 0 0 0</pose><link name='link'><collision name='collision'><geometry><box><size>" + size +
           "</size></box></geometry></collision></link></model>\n";
  };
  folder.write("world.sdf", "<?xml version='1.0'?>\n<sdf version='1.7'><world name='small'>\n" + box("floor", "4 3 -0.05", "8.4 6.4 0.1") +
                                box("west", "-0.1 3 1.5", "0.2 6.4 3") + box("east", "8.1 3 1.5", "0.2 6.4 3") +
                                box("south", "4 -0.1 1.5", "8.4 0.2 3") + box("north", "4 6.1 1.5", "8.4 0.2 3") +
                                box("block", "4 3 1.5", "2 1 3") + "</world></sdf>\n");
  folder.write("sensor.yaml",
               "name: coarse\nelevation_deg: {min: -40, max: 30, count: 15}\nazimuth_deg: {min: -180, max: 180, count: 360}\n"
               "range: {min: 0.2, max: 30, stddev: 0.005}\nrate: 10\nmount: {xyz: [0, 0, 1], rpy_deg: [0, 0, 0]}\n");
  folder.write("problem.yaml",
               "map: occupancy.yaml\nalignability: alignability.yaml\nrobot: {radius: 0.3}\nstart: [1.5, 3, 0]\ngoal: [6.5, 3, 0]\n"
               "planner: {iterations: 2000, seed: 1}\n");
}

}  // namespace alignability::test

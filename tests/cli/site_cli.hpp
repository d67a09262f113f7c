// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/program.hpp"
#include "tests/cli/small_site.hpp"

namespace alignability::test {

/// What makes the maps of the small site.
inline const std::vector<std::string> kOccupancy{"occupancy", "world.sdf",    "--z-min", "0.1", "--z-max",
                                                 "2",         "--resolution", "0.1",     "-o",  "occupancy"};
inline const std::vector<std::string> kMap{"map",         "--scene",   "world.sdf", "--occupancy", "occupancy.yaml", "--sensor",
                                           "sensor.yaml", "--samples", "2",         "-o",          "alignability"};

/// The program run in a folder of its own that holds the small site.
class SiteCli : public testing::Test {
 protected:
  SiteCli() { write_small_site(folder); }

  Outcome run(const std::vector<std::string>& arguments) const { return run_program(arguments, folder / ""); }
  Outcome run(std::vector<std::string> arguments, const std::vector<std::string>& more) const {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
  std::string bytes(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }
  void make_maps() const {
    ASSERT_EQ(run(kOccupancy).exit_code, 0);
    ASSERT_EQ(run(kMap).exit_code, 0);
  }

  TemporaryFolder folder;
};

}  // namespace alignability::test

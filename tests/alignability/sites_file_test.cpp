// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/sites_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

constexpr const char* kTwoSites =
    "sensor: sensors/hdl32e.yaml\nrange_max: 20\nsamples: 4\nreadings: [robust, centred]\nsites:\n"
    "  - {name: hall, scene: hall.sdf, occupancy: hall_occupancy.yaml}\n"
    "  - {name: yard, scene: yard.pcd, occupancy: yard_occupancy.yaml, sensor: vlp16.yaml, level: true, thin: 0.1, resolution: 2,\n"
    "     samples: 1, headings: 4, seed: 7, floor: 0.5, stride: 2, centred: true, readings: [], output: maps/yard}\n";

TEST(SitesFile, GivesEachSiteWhatHoldsForAllUnlessItSaysOtherwise) {
  const test::TemporaryFolder folder;
  const std::vector<MapSite> sites = read_sites_file(folder.write("sites.yaml", kTwoSites));
  ASSERT_EQ(sites.size(), 2u);
  const MapSite& hall = sites[0];
  EXPECT_EQ(hall.name, "hall");
  EXPECT_EQ(hall.output, folder / "hall");
  EXPECT_EQ(hall.scene, folder / "hall.sdf");
  EXPECT_EQ(hall.sensor, folder / "sensors/hdl32e.yaml");
  EXPECT_EQ(hall.map.range_max, 20.0);
  EXPECT_EQ(hall.map.samples, 4);
  EXPECT_EQ(hall.headings, std::nullopt);
  EXPECT_THAT(hall.map.alignability.readings, testing::ElementsAre(Reading::centred, Reading::robust));
  const MapSite& yard = sites[1];
  EXPECT_EQ(yard.output, folder / "maps/yard");
  EXPECT_EQ(yard.sensor, folder / "vlp16.yaml");
  EXPECT_TRUE(yard.reading.level);
  EXPECT_EQ(yard.reading.discs.thinning, 0.1);
  EXPECT_EQ(yard.map.resolution, 2.0);
  EXPECT_EQ(yard.map.range_max, 20.0);
  EXPECT_EQ(yard.map.samples, 1);
  EXPECT_EQ(yard.headings, 4);
  EXPECT_EQ(yard.map.seed, 7u);
  EXPECT_EQ(yard.map.floor, 0.5);
  EXPECT_EQ(yard.map.alignability.segmentation.stride, 2);
  EXPECT_EQ(yard.map.alignability.moment, Moment::about_mean);
  EXPECT_TRUE(yard.map.alignability.readings.empty());
}

struct Fault {
  const char* text;
  const char* message;
};

class SitesFileFault : public testing::TestWithParam<Fault> {};

TEST_P(SitesFileFault, IsToldAtItsPlace) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("sites.yaml", GetParam().text);
  EXPECT_THAT(test::thrown_message([&] { read_sites_file(file); }), testing::HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Of, SitesFileFault,
    testing::Values(Fault{"sensor: s.yaml\n", "sites.yaml:1:1: 'sites' must list at least one site"},
                    Fault{"sites: []\n", "sites.yaml:1:8: 'sites' must list at least one site"},
                    Fault{"sites: {hall: {}}\n", "sites.yaml:1:8: 'sites' must be a list of 'key: value' pairs"},
                    Fault{"sample: 3\nsites: [{name: a}]\n", "sites.yaml:1:1: unknown key 'sample' (did you mean 'samples'?)"},
                    Fault{"name: a\nsites: [{name: a}]\n", "sites.yaml:1:1: unknown key 'name'"},
                    Fault{"sites:\n  - {scene: a.sdf}\n", "sites.yaml:2:5: missing key 'name'"},
                    Fault{"sites:\n  - {name: '', scene: a.sdf}\n", "sites.yaml:2:12: 'name' must not be empty"},
                    Fault{"sites:\n  - {name: a, scene: a.sdf, occupancy: o.yaml}\n",
                          "sites.yaml:2:5: the site has no 'sensor', nor is there one for all sites"},
                    Fault{"sites:\n  - {name: a, seed: -1}\n", "sites.yaml:2:21: 'seed' must be a whole number from 0"},
                    Fault{"sites:\n  - {name: a, samples: 0}\n",
                          "sites.yaml:2:24: 'samples' must be a whole number from 1 to 100000, not 0"},
                    Fault{"sites:\n  - {name: a, level: yes}\n", "sites.yaml:2:22: 'level' is 'yes', which is none of: false, true"},
                    Fault{"sites:\n  - {name: a, up: w}\n", "sites.yaml:2:19: 'up' is 'w', which is none of: x, y, z"},
                    Fault{"sites:\n  - {name: a, readings: [robust, sturdy]}\n", "sites.yaml:2:25: 'readings' must be of: centred, voxel"},
                    Fault{"sites:\n  - {name: a, readings: [robust, robust]}\n", "each once"},
                    Fault{"sites:\n  - {name: a, cells: [1, 2]}\n", "sites.yaml:2:15: unknown key 'cells'"},
                    Fault{"scene: a.sdf\noccupancy: o.yaml\nsensor: s.yaml\nsites:\n  - {name: a}\n  - {name: a, output: b}\n",
                          "sites.yaml:6:12: there is another site of the name 'a'"},
                    Fault{"scene: a.sdf\noccupancy: o.yaml\nsensor: s.yaml\nsites:\n  - {name: a}\n  - {name: b, output: ./a}\n",
                          "sites.yaml:6:23: the sites 'a' and 'b' have the same output"},
                    Fault{"scene: a.sdf\nsensor: s.yaml\nsites:\n  - {name: a, occupancy: ./b.yaml}\n  - {name: b, occupancy: c.yaml}\n",
                          "sites.yaml:5:5: the map would be written over"}));

}  // namespace
}  // namespace alignability

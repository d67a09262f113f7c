// SPDX-License-Identifier: BSD-3-Clause
#include "localization/drive_file.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/core/temporary_folder.hpp"
#include "tests/core/thrown_message.hpp"

namespace alignability {
namespace {

DriveOptions read(const test::TemporaryFolder& folder, const std::string& text) {
  return read_drive_file(folder.write("drive.yaml", text));
}

TEST(DriveFile, SaysWhatDrivesAndHowItIsLocalized) {
  const test::TemporaryFolder folder;
  const DriveOptions drive =
      read(folder,
           "speed: 1.5\nturn_rate_deg: 90\nodometry: {scale_bias: 0.02, heading_bias_deg: 180, position_noise: 0.01}\n"
           "localizers: [scan_matching, ndt_mcl_product]\nparticles: 250\nregularization: {least_effective: 0.1}\ncell: 0.5\n"
           "motion_noise: {per_metre: [0.1, 0.2, 0.3]}\nstart_deviations: {position: 0.4, heading_deg: 180}\n");
  EXPECT_EQ(drive.pace.speed, 1.5);
  EXPECT_DOUBLE_EQ(drive.pace.turn_rate, std::numbers::pi / 2);
  EXPECT_EQ(drive.odometry.scale_bias, 0.02);
  EXPECT_DOUBLE_EQ(drive.odometry.heading_bias, std::numbers::pi);
  EXPECT_EQ(drive.odometry.heading_noise, 0.0);
  EXPECT_EQ(drive.localizers, (std::vector{Localizer::scan_matching, Localizer::ndt_mcl_product}));
  EXPECT_EQ(drive.localizer.ndt_mcl.particles, 250);
  ASSERT_TRUE(drive.localizer.ndt_mcl.regularization);
  EXPECT_EQ(drive.localizer.ndt_mcl.regularization->least_effective, 0.1);
  EXPECT_EQ(drive.localizer.ndt_mcl.regularization->bandwidths, Regularization{}.bandwidths);
  EXPECT_EQ(drive.localizer.ndt.cell, 0.5);
  EXPECT_EQ(drive.localizer.ndt_mcl.noise.per_metre, (Pose2{0.1, 0.2, 0.3}));
  EXPECT_EQ(drive.localizer.scan_matcher.noise.per_metre, (Pose2{0.1, 0.2, 0.3}));
  EXPECT_DOUBLE_EQ(drive.localizer.start_deviations.yaw, std::numbers::pi);
}

TEST(DriveFile, FiltersAsPublishedUnlessToldOtherwise) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(read(folder, "speed: 1\n").localizer.ndt_mcl.regularization);
  EXPECT_TRUE(read(folder, "regularization: {}\n").localizer.ndt_mcl.regularization);
}

TEST(DriveFile, RefusesWhatItDoesNotKnowAtItsPlace) {
  const test::TemporaryFolder folder;
  const auto message = [&](const std::string& text) { return test::thrown_message([&] { read(folder, text); }); };
  EXPECT_NE(message("sped: 1\n").find("drive.yaml:1:1: unknown key 'sped' (did you mean 'speed'?)"), std::string::npos);
  EXPECT_NE(message("speed: 0\n").find("drive.yaml:1:8"), std::string::npos);
  EXPECT_NE(message("localizers: [ndt_mcl]\n").find("no localizer 'ndt_mcl'"), std::string::npos);
  EXPECT_NE(message("localizers: []\n").find("at least one"), std::string::npos);
  EXPECT_NE(message("odometry: {scale_bias: 2}\n").find("drive.yaml:1:24"), std::string::npos);
  EXPECT_NE(message("odometry: {bias: 0.1}\n").find("unknown key 'bias'"), std::string::npos);
  EXPECT_NE(message("regularization: {least_effective: 0.5}\n").find("drive.yaml:1:35"), std::string::npos);
  EXPECT_NE(message("motion_noise: {per_metre: [1, 2]}\n").find("drive.yaml:1:"), std::string::npos);
}

}  // namespace
}  // namespace alignability

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ompl/util/Console.h>

namespace {

// OMPL tells of each planner's progress on stdout, where it would bury what a test has to say.
class QuietOmpl : public testing::Environment {
  void SetUp() override { ompl::msg::setLogLevel(ompl::msg::LOG_WARN); }
};

const testing::Environment* const kQuietOmpl = testing::AddGlobalTestEnvironment(new QuietOmpl);

}  // namespace

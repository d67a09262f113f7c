// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace alignability::test {

/// Where real sites and scans lie that the project does not ship: beside the checkout, or where the environment says.
inline std::filesystem::path shared_data(const std::filesystem::path& relative) {
  const char* folder = std::getenv("ALIGNABILITY_SHARED_DATA");
  const std::filesystem::path root =
      folder != nullptr ? std::filesystem::path(folder) : std::filesystem::path(ALIGNABILITY_SOURCE_DIR) / "../shared/data";
  return root / relative;
}

}  // namespace alignability::test

/// Declares `variable` as the path of shared data, or skips the test, saying so, where it is absent.
#define ALIGNABILITY_REQUIRE_SHARED_DATA(variable, relative)                        \
  const std::filesystem::path variable = alignability::test::shared_data(relative); \
  if (!std::filesystem::exists(variable)) GTEST_SKIP() << "shared data is absent: " << (relative)

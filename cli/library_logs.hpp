// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/console/print.h>

namespace alignability::cli {

/// While it lives, OMPL's warnings and errors go to stderr and the rest of what it says nowhere: stdout is for data. PCL says nothing: what
/// it fails at our own errors name.
class LibraryLogs {
 public:
  LibraryLogs();
  ~LibraryLogs();
  LibraryLogs(const LibraryLogs&) = delete;
  LibraryLogs& operator=(const LibraryLogs&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL pcl_before_;
};

}  // namespace alignability::cli

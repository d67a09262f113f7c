// SPDX-License-Identifier: BSD-3-Clause
#include "cli/library_logs.hpp"

#include <ompl/util/Console.h>

#include <iostream>

namespace alignability::cli {
namespace {

class ToStderr : public ompl::msg::OutputHandler {
 public:
  void log(const std::string& text, ompl::msg::LogLevel level, const char*, int) override {
    if (level >= ompl::msg::LOG_WARN) std::cerr << "ompl: " << text << '\n';
  }
};

}  // namespace

LibraryLogs::LibraryLogs() : pcl_before_(pcl::console::getVerbosityLevel()) {
  static ToStderr handler;
  ompl::msg::useOutputHandler(&handler);
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

LibraryLogs::~LibraryLogs() {
  pcl::console::setVerbosityLevel(pcl_before_);
  ompl::msg::restorePreviousOutputHandler();
}

}  // namespace alignability::cli

// SPDX-License-Identifier: BSD-3-Clause
#include "cli/ompl_log.hpp"

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

OmplLog::OmplLog() {
  static ToStderr handler;
  ompl::msg::useOutputHandler(&handler);
}

OmplLog::~OmplLog() { ompl::msg::restorePreviousOutputHandler(); }

}  // namespace alignability::cli

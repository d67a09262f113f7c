// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "core/progress.hpp"

namespace alignability::cli {

/// Draws a bar and the time left on stderr, at most ten times a second; nothing where stderr is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  ProgressCallback callback() {
    return [this](Progress progress) { show(progress); };
  }

 private:
  using Clock = std::chrono::steady_clock;

  void show(Progress progress);

  std::string label_;
  bool on_terminal_;
  bool drawn_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_ = begin_;
};

/// "1 h 03 min", "4 min 10 s", "12 s".
std::string duration_text(double seconds);

}  // namespace alignability::cli

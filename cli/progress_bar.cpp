// SPDX-License-Identifier: BSD-3-Clause
#include "cli/progress_bar.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace alignability::cli {

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fprintf(stderr, "\r\033[K");
}

void ProgressBar::show(Progress progress) {
  constexpr std::chrono::milliseconds kPause(100);
  constexpr int kWidth = 30;
  const Clock::time_point now = Clock::now();
  if (!on_terminal_ || progress.total == 0 || (drawn_ && now - last_ < kPause && progress.done < progress.total)) return;
  last_ = now;
  drawn_ = true;
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const int full = static_cast<int>(share * kWidth);
  std::string bar(static_cast<std::size_t>(full), '#');
  bar.resize(kWidth, '.');
  const std::string left = progress.done == 0 ? "" : duration_text(elapsed * (1.0 - share) / share) + " left";
  std::fprintf(stderr, "\r\033[K%s [%s] %3.0f %%  %s", label_.c_str(), bar.c_str(), 100.0 * share, left.c_str());
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  char text[64];
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%lld h %02lld min", whole / 3600, whole / 60 % 60);
  } else if (whole >= 60) {
    std::snprintf(text, sizeof text, "%lld min %02lld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld s", whole);
  }
  return text;
}

}  // namespace alignability::cli

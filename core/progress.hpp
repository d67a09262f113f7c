// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <functional>

namespace alignability {

struct Progress {
  std::size_t done = 0;
  std::size_t total = 0;
};

/// Called as long work goes on, never by two threads at once; not necessarily by the thread that started the work.
using ProgressCallback = std::function<void(Progress)>;

/// Thrown by long work that was told to stop: there is no result, and no file was touched but the checkpoint that was asked for.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// Asked now and then by a long search whether to stop; one that is empty never says so.
using StopTest = std::function<bool()>;

inline bool is_told_to_stop(const StopTest& stop) { return stop && stop(); }

/// Throws Interrupted where it says so.
inline void stop_if(const StopTest& stop) {
  if (is_told_to_stop(stop)) throw Interrupted();
}

}  // namespace alignability

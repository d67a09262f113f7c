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

/// Thrown by long work whose stop token was triggered: there is no result, and no file was touched but the checkpoint that was asked for.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

}  // namespace alignability

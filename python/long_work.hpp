// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <type_traits>

#include "core/progress.hpp"

namespace alignability::python {

/// One call that lasts: runs it on a thread of its own without the interpreter lock, while the calling thread sees to signals. Whatever a
/// signal's handler raises, KeyboardInterrupt for Ctrl-C, or the caller's progress function, asks the work to stop and comes out of `run`
/// once it has.
class LongWork {
 public:
  /// `progress` is a function of (done, total) or None. Throws a TypeError for what cannot be called.
  explicit LongWork(pybind11::object progress = pybind11::none());

  /// What to hand to the work; lasts as long as this. Empty where nobody wants to know.
  ProgressCallback progress();

  /// Takes `work(stop_token)`, which must touch nothing of Python. Call it with the lock held.
  template <typename Work>
  auto run(const Work& work) -> std::invoke_result_t<Work, std::stop_token> {
    auto result = std::async(std::launch::async, [&] { return work(stop_.get_token()); });
    watch([&](std::chrono::milliseconds patience) { return result.wait_for(patience) == std::future_status::ready; });
    if (raised_) throw *raised_;
    return result.get();
  }

 private:
  void watch(const std::function<bool(std::chrono::milliseconds)>& is_done);
  void stop_with(pybind11::error_already_set error);
  void report(Progress progress);

  pybind11::object progress_;
  std::stop_source stop_;
  std::optional<pybind11::error_already_set> raised_;  // the first; under the interpreter lock
};

}  // namespace alignability::python

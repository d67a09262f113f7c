// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <stop_token>
#include <utility>

#include "core/progress.hpp"
#include "planner/plan_problem.hpp"

namespace alignability::detail {

/// Until when a plan may be searched for, from where this is made: by the planner's time, but where iterations limit it, and until told to
/// stop.
class TimeLimit {
 public:
  TimeLimit(const PlannerChoice& choice, std::stop_token stop)
      : stop_(std::move(stop)), seconds_(choice.time), is_timed_(!choice.iterations) {}

  /// Says so after that share of the time. May be asked from several threads.
  StopTest after(double share) const {
    return [stop = stop_, is_timed = is_timed_, end = begin_ + std::chrono::duration<double>(share * seconds_)] {
      return stop.stop_requested() || (is_timed && std::chrono::steady_clock::now() >= end);
    };
  }
  StopTest search() const { return after(1.0); }
  /// For what shortens a path that was found, and for the bound that it is held against: a little more than the search has.
  StopTest afterwards() const { return after(1.05); }

 private:
  std::stop_token stop_;
  double seconds_;
  bool is_timed_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace alignability::detail

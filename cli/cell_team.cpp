// SPDX-License-Identifier: BSD-3-Clause
#include "cli/cell_team.hpp"

#include <algorithm>
#include <utility>

namespace alignability::cli {
namespace {

// Much longer than a message takes, much shorter than a build; what cells cost nothing are asked for in such numbers at most.
constexpr double kSupply = 0.25;  // [s]
constexpr double kMostWaiting = 4096;

}  // namespace

CellTeam::CellTeam(const CellWork& work, int threads) : work_(work), threads_count_(static_cast<std::size_t>(threads)) {
  std::fegetenv(&floating_point_);
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work_on_cells(); });
}

CellTeam::~CellTeam() {
  {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
  }
  come_.notify_all();
}

std::size_t CellTeam::wanted() const {
  const std::scoped_lock lock(mutex_);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  const double supply = std::min(kMostWaiting, kSupply * static_cast<double>(taken_) / std::max(seconds, 1e-3));
  const std::size_t target = std::max(threads_count_, static_cast<std::size_t>(supply));
  return 2 * waiting_.size() > target ? 0 : target - waiting_.size();
}

void CellTeam::add(std::span<const std::size_t> cells) {
  {
    const std::scoped_lock lock(mutex_);
    waiting_.insert(waiting_.end(), cells.begin(), cells.end());
    open_ += cells.size();
  }
  come_.notify_all();
}

std::vector<EvaluatedCell> CellTeam::take() {
  const std::scoped_lock lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  taken_ += done_.size();
  open_ -= done_.size();
  return std::exchange(done_, {});
}

bool CellTeam::is_idle() const {
  const std::scoped_lock lock(mutex_);
  return open_ == 0;
}

void CellTeam::work_on_cells() {
  std::fesetenv(&floating_point_);
  std::unique_lock lock(mutex_);
  while (true) {
    come_.wait(lock, [this] { return closed_ || failure_ || !waiting_.empty(); });
    if (closed_ || failure_) return;
    const std::size_t cell = waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    CellValue value;
    std::exception_ptr failure;
    try {
      value = work_.evaluate(cell);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure) {
      failure_ = failure;
    } else {
      done_.push_back({cell, std::move(value)});
    }
  }
}

}  // namespace alignability::cli

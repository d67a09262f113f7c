// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cfenv>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "alignability/cell_work.hpp"

namespace alignability::cli {

struct EvaluatedCell {
  std::size_t cell = 0;
  CellValue value;
};

/// Threads that evaluate cells as these come in, while the thread that made them sees to messages. All work in that thread's
/// floating-point mode.
class CellTeam {
 public:
  /// `work` must outlive it.
  CellTeam(const CellWork& work, int threads);
  /// Forgets the cells that are not begun, and waits for the others.
  ~CellTeam();
  CellTeam(const CellTeam&) = delete;
  CellTeam& operator=(const CellTeam&) = delete;

  /// So many cells more that there is work for a while: none as long as half of that is waiting.
  std::size_t wanted() const;
  void add(std::span<const std::size_t> cells);
  /// Those that were finished since the last call. Throws what an evaluation threw.
  std::vector<EvaluatedCell> take();
  /// Whether all cells that came in were finished and taken.
  bool is_idle() const;

 private:
  using Clock = std::chrono::steady_clock;

  void work_on_cells();

  const CellWork& work_;
  std::size_t threads_count_;
  std::fenv_t floating_point_{};
  mutable std::mutex mutex_;
  std::condition_variable come_;
  std::deque<std::size_t> waiting_;
  std::vector<EvaluatedCell> done_;
  std::size_t open_ = 0;   // came in and were not taken yet
  std::size_t taken_ = 0;  // in all
  Clock::time_point begin_ = Clock::now();
  std::exception_ptr failure_;
  bool closed_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace alignability::cli

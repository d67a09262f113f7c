// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <stop_token>
#include <string>

#include "alignability/cell_work.hpp"
#include "cli/ranks.hpp"

namespace alignability::cli {

/// How the leading rank has the others work on one piece of input: they read it too, are told whether there is work on it, and evaluate
/// the cells that are dispensed to them while it evaluates its own share. Alone there is nobody to compare with, and the work is spread
/// over threads.
class LedWork {
 public:
  LedWork(Ranks& ranks, std::stop_token stop) : ranks_(ranks), stop_(std::move(stop)) {}
  /// Whatever happened, the others are through with this piece.
  ~LedWork();
  LedWork(const LedWork&) = delete;
  LedWork& operator=(const LedWork&) = delete;

  /// Throws std::runtime_error that names a rank which could not read the input, or has read another; Interrupted. `digest` is asked for
  /// where there are others.
  void compare(const std::function<std::string()>& digest);
  /// To be used at most once.
  CellSpread spread();

 private:
  /// What a rank has read.
  struct Findings {
    std::string name;
    std::string digest;
    std::string fault;
  };

  void spread_over_ranks(const CellWork& work);
  bool hear_findings();
  std::size_t hear_report(const Ranks::Message& message, const CellWork& work);
  void tell_all(char what);
  void let_go();

  Ranks& ranks_;
  std::stop_token stop_;
  std::map<int, Findings> findings_;
  std::map<int, std::size_t> asking_;  // for so many cells, and not answered
  bool is_begun_ = false;
  std::set<int> gone_;
};

/// What another rank does with the same piece of input: `read` gives its digest, and throws where it cannot be read. Says whether the rank
/// is to work on it.
bool is_wanted(Ranks& ranks, const std::function<std::string()>& read);

/// Evaluates what the leading rank dispenses, and sends it the values.
CellSpread spread_for_the_lead(Ranks& ranks);

/// Runs the leading rank's part of a job, or another's, and gives the exit code of the leading one on every rank. A failure of another
/// rank is told on stderr and ends the job.
int run_on_ranks(Ranks& ranks, const std::function<int()>& lead, const std::function<void()>& follow);

}  // namespace alignability::cli

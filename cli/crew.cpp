// SPDX-License-Identifier: BSD-3-Clause
#include "cli/crew.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "cli/cell_team.hpp"
#include "cli/exit_code.hpp"
#include "cli/failure.hpp"
#include "core/progress.hpp"

namespace alignability::cli {
namespace {

using Clock = std::chrono::steady_clock;

// How a message begins. To the leading rank:
constexpr char kFindings = 'f';  // name, digest, fault, each ended by a zero
constexpr char kReport = 'r';    // how many cells are wanted; cells with their values
constexpr char kGone = 'g';      // the last of a piece of work; unasked for, where the rank was interrupted
// and from it:
constexpr char kBegin = 'b';  // there is work on this piece
constexpr char kCells = 'c';
constexpr char kEnd = 'e';    // no more cells; answered by kGone
constexpr char kLeave = 'l';  // on to the next piece
constexpr char kQuit = 'q';   // the exit code

// Between two looks for messages: nothing beside a cell, and nearly no load.
constexpr std::chrono::milliseconds kPause(2);
// What is done is told at least so often.
constexpr std::chrono::milliseconds kSilence(500);
// How long an interrupted job waits for the others before it says so.
constexpr std::chrono::milliseconds kPatience(500);
// Then own threads are seen to again.
constexpr int kMostMessagesAtOnce = 256;

template <typename T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <typename T>
std::vector<T> take(std::string_view& bytes, std::size_t count) {
  std::vector<T> values(count);
  std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return values;
}

struct Report {
  std::size_t wanted = 0;
  std::vector<EvaluatedCell> done;
};

std::string to_bytes(const Report& report) {
  const std::array<std::uint64_t, 2> counts{report.wanted, report.done.size()};
  std::string bytes(1, kReport);
  append(bytes, counts.data(), counts.size());
  for (const EvaluatedCell& done : report.done) {
    const std::uint64_t cell = done.cell;
    append(bytes, &cell, 1);
    append(bytes, done.value.data(), done.value.size());
  }
  return bytes;
}

Report report_of(std::string_view bytes) {
  bytes.remove_prefix(1);
  const auto counts = take<std::uint64_t>(bytes, 2);
  Report report{.wanted = counts[0], .done = std::vector<EvaluatedCell>(counts[1])};
  const std::size_t values = report.done.empty() ? 0 : (bytes.size() / report.done.size() - sizeof(std::uint64_t)) / sizeof(float);
  for (EvaluatedCell& done : report.done) {
    done.cell = take<std::uint64_t>(bytes, 1).front();
    done.value = take<float>(bytes, values);
  }
  return report;
}

std::string to_bytes(std::span<const std::size_t> cells) {
  const std::vector<std::uint64_t> numbers(cells.begin(), cells.end());
  std::string bytes(1, kCells);
  append(bytes, numbers.data(), numbers.size());
  return bytes;
}

std::vector<std::size_t> cells_of(std::string_view bytes) {
  bytes.remove_prefix(1);
  const auto numbers = take<std::uint64_t>(bytes, bytes.size() / sizeof(std::uint64_t));
  return {numbers.begin(), numbers.end()};
}

// Hands out cells, fewer at a time towards the end, so that all ranks end together.
class Dispenser {
 public:
  Dispenser(std::span<const std::size_t> cells, int ranks) : left_(cells), ranks_(static_cast<std::size_t>(ranks)) {}

  std::span<const std::size_t> at_most(std::size_t wanted) {
    const std::size_t fair = std::max<std::size_t>(1, left_.size() / (2 * ranks_));
    const auto some = left_.first(std::min({wanted, fair, left_.size()}));
    left_ = left_.subspan(some.size());
    return some;
  }

 private:
  std::span<const std::size_t> left_;
  std::size_t ranks_;
};

// What ends the work of a rank that does not lead.
struct Dismissed {
  int exit_code;
};

std::optional<std::string> message_from_the_lead(Ranks& ranks) {
  auto message = ranks.receive();
  if (!message) return std::nullopt;
  if (message->bytes.front() == kQuit) throw Dismissed{static_cast<unsigned char>(message->bytes.back())};
  return std::move(message->bytes);
}

std::string await_the_lead(Ranks& ranks) {
  while (true) {
    if (auto message = message_from_the_lead(ranks)) return *std::move(message);
    std::this_thread::sleep_for(kPause);
  }
}

// The cells that a rank was given, until it is told to end.
void work_for_the_lead(Ranks& ranks, const CellWork& work) {
  CellTeam team(work, work.threads);
  Report report;
  bool is_asking = false;
  Clock::time_point last = Clock::now();
  while (true) {
    while (const auto message = message_from_the_lead(ranks)) {
      if (message->front() == kEnd) return;
      team.add(cells_of(*message));
      is_asking = false;
    }
    for (EvaluatedCell& done : team.take()) report.done.push_back(std::move(done));
    if (!is_asking) report.wanted = team.wanted();
    const bool is_due = !report.done.empty() && (Clock::now() - last > kSilence || team.is_idle());
    if (report.wanted > 0 || is_due) {
      ranks.send(0, to_bytes(report));
      is_asking = is_asking || report.wanted > 0;
      report = {};
      last = Clock::now();
    }
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace

LedWork::~LedWork() {
  if (!ranks_.is_alone()) let_go();
}

void LedWork::compare(const std::function<std::string()>& digest) {
  if (ranks_.is_alone()) return;
  const std::string own = digest();
  while (!hear_findings()) {
    if (stop_.stop_requested()) throw Interrupted();
    std::this_thread::sleep_for(kPause);
  }
  for (const auto& [rank, found] : findings_) {
    if (!found.fault.empty()) throw std::runtime_error(found.name + ": " + found.fault);
    if (found.digest != own) {
      throw std::runtime_error(found.name + " has another input than " + ranks_.name() +
                               ": a file of its differs, or the program is another");
    }
  }
}

CellSpread LedWork::spread() {
  if (ranks_.is_alone()) return spread_over_threads;
  return [this](const CellWork& work) { spread_over_ranks(work); };
}

void LedWork::spread_over_ranks(const CellWork& work) {
  CellTeam team(work, work.threads);
  Dispenser dispenser(work.cells, ranks_.size());
  tell_all(kBegin);
  is_begun_ = true;
  for (std::size_t entered = 0; entered < work.cells.size();) {
    if (stop_.stop_requested()) throw Interrupted();
    team.add(dispenser.at_most(team.wanted()));
    for (const EvaluatedCell& done : team.take()) {
      work.enter(done.cell, done.value);
      ++entered;
    }
    int heard = 0;
    for (auto message = ranks_.receive(); message; message = ++heard < kMostMessagesAtOnce ? ranks_.receive() : std::nullopt) {
      entered += hear_report(*message, work);
    }
    for (auto asking = asking_.begin(); asking != asking_.end(); asking = asking_.erase(asking)) {
      const auto cells = dispenser.at_most(asking->second);
      if (cells.empty()) break;
      ranks_.send(asking->first, to_bytes(cells));
    }
    if (heard == 0) std::this_thread::sleep_for(kPause);
  }
}

// Whether all others have told what they found.
bool LedWork::hear_findings() {
  while (const auto message = ranks_.receive()) {
    if (message->bytes.front() != kFindings) continue;
    std::string_view bytes(message->bytes);
    bytes.remove_prefix(1);
    const auto text = [&bytes] {
      const std::string word(bytes.substr(0, bytes.find('\0')));
      bytes.remove_prefix(word.size() + 1);
      return word;
    };
    Findings& found = findings_[message->from];
    for (std::string* const part : {&found.name, &found.digest, &found.fault}) *part = text();
  }
  return findings_.size() + 1 == static_cast<std::size_t>(ranks_.size());
}

// Enters the values, and returns how many there were.
std::size_t LedWork::hear_report(const Ranks::Message& message, const CellWork& work) {
  if (message.bytes.front() == kGone) {
    gone_.insert(message.from);
    throw Interrupted();
  }
  const Report report = report_of(message.bytes);
  for (const EvaluatedCell& done : report.done) work.enter(done.cell, done.value);
  if (report.wanted > 0) asking_[message.from] = report.wanted;
  return report.done.size();
}

void LedWork::tell_all(char what) {
  for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, std::string(1, what));
}

void LedWork::let_go() {
  if (is_begun_) tell_all(kEnd);
  const auto all_are_through = [this] {
    if (!is_begun_) return hear_findings();
    while (const auto message = ranks_.receive()) {
      if (message->bytes.front() == kGone) gone_.insert(message->from);
    }
    return gone_.size() + 1 == static_cast<std::size_t>(ranks_.size());
  };
  Clock::time_point end = Clock::now() + kPatience;
  while (!all_are_through() && Clock::now() < end) {
    if (!stop_.stop_requested()) end = Clock::now() + kPatience;
    std::this_thread::sleep_for(kPause);
  }
  tell_all(kLeave);
}

bool is_wanted(Ranks& ranks, const std::function<std::string()>& read) {
  std::string digest, fault;
  try {
    digest = read();
  } catch (const std::exception& error) {
    fault = sentence_of(error);
  }
  std::string bytes(1, kFindings);
  for (const std::string& part : {ranks.name(), digest, fault}) bytes.append(part).push_back('\0');
  ranks.send(0, std::move(bytes));
  return await_the_lead(ranks).front() == kBegin;
}

CellSpread spread_for_the_lead(Ranks& ranks) {
  return [&ranks](const CellWork& work) {
    try {
      work_for_the_lead(ranks, work);
    } catch (const Interrupted&) {
      ranks.send(0, std::string(1, kGone));
      throw;
    }
    ranks.send(0, std::string(1, kGone));
    await_the_lead(ranks);
  };
}

int run_on_ranks(Ranks& ranks, const std::function<int()>& lead, const std::function<void()>& follow) {
  if (ranks.is_alone()) return lead();
  if (ranks.leads()) {
    const int exit_code = run_telling(lead);
    for (int rank = 1; rank < ranks.size(); ++rank) ranks.send(rank, {kQuit, static_cast<char>(exit_code)});
    return exit_code;
  }
  try {
    try {
      follow();
    } catch (const Interrupted&) {
    }
    while (true) await_the_lead(ranks);
  } catch (const Dismissed& dismissed) {
    return dismissed.exit_code;
  } catch (const std::exception& error) {
    std::cerr << ranks.name() + ": " + sentence_of(error) + '\n';
    ranks.abort(kBadInput);
  }
}

}  // namespace alignability::cli

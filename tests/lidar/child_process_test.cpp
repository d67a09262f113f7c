// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/child_process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

namespace alignability::detail {
namespace {

using std::chrono::seconds;

constexpr ChildLimits kAmple{.time = seconds(120), .memory = std::uintmax_t{1} << 30};

TEST(ChildProcess, HandsBackAllBytesHoweverMany) {
  const std::string many(5'000'000, 'x');
  const ChildOutcome outcome = in_child_process([&] { return many + '\0' + "end"; }, kAmple);
  EXPECT_EQ(outcome.fault, "");
  EXPECT_EQ(outcome.bytes, many + '\0' + "end");
}

TEST(ChildProcess, LeavesThisProcessAsItWas) {
  int here = 1;
  EXPECT_EQ(in_child_process([&] { return std::to_string(++here); }, kAmple).bytes, "2");
  EXPECT_EQ(here, 1);
}

TEST(ChildProcess, OutlivesACrash) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGKILL}) {
    const ChildOutcome outcome = in_child_process(
        [&]() -> std::string {
          ::raise(signal);
          return "unharmed";
        },
        kAmple);
    EXPECT_EQ(outcome.fault, "crashed") << signal;
    EXPECT_EQ(outcome.bytes, "");
  }
}

TEST(ChildProcess, TakesAnExceptionForACrash) {
  const auto work = []() -> std::string { throw std::runtime_error("no"); };
  EXPECT_EQ(in_child_process(work, kAmple).fault, "crashed");
}

TEST(ChildProcess, EndsWhatTakesTooLong) {
  const auto work = []() -> std::string {
    for (;;) ::pause();
  };
  EXPECT_EQ(in_child_process(work, {.time = seconds(1), .memory = std::uintmax_t{1} << 30}).fault, "took more than 1 s");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ChildProcess, EndsWhatTakesTooMuchMemory) {
  // Handed back, so that no compiler does without.
  const auto work = [] { return std::string(std::size_t{1} << 30, 'x'); };
  EXPECT_EQ(in_child_process(work, {.time = seconds(120), .memory = std::uintmax_t{100} << 20}).fault,
            "needed more than 100 MiB of memory");
}
#endif

}  // namespace
}  // namespace alignability::detail

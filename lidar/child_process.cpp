// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <new>
#include <system_error>

namespace alignability::detail {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMapsAllMemory = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kMapsAllMemory = true;
#else
constexpr bool kMapsAllMemory = false;
#endif
#else
constexpr bool kMapsAllMemory = false;
#endif

// How a child that could not do its work ends.
constexpr int kOutOfMemory = 3;
constexpr int kFailed = 4;

std::uintmax_t mapped_bytes() {
  std::uintmax_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uintmax_t>(::sysconf(_SC_PAGESIZE));
}

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

void keep_quiet() {
  const int nowhere = ::open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

void write_all(int pipe, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(pipe, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) ::_exit(kFailed);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

// Never comes back, and runs nothing that is left for the parent's end.
[[noreturn]] void be_the_child(int pipe, const std::function<std::string()>& work, std::uintmax_t most) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGTERM, SIG_DFL);
  for (const int crash : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::signal(crash, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const rlimit memory{most, most};
  if (!kMapsAllMemory) ::setrlimit(RLIMIT_AS, &memory);
  keep_quiet();
  try {
    write_all(pipe, work());
  } catch (const std::bad_alloc&) {
    ::_exit(kOutOfMemory);
  } catch (...) {
    ::_exit(kFailed);
  }
  ::_exit(0);
}

// Until the other end is closed; false when it took too long.
bool read_all(int pipe, std::string& bytes, std::chrono::milliseconds time) {
  const Clock::time_point end = Clock::now() + time;
  std::array<char, 1 << 16> part;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    pollfd readable{pipe, POLLIN, 0};
    if (::poll(&readable, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 1000))) <= 0) continue;
    const ssize_t count = ::read(pipe, part.data(), part.size());
    if (count == 0) return true;
    if (count > 0) bytes.append(part.data(), static_cast<std::size_t>(count));
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string fault_of(int status, const ChildLimits& limits) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) {
    return "needed more than " + std::to_string(limits.memory >> 20) + " MiB of memory";
  }
  return "crashed";
}

}  // namespace

ChildOutcome in_child_process(const std::function<std::string()>& work, const ChildLimits& limits) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail("pipe");
  const std::uintmax_t most = mapped_bytes() + limits.memory;
  const pid_t child = ::fork();
  if (child < 0) {
    const int error = errno;
    ::close(pipe[0]);
    ::close(pipe[1]);
    errno = error;
    fail("fork");
  }
  if (child == 0) be_the_child(pipe[1], work, most);
  ::close(pipe[1]);
  ChildOutcome outcome;
  const bool in_time = read_all(pipe[0], outcome.bytes, limits.time);
  ::close(pipe[0]);
  if (!in_time) ::kill(child, SIGKILL);
  const std::string fault = fault_of(wait_for(child), limits);
  outcome.fault = in_time ? fault : "took more than " + std::to_string(limits.time.count() / 1000) + " s";
  if (!outcome.fault.empty()) outcome.bytes.clear();
  return outcome;
}

}  // namespace alignability::detail

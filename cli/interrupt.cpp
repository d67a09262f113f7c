// SPDX-License-Identifier: BSD-3-Clause
#include "cli/interrupt.hpp"

#include <unistd.h>

#include <ctime>

#include "cli/exit_code.hpp"

namespace alignability::cli {

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &previous_);
  waiter_ = std::jthread([this](const std::stop_token& done) { wait(done); });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
}

void Interrupt::wait(const std::stop_token& done) {
  constexpr timespec kPatience{.tv_sec = 0, .tv_nsec = 50'000'000};
  while (!done.stop_requested()) {
    if (sigtimedwait(&signals_, nullptr, &kPatience) < 0) continue;
    if (source_.stop_requested()) ::_exit(kInterrupted);
    source_.request_stop();
  }
}

}  // namespace alignability::cli

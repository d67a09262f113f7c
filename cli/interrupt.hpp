// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace alignability::cli {

/// While it lives, Ctrl-C and SIGTERM ask for a stop instead of ending the program; a second one ends it at once. To be made before
/// other threads are, which inherit that they do not take these signals themselves.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  void wait(const std::stop_token& done);

  std::stop_source source_;
  sigset_t signals_;
  sigset_t previous_;
  std::jthread waiter_;
};

}  // namespace alignability::cli

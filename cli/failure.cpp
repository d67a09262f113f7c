// SPDX-License-Identifier: BSD-3-Clause
#include "cli/failure.hpp"

#include <iostream>
#include <new>

#include "cli/exit_code.hpp"
#include "cli/launcher.hpp"
#include "core/input_error.hpp"
#include "core/progress.hpp"

namespace alignability::cli {
namespace {

void tell(const std::string& sentence) {
  const auto launch = launched();
  if (!launch || launch->rank == 0) std::cerr << sentence << '\n';
}

}  // namespace

std::string sentence_of(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : error.what();
}

int run_telling(const std::function<int()>& work) {
  try {
    return work();
  } catch (const Interrupted&) {
    tell("\nalignability: interrupted; no file was changed");
    return kInterrupted;
  } catch (const InputError& error) {
    tell(error.what());
  } catch (const std::exception& error) {
    tell("alignability: " + sentence_of(error));
  }
  return kBadInput;
}

}  // namespace alignability::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/input_error.hpp"

namespace alignability::test {

/// What the InputError says that `action` throws; a failure of the test, and "", when it throws none or something else.
template <typename Action>
std::string thrown_message(Action&& action) {
  try {
    action();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const InputError& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not an InputError: " << error.what();
  }
  return {};
}

}  // namespace alignability::test

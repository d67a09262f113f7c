// SPDX-License-Identifier: BSD-3-Clause
#include "cli/launcher.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace alignability::cli {
namespace {

std::optional<int> number_in_environment(const char* name) {
  const char* const text = std::getenv(name);
  if (text == nullptr) return std::nullopt;
  const std::string_view digits(text);
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc{} && end == digits.data() + digits.size() && value >= 0 ? std::optional(value) : std::nullopt;
}

template <std::size_t N>
std::optional<int> first_in_environment(const std::array<const char*, N>& names) {
  for (const char* name : names) {
    if (const auto value = number_in_environment(name)) return value;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Launch> launched() {
  const auto rank = first_in_environment(std::array{"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"});
  if (!rank) return std::nullopt;
  return Launch{*rank, first_in_environment(std::array{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"})};
}

void refuse_several_processes(const std::string& what) {
  const auto launch = launched();
  if (!launch || launch->processes.value_or(1) == 1) return;
  throw std::runtime_error(what + " is the work of one process, and " + std::to_string(*launch->processes) +
                           " were started; run it without mpirun or srun, or with one");
}

}  // namespace alignability::cli

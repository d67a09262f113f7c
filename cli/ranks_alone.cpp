// SPDX-License-Identifier: BSD-3-Clause
// Ranks of a program that was built without MPI: one.
#include <cstdlib>
#include <stdexcept>

#include "cli/launcher.hpp"
#include "cli/ranks.hpp"

namespace alignability::cli {

struct Ranks::Connection {};

Ranks::Ranks() {
  const auto launch = launched();
  if (launch && launch->processes.value_or(1) > 1) {
    throw std::runtime_error(std::to_string(*launch->processes) + " processes were started, and this program was built without MPI");
  }
}

Ranks::~Ranks() = default;

int Ranks::rank() const { return 0; }

int Ranks::size() const { return 1; }

std::string Ranks::name() const { return "rank 0"; }

int Ranks::processors() const { return 1; }

void Ranks::send(int, std::string) { throw std::logic_error("there is no other rank"); }

std::optional<Ranks::Message> Ranks::receive() { return std::nullopt; }

void Ranks::abort(int exit_code) { std::_Exit(exit_code); }

}  // namespace alignability::cli

// SPDX-License-Identifier: BSD-3-Clause
// Ranks by MPI, in the only file that includes its headers.
#include <sched.h>

#include <algorithm>
#include <array>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <cstdlib>
#include <list>
#include <stdexcept>
#include <utility>

#include "cli/launcher.hpp"
#include "cli/ranks.hpp"

namespace alignability::cli {
namespace {

namespace mpi = boost::mpi;

constexpr int kTag = 0;

// A processor counts for each rank that may run on it in equal parts.
int share_of_processors(const mpi::communicator& world) {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(world, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  cpu_set_t bound;
  CPU_ZERO(&bound);
  ::sched_getaffinity(0, sizeof bound, &bound);
  std::array<int, CPU_SETSIZE> takers{};
  for (std::size_t i = 0; i < takers.size(); ++i) takers[i] = CPU_ISSET(i, &bound) ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, takers.data(), CPU_SETSIZE, MPI_INT, MPI_SUM, machine);
  MPI_Comm_free(&machine);
  constexpr double kRounding = 1e-9;
  double share = kRounding;
  for (std::size_t i = 0; i < takers.size(); ++i) {
    if (CPU_ISSET(i, &bound)) share += 1.0 / takers[i];
  }
  return std::max(1, static_cast<int>(share));
}

}  // namespace

struct Ranks::Connection {
  // Bytes stay where they are until they have left.
  struct Outgoing {
    std::string bytes;
    mpi::request request;
  };

  void forget_what_has_left() {
    outgoing.remove_if([](Outgoing& message) { return message.request.test().has_value(); });
  }

  mpi::environment environment{mpi::threading::funneled, false};
  mpi::communicator world;
  std::list<Outgoing> outgoing;
  int processors = 1;
};

Ranks::Ranks() {
  const auto launch = launched();
  if (!launch) return;
  connection_ = std::make_unique<Connection>();
  if (launch->processes && *launch->processes != size()) {
    throw std::runtime_error("the launcher started " + std::to_string(*launch->processes) + " processes, of which MPI finds " +
                             std::to_string(size()) + "; srun takes --mpi=pmix, mpirun must be the one of this program's MPI");
  }
  connection_->processors = share_of_processors(connection_->world);
}

Ranks::~Ranks() {
  while (connection_ && !connection_->outgoing.empty()) connection_->forget_what_has_left();
}

int Ranks::rank() const { return connection_ ? connection_->world.rank() : 0; }

int Ranks::size() const { return connection_ ? connection_->world.size() : 1; }

std::string Ranks::name() const { return "rank " + std::to_string(rank()) + " on " + mpi::environment::processor_name(); }

int Ranks::processors() const { return connection_->processors; }

void Ranks::send(int to, std::string bytes) {
  connection_->forget_what_has_left();
  auto& message = connection_->outgoing.emplace_back(Connection::Outgoing{std::move(bytes), {}});
  message.request = connection_->world.isend(to, kTag, message.bytes.data(), static_cast<int>(message.bytes.size()));
}

std::optional<Ranks::Message> Ranks::receive() {
  connection_->forget_what_has_left();
  const auto status = connection_->world.iprobe(mpi::any_source, kTag);
  if (!status) return std::nullopt;
  Message message{status->source(), std::string(static_cast<std::size_t>(status->count<char>().value_or(0)), '\0')};
  connection_->world.recv(message.from, kTag, message.bytes.data(), static_cast<int>(message.bytes.size()));
  return message;
}

void Ranks::abort(int exit_code) {
  mpi::environment::abort(exit_code);
  std::_Exit(exit_code);
}

}  // namespace alignability::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace alignability::cli {

/// The processes that a launcher such as mpirun or srun started together, of which this is one. Without a launcher it is alone, and MPI is
/// not touched. To be used by the main thread alone, and made after the Interrupt, whose signals MPI's own threads must not take.
class Ranks {
 public:
  struct Message {
    int from = 0;
    std::string bytes;
  };

  /// Throws std::runtime_error where a launcher started several that cannot find one another.
  Ranks();
  /// Waits for the others to be done too.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const;
  int size() const;
  bool is_alone() const { return size() == 1; }
  bool leads() const { return rank() == 0; }
  /// "rank 1 on node7".
  std::string name() const;
  /// How many threads this rank may run: the processors that it is bound to, shared out where other ranks of its machine are bound to them
  /// too; at least 1.
  int processors() const;

  /// Never waits.
  void send(int to, std::string bytes);
  /// The next message, if there is one; those of one rank come in the order in which it sent them. Never waits.
  std::optional<Message> receive();
  /// Ends the whole job at once.
  [[noreturn]] void abort(int exit_code);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;  // none when alone
};

}  // namespace alignability::cli

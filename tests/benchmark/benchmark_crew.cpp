// SPDX-License-Identifier: BSD-3-Clause
// benchmark_crew CELLS MILLISECONDS THREADS, under mpirun: what it takes rank 0 to share so many cells between ranks of so many threads
// each, when a cell takes so long: its main thread's processor time, checkpoint included. Cells sleep, so that one machine stands for many.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <thread>

#include "alignability/checkpoint.hpp"
#include "cli/crew.hpp"

namespace alignability::cli {
namespace {

constexpr std::size_t kLayers = 6;

double seconds_of(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Load {
  std::size_t cells;
  double milliseconds;
  int threads;
};

CellWork work_of(const Load& load, std::span<const std::size_t> cells, detail::Checkpoint* checkpoint) {
  const std::chrono::duration<double, std::milli> pause(load.milliseconds);
  return {.cells = cells,
          .evaluate =
              [pause](std::size_t cell) {
                if (pause.count() > 0.0) std::this_thread::sleep_for(pause);
                return CellValue(kLayers, static_cast<float>(cell));
              },
          .enter = [checkpoint](std::size_t cell, const CellValue& value) { checkpoint->append(cell, value); },
          .threads = load.threads,
          .stop = {}};
}

int lead(Ranks& ranks, const Load& load) {
  std::vector<std::size_t> cells(load.cells);
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const auto file = std::filesystem::temp_directory_path() / ("benchmark_crew-" + std::to_string(::getpid()));
  {
    detail::Checkpoint checkpoint(file, 1, kLayers);
    LedWork led(ranks, {});
    led.compare([] { return std::string("the same"); });
    const double wall = seconds_of(CLOCK_MONOTONIC), own = seconds_of(CLOCK_THREAD_CPUTIME_ID);
    led.spread()(work_of(load, cells, &checkpoint));
    const double wall_spent = seconds_of(CLOCK_MONOTONIC) - wall, own_spent = seconds_of(CLOCK_THREAD_CPUTIME_ID) - own;
    const auto count = static_cast<double>(load.cells);
    const double ideal = 1e-3 * load.milliseconds * count / (load.threads * ranks.size());
    std::printf("%zu cells of %g ms, %d ranks of %d threads: %.3f s (no less than %.3f s), coordination %.3f s, %.2f us a cell", load.cells,
                load.milliseconds, ranks.size(), load.threads, wall_spent, ideal, own_spent, 1e6 * own_spent / count);
    if (load.milliseconds > 0.0) std::printf(", %.4f %% of the work", 100.0 * own_spent / (1e-3 * load.milliseconds * count));
    std::printf("\n");
  }
  std::filesystem::remove(file);
  return 0;
}

void follow(Ranks& ranks, const Load& load) {
  if (is_wanted(ranks, [] { return std::string("the same"); })) spread_for_the_lead(ranks)(work_of(load, {}, nullptr));
}

}  // namespace
}  // namespace alignability::cli

int main(int argc, char** argv) {
  using namespace alignability::cli;
  if (argc != 4) {
    std::fprintf(stderr, "usage: mpirun -n RANKS %s CELLS MILLISECONDS THREADS\n", argv[0]);
    return 2;
  }
  const Load load{std::strtoul(argv[1], nullptr, 10), std::strtod(argv[2], nullptr), std::atoi(argv[3])};
  Ranks ranks;
  return run_on_ranks(
      ranks, [&] { return lead(ranks, load); }, [&] { follow(ranks, load); });
}

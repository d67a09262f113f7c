// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/in_parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace alignability {

void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  tbb::task_group_context context(tbb::task_group_context::isolated,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  context.capture_fp_settings();
  const auto work_range = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
  };
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), work_range, tbb::simple_partitioner(), context); });
}

}  // namespace alignability

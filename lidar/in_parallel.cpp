// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/in_parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#if defined(ALIGNABILITY_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace alignability {
namespace {

// What one thread did before `give` has happened for those that `take` after it. oneTBB sees to that; but as Debian has it, it is built
// without ThreadSanitizer, which must be told; this file is built without it too, for it has oneTBB's templates.
class HandOver {
 public:
#if defined(ALIGNABILITY_THREAD_SANITIZER)
  void give() { __tsan_release(this); }
  void take() { __tsan_acquire(this); }
#else
  void give() {}
  void take() {}
#endif
};

// At the end of a scope, by an exception too.
class GivesAtEnd {
 public:
  explicit GivesAtEnd(HandOver& what) : what_(what) {}
  ~GivesAtEnd() { what_.give(); }

 private:
  HandOver& what_;
};

class TakesAtEnd {
 public:
  explicit TakesAtEnd(HandOver& what) : what_(what) {}
  ~TakesAtEnd() { what_.take(); }

 private:
  HandOver& what_;
};

}  // namespace

void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  tbb::task_group_context context(tbb::task_group_context::isolated,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  context.capture_fp_settings();
  HandOver begun, ended;
  const auto work_range = [&](const tbb::blocked_range<std::size_t>& range) {
    begun.take();
    const GivesAtEnd gives(ended);
    for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
  };
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  begun.give();
  const TakesAtEnd takes(ended);
  arena.execute([&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), work_range, tbb::simple_partitioner(), context); });
}

}  // namespace alignability

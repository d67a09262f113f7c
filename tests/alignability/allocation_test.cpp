// SPDX-License-Identifier: BSD-3-Clause
// How often memory is asked for. Sanitizers bring an operator new of their own.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "alignability/alignability.hpp"
#include "tests/alignability/simulated.hpp"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {
std::atomic<long> allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace alignability {
namespace {

TEST(Scorer, AsksForNoMemoryOnceItHasSeenALargerScan) {
  const Scan corridor = test::scan_of(test::plain_corridor(), NoiseKey{.seed = 1});
  const Scan floor = test::scan_of(test::floor_and({}), NoiseKey{.seed = 2});
  Scan unordered = floor;
  unordered.columns *= unordered.rings;
  unordered.rings = 1;
  const Scan& shuffled = unordered;
  for (const int stride : {1, 4}) {
    AlignabilityOptions options;
    options.segmentation.stride = stride;
    Scorer scorer(options);
    for (const Scan* scan : {&shuffled, &corridor, &floor}) scorer.alignability(*scan);
    for (const Scan* scan : {&corridor, &floor, &shuffled}) {
      const long before = allocations;
      scorer.alignability(*scan);
      EXPECT_EQ(allocations - before, 0) << "stride " << stride << ", " << scan->rings << " rings";
    }
  }
}

}  // namespace
}  // namespace alignability

#endif

// SPDX-License-Identifier: BSD-3-Clause
// A libFuzzer program for the reader whose name it is built with.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tests/fuzz/readers.hpp"

namespace {

const alignability::test::FuzzedReader& reader() {
  for (const auto& reader : alignability::test::fuzzed_readers()) {
    if (std::string_view(reader.name) == ALIGNABILITY_READER) return reader;
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const alignability::test::FuzzedFile file(reader());
  file.read({reinterpret_cast<const char*>(data), size});
  return 0;
}

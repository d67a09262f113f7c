// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace alignability::test {

/// A reader of files from elsewhere, which must take any bytes for what they are or throw InputError.
struct FuzzedReader {
  const char* name;       ///< of its corpus: tests/fuzz/seeds/NAME
  const char* extension;  ///< that the file is given
  void (*read)(const std::filesystem::path& file);
  /// Puts beside the file what it names, or what names it.
  void (*prepare)(const std::filesystem::path& folder) = [](const std::filesystem::path&) {};
};

std::span<const FuzzedReader> fuzzed_readers();

/// Has the bytes read as a file of an own folder. Whatever but InputError the reader throws comes out.
class FuzzedFile {
 public:
  explicit FuzzedFile(const FuzzedReader& reader);
  ~FuzzedFile();
  FuzzedFile(const FuzzedFile&) = delete;
  FuzzedFile& operator=(const FuzzedFile&) = delete;

  /// Whether the bytes were taken for a file of that kind.
  bool read(std::string_view bytes) const;

 private:
  const FuzzedReader& reader_;
  std::filesystem::path folder_;
  std::filesystem::path file_;
};

}  // namespace alignability::test

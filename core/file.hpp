// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace alignability {

/// The bytes of a regular file. Throws InputError when it cannot be read or is larger than `largest`, before allocating.
std::string read_file(const std::filesystem::path& file, std::uintmax_t largest);

/// A file that is there whole or not at all: written beside its place under a temporary name and renamed by `commit()`. Without a
/// commit the temporary is removed and what stood in the place stays.
class AtomicFile {
 public:
  /// Creates the empty temporary. Throws InputError naming `target` when that cannot be done.
  explicit AtomicFile(std::filesystem::path target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write until the commit, for libraries that open files by name.
  const std::filesystem::path& temporary() const { return temporary_; }
  void write(std::string_view bytes);
  /// Puts the file in its place, its bytes on the disk first. Throws InputError when that cannot be done.
  void commit();

 private:
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

void write_file(const std::filesystem::path& target, std::string_view bytes);

}  // namespace alignability

// SPDX-License-Identifier: BSD-3-Clause
#include "core/file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/input_error.hpp"

namespace alignability {
namespace {

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags) : value_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return value_; }
  bool ok() const { return value_ >= 0; }

 private:
  int value_;
};

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path temporary_beside(const std::filesystem::path& target) {
  static std::atomic<unsigned> counter{0};
  return folder_of(target) /
         ("." + target.filename().string() + "." + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part");
}

}  // namespace

std::string read_file(const std::filesystem::path& file, std::uintmax_t largest) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(file, "no such file");
  if (!std::filesystem::is_regular_file(status)) throw InputError(file, "not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw InputError(file, "cannot be read: " + error.message());
  if (size > largest) {
    throw InputError(file, "is " + std::to_string(size) + " bytes long; at most " + std::to_string(largest) + " are read");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!stream) throw InputError(file, "cannot be read");
  return bytes;
}

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)), temporary_(temporary_beside(target_)) {
  if (!Descriptor(temporary_, O_WRONLY | O_CREAT | O_EXCL).ok()) fail(errno);
}

AtomicFile::~AtomicFile() {
  if (!committed_) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  const Descriptor file(temporary_, O_WRONLY | O_APPEND);
  if (!file.ok()) fail(errno);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  {
    const Descriptor file(temporary_, O_RDONLY);
    if (!file.ok() || ::fsync(file.get()) != 0) fail(errno);
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  committed_ = true;
  // The rename itself is lost with the power if the folder is not synced; some file systems cannot sync one, and that is no failure.
  const Descriptor folder(folder_of(target_), O_RDONLY | O_DIRECTORY);
  if (folder.ok()) ::fsync(folder.get());
}

void AtomicFile::fail(int error_number) const {
  throw InputError(target_, std::string("cannot be written: ") + std::strerror(error_number));
}

void write_file(const std::filesystem::path& target, std::string_view bytes) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit();
}

}  // namespace alignability

// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/checkpoint.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/file.hpp"
#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

using Crc32 = boost::crc_32_type;
using Crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xffffffffffffffff, 0xffffffffffffffff, true, true>;

constexpr std::string_view kMagic = "alignability checkpoint 1\n";
constexpr std::uintmax_t kLargest = std::uintmax_t{1} << 32;

struct Record {
  std::uint64_t cell;
  std::array<float, 6> values;
  std::uint32_t padding;  // none is left to the compiler
  std::uint32_t checksum;
};
static_assert(sizeof(Record) == 40);

std::uint32_t checksum_of(const Record& record) {
  Crc32 crc;
  crc.process_bytes(&record, offsetof(Record, checksum));
  return crc.checksum();
}

Record record_of(std::size_t cell, const CellValue& value) {
  Record record{.cell = cell,
                .values = {value.alpha, value.samples, value.iqr, value.weakest.x(), value.weakest.y(), value.weakest.z()},
                .padding = 0,
                .checksum = 0};
  record.checksum = checksum_of(record);
  return record;
}

std::string header_of(std::uint64_t fingerprint) {
  std::string header(kMagic);
  header.append(reinterpret_cast<const char*>(&fingerprint), sizeof fingerprint);
  return header;
}

bool write_whole(int descriptor, const void* bytes, std::size_t size) {
  return ::write(descriptor, bytes, size) == static_cast<::ssize_t>(size);
}

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, std::uint64_t fingerprint) : file_(std::move(file)) {
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) throw InputError(file_, "is held by another build that is under way");
    const std::string bytes = read_file(file_, kLargest);
    const std::string header = header_of(fingerprint);
    if (!bytes.empty() && !std::string_view(bytes).starts_with(kMagic.substr(0, bytes.size()))) {
      throw InputError(file_, "is not a checkpoint of ours; remove it or choose another name");
    }
    if (bytes.size() > header.size() && !bytes.starts_with(header)) {
      throw InputError(file_, "holds cells of another build, of another site, sensor, options or version; remove it to build anew");
    }
    if (bytes.starts_with(header)) read_records(bytes.substr(header.size()));
    const std::size_t keep = found_.empty() ? 0 : header.size() + found_.size() * sizeof(Record);
    if (::ftruncate(descriptor_, static_cast<::off_t>(keep)) != 0) fail(errno);
    if (keep == 0 && !write_whole(descriptor_, header.data(), header.size())) fail(errno);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Checkpoint::~Checkpoint() { ::close(descriptor_); }

// Up to the first that is not whole.
void Checkpoint::read_records(const std::string& bytes) {
  for (std::size_t at = 0; at + sizeof(Record) <= bytes.size(); at += sizeof(Record)) {
    Record record;
    std::memcpy(&record, bytes.data() + at, sizeof record);
    if (record.checksum != checksum_of(record)) return;
    const auto& [alpha, samples, iqr, x, y, z] = record.values;
    if (!found_.try_emplace(record.cell, CellValue{alpha, samples, iqr, {x, y, z}}).second) return;
  }
}

void Checkpoint::append(std::size_t cell, const CellValue& value) {
  const Record record = record_of(cell, value);
  if (!write_whole(descriptor_, &record, sizeof record)) fail(errno);
}

void Checkpoint::fail(int error_number) const { throw InputError(file_, std::string("cannot be written: ") + std::strerror(error_number)); }

std::uint64_t fingerprint(const Scene& scene, const OccupancyMap& occupancy, const LidarModel& lidar, const std::string& options,
                          std::uint64_t seed) {
  Crc64 crc;
  const auto add = [&crc](const auto* values, std::size_t count) {
    const std::uint64_t size = count * sizeof *values;
    crc.process_bytes(&size, sizeof size);
    if (size > 0) crc.process_bytes(values, size);
  };
  for (const TriangleMesh& mesh : scene.meshes()) {
    add(mesh.vertices.data(), mesh.vertices.size());
    add(mesh.triangles.data(), mesh.triangles.size());
  }
  const GridGeometry& grid = occupancy.geometry();
  const std::array<double, 5> place{grid.resolution, grid.origin.x(), grid.origin.y(), static_cast<double>(grid.width),
                                    static_cast<double>(grid.height)};
  add(place.data(), place.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const float value = occupancy.occupancy(grid.cell_of(i)).value_or(-1.0f);
    crc.process_bytes(&value, sizeof value);
  }
  add(lidar.elevations.data(), lidar.elevations.size());
  const std::array<double, 6> beams{lidar.azimuth_min, lidar.azimuth_max, static_cast<double>(lidar.columns),
                                    lidar.range_min,   lidar.range_max,   lidar.range_stddev};
  add(beams.data(), beams.size());
  add(lidar.T_base_lidar.data(), 16);
  constexpr std::string_view kVersion = ALIGNABILITY_VERSION;
  for (const std::string_view text : {std::string_view(options), kVersion}) add(text.data(), text.size());
  add(&seed, 1);
  return crc.checksum();
}

}  // namespace alignability::detail

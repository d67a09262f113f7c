// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/checkpoint.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/file.hpp"
#include "core/input_error.hpp"

namespace alignability::detail {
namespace {

using Crc32 = boost::crc_32_type;
using Crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xffffffffffffffff, 0xffffffffffffffff, true, true>;

constexpr std::string_view kMagic = "alignability checkpoint 2\n";
constexpr std::uintmax_t kLargest = std::uintmax_t{1} << 32;

// A record: the cell, its values, a checksum.
using Checksum = std::uint32_t;

std::size_t record_size(std::size_t values) { return sizeof(std::uint64_t) + values * sizeof(float) + sizeof(Checksum); }

Checksum checksum_of(std::string_view bytes) {
  Crc32 crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

template <typename T>
void append_bytes(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
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

Checkpoint::Checkpoint(std::filesystem::path file, std::uint64_t fingerprint, std::size_t values)
    : file_(std::move(file)), values_(values) {
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
    const std::size_t keep = found_.empty() ? 0 : header.size() + found_.size() * record_size(values_);
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
  const std::size_t size = record_size(values_);
  for (std::size_t at = 0; at + size <= bytes.size(); at += size) {
    const std::string_view record = std::string_view(bytes).substr(at, size);
    Checksum checksum = 0;
    std::memcpy(&checksum, record.data() + size - sizeof checksum, sizeof checksum);
    if (checksum != checksum_of(record.substr(0, size - sizeof checksum))) return;
    std::uint64_t cell = 0;
    CellValue value(values_);
    std::memcpy(&cell, record.data(), sizeof cell);
    std::memcpy(value.data(), record.data() + sizeof cell, values_ * sizeof(float));
    if (!found_.try_emplace(cell, std::move(value)).second) return;
  }
}

void Checkpoint::append(std::size_t cell, const CellValue& value) {
  std::string record;
  const std::uint64_t number = cell;
  append_bytes(record, &number, 1);
  append_bytes(record, value.data(), value.size());
  const Checksum checksum = checksum_of(record);
  append_bytes(record, &checksum, 1);
  if (!write_whole(descriptor_, record.data(), record.size())) fail(errno);
}

void Checkpoint::fail(int error_number) const { throw InputError(file_, std::string("cannot be written: ") + std::strerror(error_number)); }

std::uint64_t fingerprint(const Scene& scene, const OccupancyMap& occupancy, const SensorRig& sensor, const std::string& options,
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
  const DiscCloud& discs = scene.discs();
  if (!discs.empty()) {
    add(discs.centers.data(), discs.size());
    add(discs.normals.data(), discs.size());
    add(discs.radii.data(), discs.size());
  }
  const GridGeometry& grid = occupancy.geometry();
  const std::array<double, 5> place{grid.resolution, grid.origin.x(), grid.origin.y(), static_cast<double>(grid.width),
                                    static_cast<double>(grid.height)};
  add(place.data(), place.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const float value = occupancy.occupancy(grid.cell_of(i)).value_or(-1.0f);
    crc.process_bytes(&value, sizeof value);
  }
  for (const LidarModel& lidar : sensor.lidars) {
    add(lidar.elevations.data(), lidar.elevations.size());
    add(lidar.azimuth_offsets.data(), lidar.azimuth_offsets.size());
    for (const AzimuthSector& sector : lidar.sectors) {
      const std::array<double, 3> azimuths{sector.min, sector.max, static_cast<double>(sector.columns)};
      add(azimuths.data(), azimuths.size());
    }
    const std::array<double, 3> ranges{lidar.range_min, lidar.range_max, lidar.range_stddev};
    add(ranges.data(), ranges.size());
    add(lidar.T_base_lidar.data(), 16);
  }
  constexpr std::string_view kVersion = ALIGNABILITY_VERSION;
  for (const std::string_view text : {std::string_view(options), kVersion}) add(text.data(), text.size());
  add(&seed, 1);
  return crc.checksum();
}

}  // namespace alignability::detail

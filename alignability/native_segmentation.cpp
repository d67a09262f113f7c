// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "alignability/segmentation_engines.hpp"

namespace alignability::detail {

const Segmentation& NativeSegmenter::segment(const Scan& scan, const SegmentationOptions& options) {
  blocks_.assign(scan, options.range_min);
  result_.points = blocks_.points();
  result_.normals.assign(scan.points.size(), Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  result_.members.clear();
  result_.ends.clear();
  if (blocks_.points() < static_cast<std::size_t>(std::max(options.min_points, 3))) return result_;

  estimate(scan, options);
  grower_.grow(graph_, {.cosine = static_cast<float>(std::cos(options.smoothness)),
                        .curvature = static_cast<float>(options.curvature),
                        .min_points = (options.min_points + options.stride - 1) / options.stride});
  for (const std::int32_t voter : grower_.members()) {
    const auto slot = static_cast<std::size_t>(slot_of_voter_[static_cast<std::size_t>(voter)]);
    result_.members.push_back(blocks_.scan_index()[slot]);
  }
  result_.ends = grower_.ends();
  return result_;
}

// Normals and links of every point that votes.
void NativeSegmenter::estimate(const Scan& scan, const SegmentationOptions& options) {
  number_voters(scan, options.stride);
  const int points = static_cast<int>(blocks_.points());
  const int neighbours = std::min(options.normal_neighbours, points);
  graph_.most_links = options.stride == 1 ? std::min(options.growing_neighbours, points) : neighbours;
  graph_.normals.resize(slot_of_voter_.size());
  graph_.links.resize(slot_of_voter_.size() * static_cast<std::size_t>(graph_.most_links));
  graph_.links_of.resize(slot_of_voter_.size());
  batch_.begin(neighbours);
  nearest_.assign(blocks_);
  for (std::size_t voter = 0; voter < slot_of_voter_.size(); ++voter) {
    const auto found = nearest_.search(slot_of_voter_[voter], std::max(neighbours, graph_.most_links));
    link(voter, found.first(static_cast<std::size_t>(graph_.most_links)));
    if (batch_.add(blocks_, slot_of_voter_[voter], found.first(static_cast<std::size_t>(neighbours)))) take_normals(scan);
  }
  take_normals(scan);
}

void NativeSegmenter::number_voters(const Scan& scan, int stride) {
  const std::vector<std::int32_t>& index = blocks_.scan_index();
  slot_of_voter_.clear();
  voter_of_slot_.assign(index.size(), -1);
  for (std::size_t slot = 0; slot < index.size(); ++slot) {
    if (index[slot] < 0) continue;
    const int place = scan.organized() ? index[slot] % scan.columns : static_cast<int>(slot);
    if (place % stride != 0) continue;
    voter_of_slot_[slot] = static_cast<std::int32_t>(slot_of_voter_.size());
    slot_of_voter_.push_back(static_cast<std::int32_t>(slot));
  }
}

void NativeSegmenter::link(std::size_t voter, std::span<const std::int32_t> nearest) {
  std::int32_t* links = graph_.links.data() + voter * static_cast<std::size_t>(graph_.most_links);
  std::int32_t count = 0;
  for (const std::int32_t slot : nearest) {
    const std::int32_t other = voter_of_slot_[static_cast<std::size_t>(slot)];
    links[count] = other;
    count += other >= 0 ? 1 : 0;
  }
  graph_.links_of[voter] = count;
}

void NativeSegmenter::take_normals(const Scan& scan) {
  for (const NormalBatch::Estimate& estimate : batch_.finish()) {
    const auto slot = static_cast<std::size_t>(estimate.slot);
    const auto i = static_cast<std::size_t>(blocks_.scan_index()[slot]);
    Eigen::Vector3f normal(estimate.normal[0], estimate.normal[1], estimate.normal[2]);
    if (normal.dot(scan.points[i]) > 0.0f) normal = -normal;
    result_.normals[i] = normal;
    graph_.normals[static_cast<std::size_t>(voter_of_slot_[slot])] = {normal.x(), normal.y(), normal.z(), estimate.curvature};
  }
}

}  // namespace alignability::detail

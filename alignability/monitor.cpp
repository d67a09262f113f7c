// SPDX-License-Identifier: BSD-3-Clause
#include "alignability/monitor.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/range.hpp"
#include "costmap/heading_layers.hpp"
#include "lidar/scan_log.hpp"

namespace alignability {

Monitor::Monitor(const AlignabilityMap& map, const MonitorOptions& options) : options_(options), scorer_(options.alignability) {
  if (!kShare.contains(options.margin)) throw std::invalid_argument("the margin must be from 0 to 1");
  if (options.range_max && !kPositive.contains(*options.range_max)) throw std::invalid_argument("range_max must be greater than 0");
  for (const Grid<float>* layer : heading_layers(map)) alpha_.push_back(*layer);
  if (alpha_.empty()) alpha_.push_back(map.alpha());
}

double Monitor::expected_at(const Pose2& base) const {
  const Grid<float>& alpha = alpha_[nearest_heading(base.yaw, alpha_.size())];
  const std::optional<Cell> cell = alpha.geometry().cell_near(base.position());
  return cell ? alpha[*cell] : std::numeric_limits<double>::quiet_NaN();
}

MonitorReading Monitor::update(const Scan& scan, const Pose2& base, double stamp) {
  MonitorReading reading;
  reading.expected = expected_at(base);
  reading.seen = scorer_.alignability(options_.range_max ? cropped(scan, *options_.range_max) : scan).alpha;
  reading.lower = reading.expected - reading.seen;
  if (std::isnan(reading.lower)) return reading;
  if (reading.lower < options_.margin) {
    low_since_.reset();
    sum_ = 0.0;
    count_ = 0;
    return reading;
  }
  if (!low_since_) low_since_ = stamp;
  sum_ += reading.lower;
  ++count_;
  reading.low_since = low_since_;
  reading.lower_in_mean = sum_ / count_;
  return reading;
}

}  // namespace alignability

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "alignability/alignability.hpp"
#include "core/pose.hpp"
#include "costmap/alignability_map.hpp"

namespace alignability {

struct MonitorOptions {
  AlignabilityOptions alignability = {};  ///< as the map was made: `for_lidar` puts the sensor's part in
  std::optional<double> range_max = {};   ///< [m] likewise
  double margin = 0.1;                    ///< a scan this much below the map is low; more than the map's iqr, in [0, 1]
};

/// What one scan says of the map.
struct MonitorReading {
  double expected = 0.0;            ///< α of the map's cell, at the heading next to the robot's; NaN off the map and where it has none
  double seen = 0.0;                ///< α of the scan
  double lower = 0.0;               ///< expected - seen; NaN with expected
  std::optional<double> low_since;  ///< stamp of the first of the low scans that end with this one; nullopt where this one is not low
  double lower_in_mean = 0.0;       ///< over these; 0 without any
};

/// Compares live scans with the map while driving. A run of low scans tells that the site has changed, that the robot is not where it
/// thinks it is, or that the lidar sees less than the one of the map. A scan where the map has no value neither begins nor ends a run. One
/// scan costs what scoring it costs. Not for several threads at once.
class Monitor {
 public:
  /// Throws std::invalid_argument for a margin out of range and options that no scan could be scored with.
  Monitor(const AlignabilityMap& map, const MonitorOptions& options);

  /// The scan as `score` takes it, `base_link` in `map`, and when [s], not before the last.
  MonitorReading update(const Scan& scan, const Pose2& base, double stamp);

 private:
  double expected_at(const Pose2& base) const;

  std::vector<Grid<float>> alpha_;  // one, or one a heading
  MonitorOptions options_;
  Scorer scorer_;
  std::optional<double> low_since_;
  double sum_ = 0.0;
  int count_ = 0;
};

}  // namespace alignability

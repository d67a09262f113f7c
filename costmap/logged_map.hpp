// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "costmap/alignability_map.hpp"

namespace alignability {

/// Whether a map's values are from recorded scans alone: its provenance begins with the log that they are from.
inline bool is_logged(const AlignabilityMap& map) { return map.provenance.starts_with("log: "); }

}  // namespace alignability

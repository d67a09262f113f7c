// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/yaml_map.hpp"
#include "lidar/lidar_model.hpp"

namespace alignability::detail {

/// One lidar's keys: those of a sensor file, or of an entry of `lidars`. Its `yaml` stays empty.
LidarModel read_lidar(YamlMap map);

}  // namespace alignability::detail

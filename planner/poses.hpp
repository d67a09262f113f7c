// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/StateSpace.h>

#include "core/pose.hpp"

namespace alignability {

/// Whether the states of a space have a heading: SE(2) does, R² does not.
bool has_heading(const ompl::base::StateSpace& space);

/// Writes a pose into a state of R² (without its yaw) or SE(2).
void set_pose(const ompl::base::StateSpace& space, const Pose2& pose, ompl::base::State* state);

}  // namespace alignability

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

#include <functional>

#include "core/pose.hpp"

namespace alignability {

/// Where `base_link` is in `map` when the system is in a state. Called from many threads at once.
using StateProjection = std::function<Pose2(const ompl::base::State*)>;

/// The projection of R² (yaw 0) or SE(2). Throws ompl::Exception for other spaces: pass a projection of your own there.
StateProjection projection_of(const ompl::base::StateSpacePtr& space);

}  // namespace alignability

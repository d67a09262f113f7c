// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// For a test: what the reference must refuse.
namespace alignability {

/// Twice a number. See \ref nowhere.
/// \param height is none of its parameters
double twice(double width);

}  // namespace alignability

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "alignability/readings.hpp"

namespace alignability::cli {

/// What a reading has to say, in a few words.
std::string reading_text(Reading reading, const Readings& readings);

}  // namespace alignability::cli

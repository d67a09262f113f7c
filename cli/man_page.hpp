// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/reference.hpp"

namespace alignability::cli {

/// "alignability-validate-map", the name of the page of section 1.
std::string man_page_name(const CommandReference& command);

/// The page of a command, in the man macros of roff, ASCII alone. `program` is what SEE ALSO finds its neighbours in.
std::string man_page(const CommandReference& command, const CommandReference& program, const std::string& version);

}  // namespace alignability::cli

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace alignability::detail {

// The files of report/page, put into the library when it is built.
extern const std::string_view kPageFrame;  ///< with @title@, @style@, @report@ and @script@, in this order
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;

}  // namespace alignability::detail

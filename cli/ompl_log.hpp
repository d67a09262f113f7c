// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace alignability::cli {

/// While it lives, OMPL's warnings and errors go to stderr and the rest of what it says nowhere: stdout is for data.
class OmplLog {
 public:
  OmplLog();
  ~OmplLog();
  OmplLog(const OmplLog&) = delete;
  OmplLog& operator=(const OmplLog&) = delete;
};

}  // namespace alignability::cli

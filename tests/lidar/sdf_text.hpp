// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace alignability::test {

inline constexpr const char* kBox = "<box><size>1 2 3</size></box>";
inline constexpr const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A world of this content, which begins on line 4.
inline std::string world(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"1.7\">\n<world name=\"w\">\n" + content + "\n</world></sdf>\n";
}

/// A collision and a visual `c` and `v` of a geometry.
inline std::string shape(const std::string& geometry, const std::string& pose = "0 0 0 0 0 0") {
  const std::string inside = "<pose>" + pose + "</pose><geometry>" + geometry + "</geometry>";
  return "<collision name=\"c\">" + inside + "</collision><visual name=\"v\">" + inside + "</visual>";
}

/// A model `m` of one link `l`.
inline std::string model(const std::string& shapes, const std::string& pose = "0 0 0 0 0 0") {
  return "<model name=\"m\"><pose>" + pose + "</pose><static>true</static><link name=\"l\">" + shapes + "</link></model>";
}

}  // namespace alignability::test

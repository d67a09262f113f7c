// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lidar/triangle_mesh.hpp"

namespace alignability {

// Shapes about the origin, lengths in metres. All but the rectangle are closed. Round ones are inscribed polyhedra of 48 sides a turn:
// at most 0.3 % of the radius inside the true surface.

TriangleMesh make_box(const Eigen::Vector3d& size);
/// Around the z axis, from -length/2 to length/2.
TriangleMesh make_cylinder(double radius, double length);
TriangleMesh make_sphere(double radius);
TriangleMesh make_ellipsoid(const Eigen::Vector3d& radii);
/// Around the z axis; `length` is that of the cylindrical part alone.
TriangleMesh make_capsule(double radius, double length);
/// In the plane z = 0, facing +z.
TriangleMesh make_rectangle(double size_x, double size_y);

}  // namespace alignability

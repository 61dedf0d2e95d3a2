// Plain closed surfaces: tools of the laboratory, obstacles of tests.
#pragma once

#include "engine/types.h"

namespace vallecula::engine {

/// Box of edge lengths `size` (m) about `centre`: 12 triangles.
TriangleMesh box_surface(const Vec3& centre, const Vec3& size);

/// Sphere about the origin: an octahedron whose faces are halved along every edge `rings` times and pushed out, 8 * 4^rings
/// triangles. With 5 rings no point is further than 0.1 % of the radius inside the sphere.
TriangleMesh sphere_surface(double radius, int rings);

/// Tongue depressor of length, width and thickness `size` (m, along x, y, z) about the origin: all points within half the
/// thickness of a flat plate with semicircular ends, so that no edge is sharp. Throws std::invalid_argument unless
/// length >= width > thickness > 0.
TriangleMesh paddle_surface(const Vec3& size);

}  // namespace vallecula::engine

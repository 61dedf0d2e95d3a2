// The area of tissue surface that the tool's contacts stand for.
#pragma once

#include <algorithm>

#include "engine/contact/contact_constraint.h"
#include "engine/contact/triangle_contact.h"

namespace vallecula::engine {

/// Of contacts that carry force. Each of two sets of points shares out the whole surface at rest (sphere_fill.cpp): its
/// vertices, which carry the force under a tool that spans several of them, and the points on the faces between, which
/// carry it where a tool comes down between vertices. The area is the larger of the two readings, for both see the same
/// contact; the core's spheres, the second line behind them, are not counted. Its grain is a point's share of the
/// surface: a contact smaller than that is read as one share, or none. Where triangles are tested, vertices alone.
class ContactArea {
 public:
  /// `c` carries force. With `tree` where spheres are tested, with `triangles` otherwise.
  void add(const ContactConstraint& c, const SphereTree& tree) noexcept {
    const InnerSphere& sphere = tree.spheres[static_cast<std::size_t>(c.memory)];
    if (!sphere.core) (sphere.standoff < 0.0 ? faces_ : vertices_) += sphere.area;
  }
  void add(const ContactConstraint& c, const TriangleCollision& triangles) noexcept {
    if (c.memory >= 0) vertices_ += triangles.vertex_area[static_cast<std::size_t>(c.memory)];
  }
  double m2() const noexcept { return std::max(vertices_, faces_); }

 private:
  double vertices_ = 0.0, faces_ = 0.0;
};

}  // namespace vallecula::engine

// Exact cuts of a closed triangle surface with a plane, and the ellipse that stands for one.
#pragma once

#include <vector>

#include "engine/types.h"

namespace vallecula::gui {

/// The surface's intersection with the plane through `point` across `normal`: closed outlines, each in order. A vertex
/// that lies on the plane counts as before it. An outline that an open surface leaves open is left out.
std::vector<std::vector<engine::Vec3>> plane_section(const engine::TriangleMesh& surface, const engine::Vec3& point,
                                                     const engine::Vec3& normal);

/// An outline in a plane, measured: area, its middle, and the half axes along `left` and `front` of the ellipse of the
/// same area whose second moments about these have the same ratio. The surface's unit.
struct Outline {
  double area = 0.0;
  engine::Vec3 centre = engine::Vec3::Zero();
  double half_left = 0.0, half_front = 0.0;
};
/// `left` and `front`: unit, at right angles, in the outline's plane.
Outline measured(const std::vector<engine::Vec3>& outline, const engine::Vec3& left, const engine::Vec3& front);

/// Whether `point` lies within the outline as seen along left x front.
bool holds(const std::vector<engine::Vec3>& outline, const engine::Vec3& point, const engine::Vec3& left,
           const engine::Vec3& front);

}  // namespace vallecula::gui

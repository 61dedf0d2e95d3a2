// A CT as its files give it: any directions, exact positions, exact HU. Turning it to the patient's axes is another
// step (to_patient_axes.h).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {

/// Index to millimetres: origin + i step[0] + j step[1] + k step[2], LPS. Steps need not be perpendicular (tilted
/// gantry).
struct CtGeometry {
  std::array<int, 3> size{0, 0, 0};  ///< columns, rows, slices
  Vector3 origin{};                  ///< centre of voxel (0, 0, 0), mm LPS
  std::array<Vector3, 3> step{};     ///< along a row, along a column, from slice to slice, mm LPS

  std::size_t count() const { return static_cast<std::size_t>(size[0]) * size[1] * size[2]; }
  Vector3 position(double i, double j, double k) const {
    Vector3 p{};
    for (int a = 0; a < 3; ++a) p[a] = origin[a] + i * step[0][a] + j * step[1][a] + k * step[2][a];
    return p;
  }
};

struct CtVolume {
  CtGeometry geometry;
  std::shared_ptr<const std::int16_t> voxels;  ///< geometry.count() HU; the index along a row runs fastest
  int slices = 0;                              ///< pictures in the source (fewer than size[2] where holes were bridged)
  std::vector<std::string> notes;              ///< what a person should know, for instance files left out

  std::int16_t at(int i, int j, int k) const {
    return voxels.get()[(static_cast<std::size_t>(k) * geometry.size[1] + j) * geometry.size[0] + i];
  }
};

/// By how many degrees the slices are sheared against each other: the angle between the step from slice to slice and
/// the slices' normal.
inline double tilt_degrees(const CtGeometry& g) {
  const auto normal = cross(g.step[0], g.step[1]);
  return std::atan2(norm(cross(normal, g.step[2])), std::abs(dot(normal, g.step[2]))) * 180.0 / 3.14159265358979324;
}

}  // namespace vallecula::pipeline

// The engine's shared words. SI units (m, kg, s, N), right-handed patient axes LPS:
// x to the patient's left, y to the back, z to the head.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace vallecula::engine {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// A rigid pose: rotation turns the body's axes into the world's, position is the body's origin in the world (m).
/// For the tool the origin is the blade tip, +x runs from the tip along the blade to the handle, +z leaves the
/// tongue-side face towards the handle.
struct Pose {
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();

  Vec3 to_world(const Vec3& local) const { return position + rotation * local; }
  Vec3 to_local(const Vec3& world) const { return rotation.conjugate() * (world - position); }
};

/// What a contact touches; the split in which forces are recorded and scored. `other` (lips, cheeks, the rest) never
/// carries load of its own: what the lips push with is part of the model force alone.
enum class Structure : std::uint8_t { tongue, epiglottis, gum, palate, teeth, larynx, other };
constexpr int kLoadedStructures = 6;  ///< all but `other`

/// Indexed triangles, counter-clockwise seen from outside (normals point out of the solid).
struct TriangleMesh {
  std::vector<Vec3> points;                   ///< m
  std::vector<std::array<int, 3>> triangles;  ///< indices into points
};

/// The states of the hand's bond with the scene (DESIGN: tracking -> limited -> lost -> recovering -> tracking).
enum class HapticState : std::uint8_t { tracking, limited, lost, recovering };

}  // namespace vallecula::engine

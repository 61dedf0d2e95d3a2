// Rigid anatomy as contact sees it: one distance field at rest, and parts of it that move with a sprung body.
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "engine/contact/signed_distance_grid.h"
#include "engine/scene.h"

namespace vallecula::engine {

constexpr int kMostRigidParts = 4;

/// Where a moving part is: displacement(y) = turn x (y - pivot) + shift of its points y at rest (motion linearised
/// about rest, as that of the tissue fastened to the same body), and their velocity likewise.
struct PartPose {
  Mat3 to_rest = Mat3::Identity();  ///< of x - pivot - shift
  Vec3 pivot = Vec3::Zero(), shift = Vec3::Zero();
  Vec3 spin = Vec3::Zero(), drift = Vec3::Zero();  ///< rad/s about the pivot, m/s
  Vec3 travel = Vec3::Zero();  ///< a move of the part changes it by as much as its farthest point goes at most, m

  Vec3 rest_of(const Vec3& x) const { return pivot + to_rest * (x - pivot - shift); }
  /// Direction at x of what is direction n at rest, as normals turn.
  Vec3 normal_of(const Vec3& n) const { return (to_rest.transpose() * n).normalized(); }
  Vec3 velocity_at(const Vec3& rest) const { return spin.cross(rest - pivot) + drift; }
};
using PartPoses = std::array<PartPose, kMostRigidParts>;

class RigidField {
 public:
  RigidField() = default;
  /// Samples the anatomy in the box [low, high] with `spacing`, exact within `band` of it (m). Throws
  /// std::invalid_argument when a part or a triangle names what does not exist. `sampled` (may be null): a field whose
  /// triangles, structures, parts of triangles and box are the very same; its samples are shared.
  RigidField(const RigidAnatomy& anatomy, const std::vector<SprungBody>& bodies, const Vec3& low, const Vec3& high,
             double spacing, double band, const RigidField* sampled = nullptr);

  /// The parts' poses for the bodies' displacements and velocities (translation, or angle in x).
  void place(const std::vector<Vec3>& displacement, const std::vector<Vec3>& velocity, PartPoses& poses) const noexcept;

  struct Touch {
    double distance;  ///< m, negative inside
    Vec3 normal;      ///< out of the solid, world
    Structure structure;
    int part;   ///< -1: stands still
    Vec3 rest;  ///< the point in the rest frame of the part
  };
  /// Calls visit(Touch) for what there is at x nearer than `reach`: of the fixed anatomy and of each part that which is
  /// its own; else away(part, distance), where a distance below 0 is that in something else, or so deep that nothing is
  /// known of which way is out. Returns how far x is from all of it at least.
  template <class Visit, class Away>
  double look(const Vec3& x, const PartPoses& poses, double reach, Visit visit, Away away) const {
    double nearest = grid_->band();
    for (int part = -1; part < part_count(); ++part) {
      const Vec3 rest = part < 0 ? x : poses[static_cast<std::size_t>(part)].rest_of(x);
      const SignedDistanceGrid::Sample s = grid_->sample(rest);
      nearest = std::min(nearest, s.distance);
      const std::uint8_t of = s.distance < reach ? grid_->class_at(rest) : SignedDistanceGrid::kNoClass;
      if (of == SignedDistanceGrid::kNoClass || of / kPartFactor - 1 != part) {
        away(part, s.distance);
        continue;
      }
      const Vec3 normal = part < 0 ? s.gradient : poses[static_cast<std::size_t>(part)].normal_of(s.gradient);
      visit(Touch{s.distance, normal, static_cast<Structure>(of % kPartFactor), part, rest});
    }
    return nearest;
  }

  /// Does x lie in the box that is sampled? Outside of it nothing is known.
  bool covers(const Vec3& x) const noexcept { return grid_->covers(x); }

  /// Generalized direction: what a unit of the part's body's unknown (m along each axis, or rad in x) moves a point of
  /// the part, at rest at `rest`, along n.
  Vec3 lever(int part, const Vec3& rest, const Vec3& n) const noexcept;
  int body_of(int part) const noexcept { return parts_[static_cast<std::size_t>(part)].body; }
  int part_count() const noexcept { return static_cast<int>(parts_.size()); }

 private:
  static constexpr std::uint8_t kPartFactor = 16;  // a class is a structure and, above it, the part

  std::shared_ptr<const SignedDistanceGrid> grid_ = std::make_shared<const SignedDistanceGrid>();
  std::vector<RigidPart> parts_;
  std::vector<SprungBody> body_;  ///< per part
  std::vector<double> reach_;     ///< per part that turns: its farthest point from the pivot, m
};

}  // namespace vallecula::engine

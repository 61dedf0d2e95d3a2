// The share of the glottic opening that the operator's eye sees past tissue, tool and fixed anatomy, by rays on the true
// geometry. All rays start at the eye, so each surface is tested by projecting its triangles from there: the same answer
// as casting every ray at every triangle, in microseconds.
#pragma once

#include <vector>

#include "engine/scene.h"

namespace vallecula::engine {

class LineOfSight {
 public:
  /// Takes sample points inside the glottic outline (about `samples` of them, evenly spaced) and finds which of them the
  /// fixed anatomy hides from the eye. Without an outline nothing is ever seen. Throws std::invalid_argument for one
  /// without area.
  /// A follower of a body that is not there is refused in the same way.
  explicit LineOfSight(const SightDescription& sight, const std::vector<SprungBody>& bodies = {}, int samples = 120);

  /// Work space of an evaluation, sized once.
  struct Scratch {
    std::vector<char> hidden;
    std::vector<Vec3> samples;            ///< projected, as the glottis lies
    std::vector<Vec3> projected;          ///< of the occluder that is looked at
    Vec3 eye = Vec3::Zero();              ///< where the rays start
    double distance = 1.0;                ///< of the glottis' centre from it along the axis
    double low_u = 0.0, high_u = 0.0, low_v = 0.0, high_v = 0.0;  ///< about the samples
  };
  Scratch make_scratch(std::size_t most_points) const;

  /// Starts an evaluation: only the anatomy stands in the way, as it lies with the bodies displaced. The eye is moved by
  /// `eye_offset` (m), up to kEyeMove to each side in its own axes: of what comes before a farther eye some is left out.
  void begin(Scratch& scratch, const std::vector<Vec3>& body_displacement,
             const Vec3& eye_offset = Vec3::Zero()) const noexcept;
  /// Adds an occluder: `points[i]` in world coordinates through `position(i)`.
  template <class Position>
  void add(Scratch& scratch, int point_count, const std::vector<std::array<int, 3>>& triangles, Position position) const noexcept {
    for (int i = 0; i < point_count; ++i) scratch.projected[i] = project(position(i), scratch);
    for (const auto& t : triangles)
      hide_behind(scratch.projected[t[0]], scratch.projected[t[1]], scratch.projected[t[2]], scratch);
  }
  /// Hides the samples that lie lower than `height` (m) along `up` (unit): fluid stands above them.
  void hide_below(Scratch& scratch, const std::vector<Vec3>& body_displacement, const Vec3& up,
                  double height) const noexcept;
  /// Fraction of the samples still in sight, 0..1.
  double visible(const Scratch& scratch) const noexcept;

  int sample_count() const { return static_cast<int>(points_.size()); }
  /// Fraction seen past the anatomy alone as it lies at rest.
  double unobstructed() const;

 private:
  /// (u, v, depth): perspective from the eye onto the plane through the glottis' centre, depth along the axis; depth <= 0
  /// behind the eye.
  Vec3 project(const Vec3& p, const Scratch& from) const noexcept;
  void look_from(const Vec3& eye_offset, Scratch& scratch) const noexcept;
  void hide_behind(const Vec3& a, const Vec3& b, const Vec3& c, Scratch& scratch) const noexcept;
  Vec3 sample_at(std::size_t i, const std::vector<Vec3>& body_displacement) const noexcept;
  void place_samples(Scratch& scratch, const std::vector<Vec3>& body_displacement) const noexcept;
  void keep_occluders_near(const SightDescription& sight);

  Vec3 eye_, axis_ = Vec3::UnitZ(), u_ = Vec3::UnitX(), v_ = Vec3::UnitY();
  double distance_ = 1.0;
  /// What moves with a body: the samples by one share, occluders' points each by its own.
  struct Follower {
    SprungBody body;
    int index = 0;
    double glottis_share = 0.0;
    std::vector<float> point_share;
  };
  std::vector<Vec3> points_;          ///< samples at rest, world
  TriangleMesh occluders_;            ///< what can come before the glottis
  std::vector<Follower> followers_;
};

}  // namespace vallecula::engine

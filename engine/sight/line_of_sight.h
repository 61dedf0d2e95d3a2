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
  explicit LineOfSight(const SightDescription& sight, int samples = 120);

  /// Work space of an evaluation, sized once.
  struct Scratch {
    std::vector<char> hidden;
    std::vector<Vec3> projected;
  };
  Scratch make_scratch(std::size_t most_points) const;

  /// Starts an evaluation: only fixed anatomy stands in the way.
  void begin(Scratch& scratch) const noexcept;
  /// Adds an occluder: `points[i]` in world coordinates through `position(i)`.
  template <class Position>
  void add(Scratch& scratch, int point_count, const std::vector<std::array<int, 3>>& triangles, Position position) const noexcept {
    for (int i = 0; i < point_count; ++i) scratch.projected[i] = project(position(i));
    for (const auto& t : triangles)
      hide_behind(scratch.projected[t[0]], scratch.projected[t[1]], scratch.projected[t[2]], scratch.hidden);
  }
  /// Fraction of the samples still in sight, 0..1.
  double visible(const Scratch& scratch) const noexcept;

  int sample_count() const { return static_cast<int>(points_.size()); }
  /// Fraction seen past the fixed anatomy alone: what no lift can exceed.
  double unobstructed() const;

 private:
  /// (u, v, depth): perspective from the eye onto the plane through the glottis' centre, depth along the axis; depth <= 0
  /// behind the eye.
  Vec3 project(const Vec3& p) const noexcept;
  void hide_behind(const Vec3& a, const Vec3& b, const Vec3& c, std::vector<char>& hidden) const noexcept;

  Vec3 eye_, axis_ = Vec3::UnitZ(), u_ = Vec3::UnitX(), v_ = Vec3::UnitY();
  double distance_ = 1.0;
  std::vector<Vec3> points_;          ///< projected samples
  std::vector<char> hidden_by_fixed_;
  double low_u_ = 0.0, high_u_ = 0.0, low_v_ = 0.0, high_v_ = 0.0;
};

}  // namespace vallecula::engine

// Following a lumen through a closed surface by cuts across it. Millimetres, LPS.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gui/session/plane_section.h"

namespace vallecula::gui {

/// A cut's area over that of the one before it: outside of these the lumen has ended.
constexpr double kLeastShare = 0.4, kMostShare = 2.5;

/// A frame across the way: `left` is the patient's, `front` is along x left.
struct Across {
  explicit Across(const engine::Vec3& way);
  engine::Vec3 along, left, front;
};

/// A cut: its ellipse, with all other outlines of the same plane.
struct Cut {
  Outline own;
  std::vector<Outline> others;
};

/// The outline that holds `point`; none where there is none.
std::optional<Cut> cut_at(const engine::TriangleMesh& mesh, const engine::Vec3& point, const Across& frame);

/// A line through points (two or more), by the length along it; straight on beyond its ends.
class Line {
 public:
  explicit Line(std::vector<engine::Vec3> points);
  double length() const { return lengths_.back(); }
  engine::Vec3 at(double s) const;
  /// Direction over `about` on either side of s.
  engine::Vec3 along(double s, double about) const;

 private:
  std::vector<engine::Vec3> points_;
  std::vector<double> lengths_;
};

struct Followed {
  std::vector<engine::Vec3> centres;
  bool forked = false;  ///< ends where the lumen does
};

/// Centres of the lumen from `start` on, first towards `along`, a step apart, recentred in each cut, for as long as
/// there is one lumen and `goes_on` says so of the last centre and direction.
Followed follow(const engine::TriangleMesh& mesh, const engine::Vec3& start, engine::Vec3 along, double step,
                const std::function<bool(const engine::Vec3& at, const engine::Vec3& along)>& goes_on);

/// Each point with its neighbours, ends kept: voxels make the centres jitter.
std::vector<engine::Vec3> smoothed(std::vector<engine::Vec3> points);

}  // namespace vallecula::gui

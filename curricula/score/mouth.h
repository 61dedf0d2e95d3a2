// Where the mouth begins, for telling when an attempt does.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

namespace vallecula::curricula {

/// Out of the mouth for less than this is jitter about its plane, not another way in.
constexpr double kOutForAnEntryS = 1.0;

/// The space behind the gums. Its front is the plane through both gum midlines that faces the vallecula; its width is a
/// tube around the line from the middle between the gums to the vallecula, so that a blade beside or below the head is
/// not taken for one in the mouth.
struct Mouth {
  std::array<double, 3> gum_middle_m{};
  std::array<double, 3> inward{};  ///< unit normal of the front plane, into the mouth
  std::array<double, 3> axis{};    ///< unit, from the middle between the gums to the vallecula
  double radius_m = 0.0;

  bool holds(const std::array<double, 3>& tip_m) const noexcept;
};

/// From the landmarks upper_gum_midline, lower_gum_midline and vallecula (m, any common frame). Nothing when one is
/// missing or they do not span a mouth.
std::optional<Mouth> mouth_from_landmarks(const std::map<std::string, std::array<double, 3>>& landmarks_m);

}  // namespace vallecula::curricula

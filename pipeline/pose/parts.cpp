#include "pipeline/pose/parts.h"

#include <algorithm>
#include <cmath>

#include "pipeline/segment/mouth_bounds.h"

namespace vallecula::pipeline {
namespace {

// Of the hyoid's way: it goes with the larynx it holds and with the chin that its muscles come from
// (assumed; its muscles to skull base and spine keep the rest).
constexpr double kHyoidWithNeck = 0.65;
constexpr double kHyoidWithJaw = 0.35;
// Shearing air costs next to nothing; muscle resists more than fat (assumed: only ratios count).
constexpr float kAir = 0.05F;
constexpr float kTissue = 1.0F;
constexpr float kMuscle = 3.0F;
constexpr float kGristle = 6.0F;
constexpr float kBone = 30.0F;

/// Where the closed lips meet: the groove in the profile nearest to where the gums have it, else there.
double lip_line_of(const Segmentation& s, const Vector3& upper, const Vector3& lower) {
  const double k = s.frame.scale;
  const double by_gums = upper[2] - std::clamp(0.27 * (upper[2] - lower[2]), 1.5 * k, 5.0 * k);
  const auto& g = s.hu.grid;
  const auto& body = s.head.body;
  const auto skin = [&](int z) {  // mean y of the face in the middle
    double sum = 0.0;
    int n = 0;
    for (int x = 0; x < g.size[0]; ++x) {
      if (std::abs(g.origin[0] + x * g.spacing[0] - s.frame.mid_x) > 3.0 * k) continue;
      int y = std::max(0, g.nearest({0, upper[1] - 20.0 * k, 0})[1]);
      while (y < g.size[1] - 1 && body.at(x, y, z) == 0) ++y;
      sum += g.origin[1] + y * g.spacing[1];
      ++n;
    }
    return n > 0 ? sum / n : 0.0;
  };
  const int reach = std::max(1, static_cast<int>(std::lround(3.0 * k / g.spacing[2])));
  double best = 0.4 * k;  // a groove shallower than this is none
  double line = by_gums;
  for (int z = 0; z < g.size[2]; ++z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    if (std::abs(pz - by_gums) > 4.0 * k || z < reach || z + reach >= g.size[2]) continue;
    const double groove = skin(z) - 0.5 * (skin(z - reach) + skin(z + reach));
    if (groove <= best) continue;
    best = groove;
    line = pz;
  }
  return line;
}

/// Foremost bone of the jaw's ridge for each x; the last seen value goes on to the sides.
std::vector<double> arch_front(const Mask& mandible, double mid_x, double crest_z, double k) {
  const auto& g = mandible.grid;
  const auto box = box_between(g, {mid_x - 20.0 * k, -1e6, crest_z - 4.0 * k}, {mid_x + 20.0 * k, 1e6, crest_z + 1e3});
  std::vector<double> front(g.size[0], 1e30);
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        if (mandible.at(x, y, z) != 0) front[x] = std::min(front[x], g.origin[1] + y * g.spacing[1]);
      }
    }
  }
  const int middle = std::clamp(g.nearest({mid_x, 0, 0})[0], 0, g.size[0] - 1);
  for (const int step : {1, -1}) {
    for (int x = middle + step; x >= 0 && x < g.size[0]; x += step) {
      if (front[x] > 1e29) front[x] = front[x - step];
    }
  }
  return front;
}

struct Mouth {
  Vector3 upper{};  ///< gums in the middle
  Vector3 lower{};
  double line_z = 0.0;
  double half_width = 0.0;
  double palate_end_y = 0.0;
};

/// The lower lip: what lies in front of jaw and tongue, under the lips' line, as wide as the mouth.
Mask lower_lip(const Segmentation& s, const Mouth& mouth) {
  const double k = s.frame.scale;
  const auto& g = s.hu.grid;
  const auto arch = arch_front(s.bones.mandible, s.frame.mid_x, mouth.lower[2], k);
  Mask lip(g);
  const auto box =
      box_between(g, {s.frame.mid_x - mouth.half_width, -1e6, mouth.lower[2] - 6.0 * k},
                  {s.frame.mid_x + mouth.half_width, mouth.lower[1] + 30.0 * k, mouth.line_z});
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        const auto i = g.index(x, y, z);
        if (s.labels.voxels[i] != kSkin || s.head.body.voxels[i] == 0) continue;
        const bool above_jaw = g.origin[2] + z * g.spacing[2] > mouth.lower[2];
        if (g.origin[1] + y * g.spacing[1] < arch[x] + (above_jaw ? 12.0 * k : 0.0)) lip.voxels[i] = 1;
      }
    }
  }
  return lip;
}

/// Does the lower sheet come free of its neighbour `q` at voxel `p`? `bare` is what lies by the soft palate or the airway.
bool comes_free(const Segmentation& s, const Mouth& mouth, const Mask& bare, std::size_t p, std::size_t q) {
  const double k = s.frame.scale;
  const auto at = s.hu.grid.position(p);
  const auto beyond = s.hu.grid.position(q);
  if (s.labels.voxels[p] != kTongue) return beyond[2] > at[2] && beyond[2] > mouth.line_z - 0.01;
  const auto label = s.labels.voxels[q];
  if (label == kEpiglottis) return at[2] > Vector3(s.landmarks.at("vallecula"))[2] + 3.0 * k;
  if (bare.voxels[q] != 0 || s.hu.voxels[q] < s.thresholds.air) return true;
  // In front of the throat: down to the groove beside the lower gum. Behind, folds hold the tongue to the walls.
  return at[2] > mouth.lower[2] - 4.0 * k && at[1] < mouth.palate_end_y - 1.0 * k;
}

void find_cut(const Segmentation& s, const Mouth& mouth, Parts& parts) {
  const auto& g = s.hu.grid;
  const auto box = bounds_of(parts.lower);
  const auto bare = dilated(where(s.labels, [](std::uint8_t v) { return v == kAirway || v == kSoftPalate; }),
                            1.5 * s.frame.scale);
  for (int z = std::max(1, box.low[2]); z <= std::min(box.high[2], g.size[2] - 2); ++z) {
    for (int y = std::max(1, box.low[1]); y <= std::min(box.high[1], g.size[1] - 2); ++y) {
      for (int x = std::max(1, box.low[0]); x <= std::min(box.high[0], g.size[0] - 2); ++x) {
        const auto p = g.index(x, y, z);
        if (parts.lower.voxels[p] == 0) continue;
        constexpr int kSteps[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        for (const auto& d : kSteps) {
          const auto q = g.index(x + d[0], y + d[1], z + d[2]);
          if (parts.lower.voxels[q] == 0 && comes_free(s, mouth, bare, p, q))
            parts.cut.push_back(g.position(x + 0.5 * d[0], y + 0.5 * d[1], z + 0.5 * d[2]));
        }
      }
    }
  }
}

/// The tongue in the open mouth (ANATOMY): its tip lies behind the lower gum and little above it, its back off the soft
/// palate by some 4 mm.
void pull_tongue(const Segmentation& s, const Aim& aim, const Mouth& mouth, Parts& parts) {
  const double k = s.frame.scale;
  const auto& g = s.hu.grid;
  const auto beside = dilated(where(s.labels, [](std::uint8_t v) { return v == kSoftPalate; }), 2.0 * k);
  for (std::size_t i = 0; i < parts.cut.size(); i += 7) {  // a few of the faces will do
    const auto& p = parts.cut[i];
    const auto c = g.nearest(p);
    const double over_gum = p[2] - mouth.lower[2];
    if (beside.at(c[0], c[1], c[2]) != 0) {
      parts.lower_pulls.push_back({p, 0.6 * (aim.jaw(p) - p) + k * Vector3{0.0, -4.5, -2.5}, 3.0 * k, 0.3F});
    } else if (over_gum > 0.0 && p[1] < mouth.lower[1] + 12.0 * k) {
      parts.lower_pulls.push_back({p, aim.jaw(p) - p + Vector3{0.0, 2.0 * k, -0.5 * over_gum}, 3.0 * k, 0.1F});
    }
  }
}

/// The lips are drawn off the gums as a wide mouth draws them: to where the term infant's lie over its gums (ANATOMY).
void pull_lips(const Segmentation& s, const Aim& aim, const Mouth& mouth, Parts& parts) {
  const double k = s.frame.scale;
  const auto& g = s.hu.grid;
  const double up = std::clamp(mouth.upper[2] + 4.1 * k - mouth.line_z, 0.0, 14.0 * k);
  const double down = std::clamp(mouth.line_z - (mouth.lower[2] - 0.7 * k), 0.0, 10.0 * k);
  const auto skin_y = [&](double x, double z) {
    const auto c = g.nearest({x, mouth.upper[1] - 20.0 * k, z});
    int y = std::max(0, c[1]);
    while (y < g.size[1] - 1 && s.head.body.at(c[0], y, c[2]) == 0) ++y;
    return g.origin[1] + y * g.spacing[1];
  };
  double lip_y = skin_y(s.frame.mid_x, mouth.line_z + 2.0 * k) + 2.5 * k;
  const double back = std::clamp(mouth.upper[1] - 3.9 * k - lip_y, -2.0 * k, 6.0 * k);
  for (int x = 0; x < g.size[0]; ++x) {
    const double px = g.origin[0] + x * g.spacing[0];
    if (std::abs(px - s.frame.mid_x) > mouth.half_width) continue;
    const double above = mouth.line_z + 0.5 * k;
    const double below = mouth.line_z - 0.5 * k;
    parts.lips.push_back({x, {skin_y(px, above) + 1.0 * k, above}, {skin_y(px, below) + 1.0 * k, below}});
  }
  // The corners, where the lips hold together, go half the jaw's way.
  const double reach = 0.85 * mouth.half_width;
  for (double x = -reach; x <= reach; x += 1.5 * k) {
    const double f = 1.0 - std::pow(x / mouth.half_width, 2);
    const Vector3 high{s.frame.mid_x + x, skin_y(s.frame.mid_x + x, mouth.line_z + 2.0 * k) + 2.5 * k,
                       mouth.line_z + 1.5 * k};
    const Vector3 low{high[0], skin_y(high[0], mouth.line_z - 2.0 * k) + 2.5 * k, mouth.line_z - 1.5 * k};
    const auto corner = (0.5 - 0.5 * f) * (aim.jaw(low) - low);
    parts.upper_pulls.push_back({high, corner + f * Vector3{0.0, back, up}, 3.0 * k});
    parts.lower_pulls.push_back({low, corner + f * (aim.jaw(low) - low + Vector3{0.0, back, -down}), 3.0 * k});
  }
}

}  // namespace

Vector3 tied(Tie tie, const Aim& aim, const Vector3& p) {
  switch (tie) {
    case Tie::jaw:
      return aim.jaw(p);
    case Tie::neck:
      return aim.neck(p);
    case Tie::hyoid:
      return p + kHyoidWithNeck * (aim.neck(p) - p) + kHyoidWithJaw * (aim.jaw(p) - p);
    default:
      return p;
  }
}

Parts parts_of(const Segmentation& s, const Aim& aim) {
  const double k = s.frame.scale;
  const auto& g = s.hu.grid;
  const auto roof = find_roof(s.bones.skull, s.bones.mandible, s.frame);
  Mouth mouth;
  mouth.upper = roof.seen ? roof.front : Vector3(s.landmarks.at("upper_gum_midline"));
  mouth.lower = s.landmarks.at("lower_gum_midline");
  mouth.half_width = 14.5 * k;
  mouth.palate_end_y = roof.seen ? roof.back[1] : mouth.upper[1] + 28.0 * k;
  Parts parts;
  parts.lips = s.head.lips;
  parts.top_z = mouth.upper[2] + 17.0 * k;
  parts.lower = where(s.labels, [](std::uint8_t v) { return v == kTongue; });
  if (aim.part) {
    if (s.head.lips.empty()) {
      mouth.line_z = lip_line_of(s, mouth.upper, mouth.lower);
      parts.lower = any_of(parts.lower, lower_lip(s, mouth));
      pull_lips(s, aim, mouth, parts);
    }
    find_cut(s, mouth, parts);
    pull_tongue(s, aim, mouth, parts);
  }

  parts.ties = Volume<std::uint8_t>(g, static_cast<std::uint8_t>(Tie::none));
  parts.stiffness = Volume<float>(g, kAir);
  const Vector3 hyoid = s.landmarks.at("hyoid");
  const double neck_below = aim.neck.angle_rad != 0.0 ? aim.neck.pivot[2] - 26.0 * k : s.airway.glottis.centre[2];
  const auto skull = largest_component(s.bones.skull);
  const auto& cords = s.airway.glottis.centre;
  const auto in_larynx = [&](const Vector3& p) {
    return p[2] < cords[2] + 1.0 * k && std::abs(p[0] - cords[0]) < 10.0 * k && p[1] > cords[1] - 7.0 * k &&
           p[1] < cords[1] + 10.0 * k;
  };
  for (std::size_t i = 0; i < g.count(); ++i) {
    const auto p = g.position(i);
    auto tie = Tie::none;
    // The arches of the upper vertebrae stand close under the skull: they follow, but are not tied.
    const bool vertebra = s.bones.spine.voxels[i] != 0 && p[2] < neck_below &&
                          (p[1] < aim.neck.pivot[1] + 12.0 * k || p[2] < neck_below - 25.0 * k);
    if (in_larynx(p) || (vertebra && aim.neck.angle_rad != 0.0)) tie = Tie::neck;
    if (s.bones.hyoid.voxels[i] != 0 || (!s.bones.hyoid_seen && distance(p, hyoid) < 3.0 * k)) tie = Tie::hyoid;
    if (s.bones.mandible.voxels[i] != 0) tie = Tie::jaw;
    if (skull.voxels[i] != 0) tie = Tie::skull;
    parts.ties.voxels[i] = static_cast<std::uint8_t>(tie);
    if (s.head.body.voxels[i] == 0) continue;
    switch (s.labels.voxels[i]) {
      case kTongue:
      case kSoftPalate:
        parts.stiffness.voxels[i] = kMuscle;
        break;
      case kEpiglottis:
      case kLarynx:
        parts.stiffness.voxels[i] = kGristle;
        break;
      case kSpine:
        parts.stiffness.voxels[i] = kBone;
        break;
      default:
        parts.stiffness.voxels[i] = kTissue;
    }
  }
  return parts;
}

}  // namespace vallecula::pipeline

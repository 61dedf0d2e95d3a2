#include "pipeline/mesh/generic_face.h"

#include <algorithm>
#include <cmath>

#include "pipeline/manikin/shapes.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

// Lengths of the term newborn, mm.
constexpr double kLipsStay = 10.0;
constexpr double kAllGeneric = 22.0;  ///< from the lips; between the two the faces blend
constexpr double kSkinOver = 2.5;     ///< left over bone and airway
constexpr double kCell = 1.6;         ///< of the grid on which the shapes are compared; the outside is smooth
constexpr double kNeckFades = 14.0;   ///< above the glottis: the neck is the patient's
constexpr double kSkinInLabels = 3.0;
constexpr float kHuPerMm = 700.0F;  ///< as the scanner's blur spreads the step from air to tissue
constexpr std::int16_t kAirHu = -1000;

bool within(std::uint8_t label) { return label != kBackground && label != kSkin; }

Grid coarse_grid(const Grid& fine, double cell, double low_z) {
  Grid g;
  const double top = fine.origin[2] + (fine.size[2] - 1) * fine.spacing[2];
  g.origin = {fine.origin[0], fine.origin[1], std::min(low_z, top)};
  const std::array<double, 3> high{fine.origin[0] + (fine.size[0] - 1) * fine.spacing[0],
                                   fine.origin[1] + (fine.size[1] - 1) * fine.spacing[1], top};
  for (int a = 0; a < 3; ++a) {
    g.spacing[a] = cell;
    g.size[a] = static_cast<int>(std::ceil((high[a] - g.origin[a]) / cell)) + 1;
  }
  return g;
}

/// 0 where the face stays the patient's, 1 where it is the shipped one.
Volume<float> share_of_generic(const Segmentation& s, const Grid& grid) {
  const double k = s.frame.scale;
  Mask lips(grid);
  const auto mark = [&](double x, double y, double z) {
    const auto c = grid.nearest({x, y, z});
    if (grid.contains(c[0], c[1], c[2])) lips.at(c[0], c[1], c[2]) = 1;
  };
  const auto& fine = s.hu.grid;
  for (const auto& gap : s.head.lips) {
    const double x = fine.origin[0] + gap.x * fine.spacing[0];
    for (double t = 0.0; t <= 1.0; t += 0.1)
      mark(x, gap.upper[0] + t * (gap.lower[0] - gap.upper[0]), gap.upper[1] + t * (gap.lower[1] - gap.upper[1]));
  }
  // A closed mouth has no lip edges: about the gums then.
  for (const auto* name : {"upper_gum_midline", "lower_gum_midline"}) {
    const auto& p = s.landmarks.at(name);
    mark(p[0], p[1], p[2]);
  }
  auto share = distance_to(lips);
  const double glottis = s.landmarks.at("glottis_centre")[2];
  for (std::size_t i = 0; i < share.voxels.size(); ++i) {
    const double from_lips = std::clamp((share.voxels[i] / k - kLipsStay) / (kAllGeneric - kLipsStay), 0.0, 1.0);
    const double over_neck = std::clamp((grid.position(i)[2] - glottis) / (kNeckFades * k), 0.0, 1.0);
    share.voxels[i] = static_cast<float>(from_lips * over_neck);
  }
  return share;
}

}  // namespace

void give_generic_face(Segmentation& s) {
  const double k = s.frame.scale;
  const auto& fine = s.hu.grid;
  const auto grid = coarse_grid(fine, kCell * k, s.landmarks.at("glottis_centre")[2]);
  Mask patient(grid), inner(grid);
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto c = fine.nearest(grid.position(i));
    if (!fine.contains(c[0], c[1], c[2])) continue;
    patient.voxels[i] = s.head.inside.at(c[0], c[1], c[2]);
    inner.voxels[i] = within(s.labels.at(c[0], c[1], c[2])) ? 1 : 0;
  }
  const auto share = share_of_generic(s, grid);
  auto field = signed_distance(patient);  // mm, positive inside
  const auto to_inner = distance_to(inner);
  const auto shapes = manikin::face_shapes(manikin::vary(0));
  const auto& gum = s.landmarks.at("upper_gum_midline");
  for (std::size_t i = 0; i < grid.count(); ++i) {
    if (share.voxels[i] <= 0.0F) continue;
    const auto p = grid.position(i);
    const double generic = -k * shapes.head({(p[0] - gum[0]) / k, (p[1] - gum[1]) / k, (p[2] - gum[2]) / k});
    const double kept = kSkinOver * k - to_inner.voxels[i];
    field.voxels[i] += share.voxels[i] * static_cast<float>(std::max(generic, kept) - field.voxels[i]);
  }
  field = smoothed(field, k);
  for (std::size_t i = 0; i < fine.count(); ++i) {
    const auto p = fine.position(i);
    if (within(s.labels.voxels[i]) || p[2] < grid.origin[2] || value_at(share, p) <= 0.0) continue;
    const auto f = static_cast<float>(value_at(field, p));
    const bool in = f > 0.0F;
    if (std::abs(f) < 1.0F) {
      s.hu.voxels[i] = static_cast<std::int16_t>(std::lround(s.thresholds.air + kHuPerMm * f));
    } else if (!in) {
      s.hu.voxels[i] = kAirHu;
    } else if (s.head.body.voxels[i] == 0) {
      s.hu.voxels[i] = static_cast<std::int16_t>(std::lround(s.thresholds.soft));
    }
    s.head.inside.voxels[i] = s.head.body.voxels[i] = in ? 1 : 0;
    s.labels.voxels[i] = in ? kSkin : kBackground;
  }
}

Labels without_face(const Labels& labels, double scale) {
  const auto to_inner = distance_to(where(labels, within));
  auto out = labels;
  for (std::size_t i = 0; i < out.voxels.size(); ++i) {
    if (within(out.voxels[i])) continue;
    out.voxels[i] = to_inner.voxels[i] <= kSkinInLabels * scale ? kSkin : kBackground;
  }
  return out;
}

}  // namespace vallecula::pipeline

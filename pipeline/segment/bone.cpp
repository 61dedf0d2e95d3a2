#include "pipeline/segment/bone.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vallecula::pipeline {
namespace {

enum Marker : std::uint8_t { kNoMarker = 0, kSkullMarker = 1, kMandibleMarker = 2, kSpineMarker = 3 };

/// Per slice the y of the airway's back wall near the middle; slices without airway take their neighbours' value.
std::vector<double> back_wall(const Mask& lumen, const Frame& frame) {
  const auto& g = lumen.grid;
  std::vector<double> y_back(g.size[2], -1e9);
  const int low = std::max(0, g.nearest({frame.mid_x - 6.0 * frame.scale, 0, 0})[0]);
  const int high = std::min(g.size[0] - 1, g.nearest({frame.mid_x + 6.0 * frame.scale, 0, 0})[0]);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = g.size[1] - 1; y >= 0 && y_back[z] < -1e8; --y) {
      for (int x = low; x <= high; ++x) {
        if (lumen.at(x, y, z) != 0) y_back[z] = g.origin[1] + y * g.spacing[1];
      }
    }
  }
  for (int z = 1; z < g.size[2]; ++z) {
    if (y_back[z] < -1e8) y_back[z] = y_back[z - 1];
  }
  for (int z = g.size[2] - 2; z >= 0; --z) {
    if (y_back[z] < -1e8) y_back[z] = y_back[z + 1];
  }
  return y_back;
}

struct Extent {
  std::array<double, 3> low{1e30, 1e30, 1e30};
  std::array<double, 3> high{-1e30, -1e30, -1e30};
  std::array<double, 3> sum{};
  std::size_t voxels = 0;
  bool touches_skull = false;
};

std::vector<Extent> extents_of(const Components& parts, const Volume<std::uint8_t>& markers) {
  std::vector<Extent> e(parts.sizes.size());
  const auto& g = parts.id.grid;
  for (std::size_t i = 0; i < parts.id.voxels.size(); ++i) {
    const int id = parts.id.voxels[i];
    if (id == 0) continue;
    const auto p = g.position(i);
    for (int a = 0; a < 3; ++a) {
      e[id].low[a] = std::min(e[id].low[a], p[a]);
      e[id].high[a] = std::max(e[id].high[a], p[a]);
      e[id].sum[a] += p[a];
    }
    ++e[id].voxels;
    if (markers.voxels[i] == kSkullMarker) e[id].touches_skull = true;
  }
  return e;
}

/// Marks the mandible: the largest piece in front of the pharynx, of an arch's width and depth, that does not hold to
/// the skull.
bool mark_mandible(const Hounsfield& hu, const Mask& bone, double threshold, const Frame& frame, const Airway& airway,
                   const std::optional<Vector3>& seed, Volume<std::uint8_t>& markers) {
  const double s = frame.scale;
  const double y_limit = airway.glottis.centre[1] + 25.0 * s;
  for (int raise = 0; raise <= 9; ++raise) {
    Mask dense(hu.grid);
    for (std::size_t i = 0; i < dense.voxels.size(); ++i) {
      dense.voxels[i] =
          bone.voxels[i] != 0 && hu.voxels[i] > threshold + 75.0 * raise && markers.voxels[i] != kSpineMarker ? 1 : 0;
    }
    const auto parts = components(dense);
    const auto extents = extents_of(parts, markers);
    const int seeded = seed ? piece_at(parts, *seed, 2.0 * s) : 0;
    for (std::size_t id = 1; id < extents.size(); ++id) {
      const auto& e = extents[id];
      if (e.voxels * hu.grid.voxel_mm3() < 300.0 * s * s * s) break;  // sorted by size
      if (seed && static_cast<int>(id) != seeded) continue;
      const bool arch =
          seed || (e.low[0] < frame.mid_x - 12.0 * s && e.high[0] > frame.mid_x + 12.0 * s && e.high[1] - e.low[1] > 18.0 * s &&
                   e.sum[1] / e.voxels <= y_limit && e.low[2] >= airway.glottis.centre[2] - 10.0 * s);
      if (e.touches_skull || !arch) continue;
      for (std::size_t i = 0; i < dense.voxels.size(); ++i) {
        if (parts.id.voxels[i] == static_cast<int>(id)) markers.voxels[i] = kMandibleMarker;
      }
      return true;
    }
  }
  return false;
}

/// Bone within 2 mm (term) of a point given is of that party.
void mark_seed(const Mask& bone, const char* name, const std::optional<Vector3>& seed, Marker marker, double s,
               Volume<std::uint8_t>& markers) {
  if (!seed) return;
  const Vector3 reach{2.0 * s, 2.0 * s, 2.0 * s};
  const auto box = box_between(bone.grid, *seed - reach, *seed + reach);
  bool any = false;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        if (bone.at(x, y, z) == 0 || distance(bone.grid.position(x, y, z), *seed) > 2.0 * s) continue;
        markers.at(x, y, z) = marker;
        any = true;
      }
    }
  }
  if (!any) throw std::runtime_error(std::string("the seed ") + name + " lies in no bone");
}

/// A small arch in front of the vestibule, above the glottis and below the jaw. It is thin, so the blur leaves it
/// fainter than other bone.
Mask find_hyoid(const Hounsfield& hu, const Thresholds& t, const Frame& frame, const Airway& airway, const Mask& jaws,
                const std::optional<Vector3>& seed) {
  const double s = frame.scale;
  const auto& c = airway.glottis.centre;
  Mask out(hu.grid);
  const auto box = box_between(hu.grid, c + s * Vector3{-14.0, -25.0, 0.0}, c + s * Vector3{14.0, 3.0, 20.0});
  auto dense = where(cropped(hu, box), [&](std::int16_t v) { return v > t.soft + 0.4 * (t.bone - t.soft); });
  const auto parts = components(dense);
  const auto& g = dense.grid;
  double best = 0.0;
  int hyoid = 0;
  if (seed) {
    hyoid = piece_at(parts, *seed, 2.0 * s);
    if (hyoid == 0) throw std::runtime_error("the hyoid's seed lies in no dense tissue in front of the larynx");
  }
  for (std::size_t id = 1; id < parts.sizes.size() && !seed; ++id) {
    const double volume = parts.sizes[id] * g.voxel_mm3();
    if (volume < 4.0 * s * s * s) break;
    Vector3 sum{};
    bool jaw = false;
    for (std::size_t i = 0; i < g.count(); ++i) {
      if (parts.id.voxels[i] != static_cast<int>(id)) continue;
      sum = sum + g.position(i);
      const auto v = g.cell(i);
      jaw = jaw || jaws.at(v[0] + box.low[0], v[1] + box.low[1], v[2] + box.low[2]) != 0;
    }
    const Vector3 centre = (1.0 / static_cast<double>(parts.sizes[id])) * sum;
    const double above = centre[2] - c[2];
    if (jaw || above < 1.0 * s || above > 18.0 * s || centre[1] > c[1] || std::abs(centre[0] - frame.mid_x) > 4.0 * s)
      continue;
    if (volume > best) {
      best = volume;
      hyoid = static_cast<int>(id);
    }
  }
  if (hyoid != 0) paste(parts.mask(hyoid), box, out);
  return out;
}

}  // namespace

Bones find_bones(const Hounsfield& hu, const Thresholds& t, const Frame& frame, const Head& head,
                 const Airway& airway, const BoneSeeds& seeds) {
  const auto& g = hu.grid;
  const double s = frame.scale;
  Mask bone(g);
  for (std::size_t i = 0; i < bone.voxels.size(); ++i)
    bone.voxels[i] = head.body.voxels[i] != 0 && hu.voxels[i] > t.bone ? 1 : 0;

  const auto y_back = back_wall(airway.lumen, frame);
  const auto lumen_box = bounds_of(airway.lumen);
  // Of the lumen behind the palate only: the nose's own ceiling is higher.
  double naso_top = airway.glottis.centre[2] + 57.0 * s;
  naso_top = std::min(naso_top, g.origin[2] + lumen_box.high[2] * g.spacing[2]);
  // Of a skull whose top was not scanned the upper part is less; the joints of the jaw must stay below.
  const double skull_from = std::max(frame.skull_top - 0.55 * 83.6 * s, naso_top + 15.0 * s);
  Volume<std::uint8_t> markers(g);
  for (int z = 0; z < g.size[2]; ++z) {
    const double pz = g.origin[2] + z * g.spacing[2];
    for (int y = 0; y < g.size[1]; ++y) {
      const double py = g.origin[1] + y * g.spacing[1];
      for (int x = 0; x < g.size[0]; ++x) {
        const auto i = g.index(x, y, z);
        if (bone.voxels[i] == 0) continue;
        const double px = std::abs(g.origin[0] + x * g.spacing[0] - frame.mid_x);
        if (pz > skull_from) {
          markers.voxels[i] = kSkullMarker;
        } else if (pz < naso_top - 18.0 * s && px < 9.0 * s && py > y_back[z] && py < y_back[z] + 20.0 * s) {
          markers.voxels[i] = kSpineMarker;
        }
      }
    }
  }
  Bones bones;
  mark_seed(bone, "bone_skull", seeds.skull, kSkullMarker, s, markers);
  mark_seed(bone, "spine", seeds.spine, kSpineMarker, s, markers);
  bones.mandible_free = mark_mandible(hu, bone, t.bone, frame, airway, seeds.mandible, markers);
  if (seeds.mandible && !bones.mandible_free) {
    mark_seed(bone, "bone_mandible", seeds.mandible, kMandibleMarker, s, markers);
    bones.mandible_free = true;
  }

  Volume<std::uint8_t> shares;
  {
    Volume<float> cost(g);
    for (std::size_t i = 0; i < cost.voxels.size(); ++i) cost.voxels[i] = -hu.voxels[i];
    shares = flooded(cost, markers, bone);
  }

  // Pieces that hold no marker: by where they lie.
  Mask left(g);
  for (std::size_t i = 0; i < left.voxels.size(); ++i)
    left.voxels[i] = bone.voxels[i] != 0 && shares.voxels[i] == 0 ? 1 : 0;
  const auto parts = components(left);
  const auto extents = extents_of(parts, markers);
  std::vector<std::uint8_t> share_of(extents.size(), 0);
  for (std::size_t id = 1; id < extents.size(); ++id) {
    const auto& e = extents[id];
    const double volume = e.voxels * g.voxel_mm3();
    if (volume < 4.0 * s * s * s) break;
    const std::array<double, 3> c{e.sum[0] / e.voxels, e.sum[1] / e.voxels, e.sum[2] / e.voxels};
    const int z = std::clamp(g.nearest(c)[2], 0, g.size[2] - 1);
    const bool below_face = c[2] < naso_top - 10.0 * s;
    if (below_face && c[1] > y_back[z]) {
      share_of[id] = kSpineMarker;
    } else if (c[2] > naso_top - 40.0 * s && (!below_face || volume > 20.0 * s * s * s)) {
      share_of[id] = kSkullMarker;
    }
  }
  bones.skull = Mask(g);
  bones.mandible = Mask(g);
  bones.spine = Mask(g);
  for (std::size_t i = 0; i < left.voxels.size(); ++i) {
    const int id = parts.id.voxels[i];
    const int share = id != 0 ? share_of[id] : shares.voxels[i];
    bones.skull.voxels[i] = share == kSkullMarker ? 1 : 0;
    bones.mandible.voxels[i] = share == kMandibleMarker ? 1 : 0;
    bones.spine.voxels[i] = share == kSpineMarker ? 1 : 0;
  }
  bones.hyoid = find_hyoid(hu, t, frame, airway, any_of(bones.mandible, inverted(head.body)),
                           seeds.hyoid);
  bones.hyoid_seen = count(bones.hyoid) > 0;
  return bones;
}

}  // namespace vallecula::pipeline

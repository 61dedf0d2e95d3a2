#include "pipeline/segment/tongue.h"

#include <algorithm>
#include <cmath>

namespace vallecula::pipeline {
namespace {

enum Marker : std::uint8_t { kTongueMarker = 1, kOtherMarker = 2 };

/// Grey values of the tissue alone, smoothed: air and its partial-volume rim do not darken the tissue beside it.
Volume<float> smoothed_tissue(const Hounsfield& hu, const Mask& body, const Thresholds& t, double sigma_mm) {
  Volume<float> value(hu.grid);
  Volume<float> weight(hu.grid);
  for (std::size_t i = 0; i < hu.voxels.size(); ++i) {
    const bool use = body.voxels[i] != 0 && hu.voxels[i] > t.fat - 130.0;
    weight.voxels[i] = use ? 1.0F : 0.0F;
    value.voxels[i] = use ? std::min<float>(hu.voxels[i], 150.0F) : 0.0F;
  }
  value = smoothed(value, sigma_mm);
  weight = smoothed(weight, sigma_mm);
  for (std::size_t i = 0; i < value.voxels.size(); ++i) {
    value.voxels[i] = weight.voxels[i] > 0.05F ? value.voxels[i] / weight.voxels[i] : static_cast<float>(t.fat);
  }
  return value;
}

/// The tissue first met going down from the air under the palate, a little below its surface.
Mask seed_under_dorsum(const TongueSearch& in, const Volume<float>& tissue, const Volume<float>& to_air,
                       const Volume<float>& to_bone) {
  const auto& g = in.body.grid;
  const double s = in.frame.scale;
  Mask seed(g);
  double jaw_inner = -1e9;  // back of the symphysis
  const auto jaw = bounds_of(in.mandible);
  if (jaw.empty()) return seed;
  for (int z = jaw.low[2]; z <= jaw.high[2]; ++z) {
    for (int y = jaw.low[1]; y <= jaw.high[1]; ++y) {
      const int x = std::clamp(g.nearest({in.frame.mid_x, 0, 0})[0], 0, g.size[0] - 1);
      if (in.mandible.at(x, y, z) != 0) jaw_inner = std::max(jaw_inner, g.origin[1] + y * g.spacing[1]);
    }
  }
  const double back =
      in.epiglottis.seen ? in.epiglottis.vallecula[1] - 3.0 * s : in.airway.front_commissure[1] - 3.0 * s;
  for (int x = 0; x < g.size[0]; ++x) {
    if (std::abs(g.origin[0] + x * g.spacing[0] - in.frame.mid_x) > 5.0 * s) continue;
    for (int y = 0; y < g.size[1]; ++y) {
      const double py = g.origin[1] + y * g.spacing[1];
      if (py < jaw_inner + 3.0 * s || py > back) continue;
      // The tallest run of air in this column is the mouth; below it lies the dorsum.
      int best = 0;
      int bottom = -1;
      int run = 0;
      for (int z = g.size[2] - 1; z >= 0; --z) {
        run = in.lumen.at(x, y, z) != 0 ? run + 1 : 0;
        if (run > best) {
          best = run;
          bottom = z;
        }
      }
      if (best * g.spacing[2] < 2.0 * s) continue;
      for (int z = bottom - 1; z >= 0 && (bottom - z) * g.spacing[2] < 8.0 * s; --z) {
        const auto i = g.index(x, y, z);
        if (in.body.voxels[i] == 0) break;
        if ((bottom - z) * g.spacing[2] > 1.5 * s && tissue.voxels[i] < in.t.fat + 0.4 * (in.t.soft - in.t.fat)) break;
        if (to_air.voxels[i] > 2.0 * s && to_bone.voxels[i] > 4.0 * s) seed.voxels[i] = 1;
      }
    }
  }
  // The root: the front wall of the pharynx from the dorsum down to the vallecula.
  if (!in.epiglottis.seen || count(seed) == 0) return seed;
  const auto box = bounds_of(seed);
  for (int z = 0; z <= box.high[2]; ++z) {
    if (g.origin[2] + z * g.spacing[2] < in.epiglottis.vallecula[2] + 1.0 * s) continue;
    for (int x = 0; x < g.size[0]; ++x) {
      if (std::abs(g.origin[0] + x * g.spacing[0] - in.frame.mid_x) > 4.0 * s) continue;
      int y = std::clamp(g.nearest({0, in.epiglottis.vallecula[1], 0})[1], 0, g.size[1] - 1);
      // From the air in front of the leaf forwards; higher up the wall may lie behind the vallecula's level.
      while (y + 1 < g.size[1] && in.lumen.at(x, y, z) == 0 && in.body.at(x, y, z) != 0 &&
             g.origin[1] + y * g.spacing[1] < in.epiglottis.vallecula[1] + 5.0 * s) {
        ++y;
      }
      if (in.lumen.at(x, y, z) == 0) continue;
      while (y > 0 && in.lumen.at(x, y, z) != 0) --y;
      for (int k = y; k > 0 && (y - k) * g.spacing[1] < 5.0 * s; --k) {
        const auto i = g.index(x, k, z);
        if (in.body.voxels[i] == 0) break;
        const bool dark = tissue.voxels[i] < in.t.fat + 0.4 * (in.t.soft - in.t.fat);
        if (dark && (y - k) * g.spacing[1] > 1.5 * s) break;
        if (to_air.voxels[i] > 1.5 * s && to_bone.voxels[i] > 4.0 * s) seed.voxels[i] = 1;
      }
    }
  }
  return seed;
}

}  // namespace

Tongue find_tongue(const TongueSearch& in, const MouthBounds& bounds) {
  const auto& g = in.body.grid;
  const double s = in.frame.scale;
  // A dose as low as for an infant makes grain in which the fat plane drowns unless it is smoothed more.
  constexpr double kGrainy = 25.0;
  const double grain = std::clamp(in.t.noise / kGrainy, 1.0, 2.0);
  const auto tissue = smoothed_tissue(in.hu, in.body, in.t, grain * std::max(0.45, 0.5 * s));
  const auto bone = any_of(in.skull, in.mandible);
  const auto to_bone = distance_to(bone);
  const auto to_air = distance_to(in.lumen);
  const auto enough = [&](const Mask& mask) { return count(mask) * g.voxel_mm3() >= 5.0 * s * s * s; };
  Tongue out;
  out.mask = Mask(g);
  auto seed = seed_under_dorsum(in, tissue, to_air, to_bone);
  out.mouth_closed = in.lips_closed || !enough(seed);
  const bool bounded = out.mouth_closed && bounds.found;
  Mask outside(g);
  if (out.mouth_closed) seed = Mask(g);
  if (bounded) {
    seed = eroded(bounds.tongue, 2.6 * s);
    outside = any_of(inverted(dilated(bounds.tongue, 0.8 * s)), bounds.soft_palate);
  }
  if (in.seed) {
    for (std::size_t i = 0; i < seed.voxels.size(); ++i) {
      if (distance(g.position(i), *in.seed) < 7.0 * s && in.body.voxels[i] != 0 && to_bone.voxels[i] > 2.0 * s)
        seed.voxels[i] = 1;
    }
  }
  if (!enough(seed)) return out;
  const auto seed_box = bounds_of(seed);
  const double seed_top = g.origin[2] + seed_box.high[2] * g.spacing[2];
  Vector3 centre{};
  for (std::size_t i = 0; i < seed.voxels.size(); ++i) {
    if (seed.voxels[i] != 0) centre = centre + g.position(i);
  }
  centre = (1.0 / static_cast<double>(count(seed))) * centre;

  const auto to_skin = distance_to(inverted(in.inside));
  const double vallecula_z = in.epiglottis.seen ? in.epiglottis.vallecula[2] : in.airway.front_commissure[2] + 7.0 * s;
  const double vallecula_y = in.epiglottis.seen ? in.epiglottis.vallecula[1] : in.airway.front_commissure[1];
  const double lowest = std::min(vallecula_z - 7.0 * s, in.airway.front_commissure[2] + 1.0 * s);
  const auto walls = distance_to(in.mandible);
  Volume<std::uint8_t> markers(g);
  Mask allowed(g);
  for (std::size_t i = 0; i < markers.voxels.size(); ++i) {
    if (in.body.voxels[i] == 0 || in.epiglottis.mask.voxels[i] != 0 || in.hyoid.voxels[i] != 0) continue;
    if (bounded && in.hu.voxels[i] > in.t.bone) continue;  // teeth and what is thinner than bone's own pieces
    allowed.voxels[i] = 1;
    if (seed.voxels[i] != 0) {
      markers.voxels[i] = kTongueMarker;
      continue;
    }
    const auto p = g.position(i);
    const bool near_bone = walls.voxels[i] < 1.2 * s || to_bone.voxels[i] < 1.2 * s;
    const bool near_skin = to_skin.voxels[i] < 4.0 * s;
    const bool low = p[2] < lowest;
    const bool behind = p[1] > vallecula_y + 4.0 * s && p[2] < seed_top - 4.0 * s;
    const bool far = distance(p, centre) > 32.0 * s || std::abs(p[0] - in.frame.mid_x) > 20.0 * s;
    // The palate: further above the seed than a tongue is thick, with air between or not.
    const bool high = p[2] > seed_top + 14.0 * s;
    const bool other = bounded ? outside.voxels[i] != 0 : near_skin || low || behind || far || high;
    if (near_bone || other) markers.voxels[i] = kOtherMarker;
  }
  // Both the dark fat plane and the bright rim of the hyoid, which lies in it, are ridges; to cross one costs as much
  // as a way of tens of mm. Grain is not told from a faint ridge: it makes the way dearer for both parties alike, while
  // what it breaks out of the plane lets one of them through. Where rules bound a closed mouth the tongue lies against
  // muscle, not fat, and a faint streak in it is no border: without this band a real tongue's back stayed with the
  // palate, and the mouth could not be opened there.
  const double quiet = bounded ? 12.0 : 0.0;
  Volume<float> cost(g);
  for (std::size_t i = 0; i < cost.voxels.size(); ++i) {
    const double off = tissue.voxels[i] - in.t.soft;
    const double ridge = std::clamp(off < 0.0 ? (-off - quiet) / 60.0 : (off - quiet - 28.0) / 100.0, 0.0, 1.0);
    cost.voxels[i] = static_cast<float>(1.0 + 60.0 * ridge);
  }
  const auto shares = shared_by_travel(cost, markers, allowed);
  auto tongue = where(shares, [](std::uint8_t v) { return v == kTongueMarker; });
  // Fat is not tongue: trim the half of the plane that the watershed gave to it.
  for (std::size_t i = 0; i < tongue.voxels.size(); ++i) {
    const bool fat = tissue.voxels[i] < in.t.fat + 0.5 * (in.t.soft - in.t.fat) && to_air.voxels[i] > 1.2 * s;
    // The middle of a real tongue has fat between its muscles.
    if (fat && !(bounded && seed.voxels[i] != 0)) tongue.voxels[i] = 0;
  }
  // Strands that leaked through a gap of the plane are thinner than the tongue.
  const bool ragged = out.mouth_closed;  // without a border all round it has the holes that noise and streaks leave
  if (ragged) tongue = without(all_of(closed(tongue, 2.0 * s), allowed), outside);
  const auto core = opened(tongue, ragged ? 2.0 * s : 0.8 * s);
  tongue = largest_component(all_of(tongue, dilated(largest_component(core), 1.0 * s)));
  out.mask = with_holes_filled(tongue);
  if (bounded && in.epiglottis.seen) {
    // The ligament between hyoid and leaf is fat to the scanner, and yet what holds the two together.
    auto ligament = all_of(bounds.tongue, dilated(in.epiglottis.mask, 2.2 * s));
    for (std::size_t i = 0; i < ligament.voxels.size(); ++i) {
      if (g.position(i)[2] > in.epiglottis.vallecula[2] + 6.0 * s || allowed.voxels[i] == 0) ligament.voxels[i] = 0;
    }
    out.mask = largest_component(any_of(out.mask, ligament));
  }
  if (out.mouth_closed) out.mask = all_of(out.mask, in.body);  // gas between tongue and leaf is no hole of the tongue
  return out;
}

}  // namespace vallecula::pipeline

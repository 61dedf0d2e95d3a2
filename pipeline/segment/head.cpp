#include "pipeline/segment/head.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace vallecula::pipeline {
namespace {

/// Every k-th voxel (the one in the middle of its block).
Mask thinned(const Mask& mask, const std::array<int, 3>& k) {
  Grid g = mask.grid;
  for (int a = 0; a < 3; ++a) {
    g.size[a] = (mask.grid.size[a] + k[a] - 1) / k[a];
    g.spacing[a] = mask.grid.spacing[a] * k[a];
  }
  Mask out(g);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) out.at(x, y, z) = mask.at(x * k[0], y * k[1], z * k[2]);
    }
  }
  return out;
}

/// Air of one sagittal slice that has tissue both above and below it: candidates for the inside of the mouth.
struct Slice2d {
  int ny = 0;
  int nz = 0;
  std::vector<std::uint8_t> gap;
  std::uint8_t& at(int y, int z) { return gap[static_cast<std::size_t>(z) * ny + y]; }
};

Slice2d column_gaps(const Mask& body, int x, double largest_mm) {
  const auto& g = body.grid;
  Slice2d s{g.size[1], g.size[2], std::vector<std::uint8_t>(static_cast<std::size_t>(g.size[1]) * g.size[2], 0)};
  for (int y = 0; y < g.size[1]; ++y) {
    int last = -1;  // last tissue below
    for (int z = 0; z < g.size[2]; ++z) {
      if (body.at(x, y, z) == 0) continue;
      if (last >= 0 && z - last > 1 && (z - last) * g.spacing[2] < largest_mm) {
        for (int k = last + 1; k < z; ++k) s.at(y, k) = 1;
      }
      last = z;
    }
  }
  return s;
}

using Piece = std::vector<std::array<int, 2>>;

/// The largest connected piece of the gaps (touching `near`, when that is not empty; else of those `wanted`), as a list
/// of (y, z).
Piece gap_piece(Slice2d s, const Piece& near, const std::function<bool(const Piece&)>& wanted = {}) {
  std::vector<std::array<int, 2>> best;
  const auto flood = [&](int y0, int z0) {
    std::vector<std::array<int, 2>> piece{{y0, z0}};
    s.at(y0, z0) = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const auto [y, z] = piece[i];
      constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
      for (const auto& d : kSteps) {
        const int ny = y + d[0];
        const int nz = z + d[1];
        if (ny < 0 || nz < 0 || ny >= s.ny || nz >= s.nz || s.at(ny, nz) == 0) continue;
        s.at(ny, nz) = 0;
        piece.push_back({ny, nz});
      }
    }
    if (piece.size() > best.size() && (!wanted || wanted(piece))) best = std::move(piece);
  };
  if (!near.empty()) {
    for (const auto& p : near) {
      if (s.at(p[0], p[1]) != 0) flood(p[0], p[1]);
    }
    return best;
  }
  for (int z = 0; z < s.nz; ++z) {
    for (int y = 0; y < s.ny; ++y) {
      if (s.at(y, z) != 0) flood(y, z);
    }
  }
  return best;
}

/// The lip's edge is where it looks both forwards and into the gap: the tissue furthest in that diagonal direction.
LipGap lip_edges(const Mask& body, int x, const std::vector<std::array<int, 2>>& piece, double scale) {
  const auto& g = body.grid;
  int front = std::numeric_limits<int>::max();
  for (const auto& p : piece) front = std::min(front, p[0]);
  const double y_front = g.origin[1] + front * g.spacing[1];
  int low = std::numeric_limits<int>::max();
  int high = -1;
  for (const auto& p : piece) {
    if (p[0] != front) continue;
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  LipGap gap;
  gap.x = x;
  const double middle = 0.5 * (low + high);
  const int reach_y = static_cast<int>(std::ceil(4.0 * scale / g.spacing[1]));
  const int reach_z = static_cast<int>(std::ceil(5.0 * scale / g.spacing[2]));
  double best_upper = 1e30;
  double best_lower = 1e30;
  for (int y = std::max(0, front - reach_y); y < std::min(g.size[1], front + reach_y); ++y) {
    const double py = g.origin[1] + y * g.spacing[1];
    for (int z = std::max(0, low - reach_z); z <= std::min(g.size[2] - 1, high + reach_z); ++z) {
      if (body.at(x, y, z) == 0) continue;
      const double pz = g.origin[2] + z * g.spacing[2];
      if (z > middle && py + pz < best_upper) {
        best_upper = py + pz;
        gap.upper = {py, pz};
      }
      if (z < middle && py - pz < best_lower) {
        best_lower = py - pz;
        gap.lower = {py, pz};
      }
    }
  }
  if (best_upper > 1e29) gap.upper = {y_front, g.origin[2] + high * g.spacing[2]};
  if (best_lower > 1e29) gap.lower = {y_front, g.origin[2] + low * g.spacing[2]};
  return gap;
}

/// y of the lip line at a height; beyond the edges it goes straight on.
double lip_line(const LipGap& gap, double z) {
  const double height = gap.upper[1] - gap.lower[1];
  if (!(height > 1e-6)) return std::min(gap.upper[0], gap.lower[0]);
  const double f = std::clamp((z - gap.lower[1]) / height, -0.3, 1.3);
  return gap.lower[0] + f * (gap.upper[0] - gap.lower[0]);
}

/// Marks the air of the open mouth behind the lip line; returns the lines found.
std::vector<LipGap> close_mouth(const Mask& body, const Frame& frame, Mask& mouth) {
  const auto& g = body.grid;
  const double s = frame.scale;
  const int mid = std::clamp(g.nearest({frame.mid_x, 0, 0})[0], 0, g.size[0] - 1);
  // The cheeks close the mouth at both sides; the hollow between chin and chest is open there.
  const auto between_cheeks = [&](const Piece& piece) {
    std::size_t open = 0;
    for (const double side : {-22.0, 22.0}) {
      const int x = std::clamp(g.nearest({frame.mid_x + side * s, 0, 0})[0], 0, g.size[0] - 1);
      for (const auto& p : piece) open += body.at(x, p[0], p[1]) == 0 ? 1 : 0;
    }
    return 5 * open < 6 * piece.size();
  };
  const auto first = gap_piece(column_gaps(body, mid, 45.0 * s), {}, between_cheeks);
  int front = std::numeric_limits<int>::max();
  int back = -1;
  for (const auto& p : first) {
    front = std::min(front, p[0]);
    back = std::max(back, p[0]);
  }
  std::vector<LipGap> lips;
  // An open mouth is a deep hole; a shallow one is the notch under the nose or the chin.
  if (first.empty() || (back - front) * g.spacing[1] < 15.0 * s) return lips;
  int first_low = std::numeric_limits<int>::max();
  int first_high = -1;
  for (const auto& p : first) {
    if (p[0] > front + 6.0 * s / g.spacing[1]) continue;
    first_low = std::min(first_low, p[1]);
    first_high = std::max(first_high, p[1]);
  }
  if ((first_high - first_low) * g.spacing[2] < 5.0 * s) return lips;  // closed lips, gas behind them
  const auto middle = lip_edges(body, mid, first, s);
  if (middle.upper[1] - middle.lower[1] < 5.0 * s) return lips;

  struct Slice {
    LipGap gap;
    std::vector<std::array<int, 2>> piece;
    int front = 0;
  };
  std::vector<Slice> slices;
  for (const int side : {1, -1}) {
    auto previous = first;
    for (int x = side > 0 ? mid : mid - 1; x >= 0 && x < g.size[0]; x += side) {
      if (std::abs(x - mid) * g.spacing[0] > 25.0 * s) break;
      auto piece = gap_piece(column_gaps(body, x, 45.0 * s), previous);
      if (piece.empty()) break;
      int piece_front = std::numeric_limits<int>::max();
      for (const auto& p : piece) piece_front = std::min(piece_front, p[0]);
      // Behind the corner of the mouth the slice meets the hollow of the cheek, not the lips.
      if ((piece_front - front) * g.spacing[1] > 12.0 * s) break;
      slices.push_back({lip_edges(body, x, piece, s), piece, piece_front});
      previous = std::move(piece);
    }
  }
  std::sort(slices.begin(), slices.end(), [](const Slice& a, const Slice& b) { return a.gap.x < b.gap.x; });
  // The lips are smooth from side to side; their voxels are not.
  const double reach = 2.0 * s / g.spacing[0];
  for (const auto& slice : slices) {
    LipGap gap;
    gap.x = slice.gap.x;
    double weight = 0.0;
    for (const auto& other : slices) {
      const double away = (other.gap.x - slice.gap.x) / reach;
      const double w = std::exp(-away * away);
      for (int a = 0; a < 2; ++a) {
        gap.upper[a] += w * other.gap.upper[a];
        gap.lower[a] += w * other.gap.lower[a];
      }
      weight += w;
    }
    for (int a = 0; a < 2; ++a) {
      gap.upper[a] /= weight;
      gap.lower[a] /= weight;
    }
    for (const auto& p : slice.piece) {
      if (g.origin[1] + p[0] * g.spacing[1] >= lip_line(gap, g.origin[2] + p[1] * g.spacing[2]))
        mouth.at(gap.x, p[0], p[1]) = 1;
    }
    // Columns in front of one lip's foremost point but behind the line have no tissue on that side.
    for (int z = 0; z < g.size[2]; ++z) {
      const double pz = g.origin[2] + z * g.spacing[2];
      if (pz < gap.lower[1] || pz > gap.upper[1]) continue;
      const int from = std::max(0, static_cast<int>(std::ceil((lip_line(gap, pz) - g.origin[1]) / g.spacing[1])));
      for (int y = from; y < std::min(g.size[1], slice.front + 1); ++y) {
        if (body.at(gap.x, y, z) == 0) mouth.at(gap.x, y, z) = 1;
      }
    }
    lips.push_back(gap);
  }
  return lips;
}

}  // namespace

Thresholds thresholds_of(const Hounsfield& hu) {
  constexpr int kLow = -1100;
  constexpr int kBin = 10;
  constexpr int kBins = 320;
  std::vector<std::size_t> histogram(kBins, 0);
  for (const auto v : hu.voxels) {
    const int bin = (v - kLow) / kBin;
    if (v >= kLow && bin < kBins) ++histogram[bin];
  }
  const auto peak = [&](int from, int to) {
    int best = (from - kLow) / kBin;
    for (int b = best; b < (to - kLow) / kBin; ++b) {
      if (histogram[b] > histogram[best]) best = b;
    }
    return kLow + (best + 0.5) * kBin;
  };
  const double air = peak(-1080, -800);
  Thresholds t;
  t.soft = peak(0, 100);
  t.air = 0.5 * (air + t.soft);
  // Thick slices mix the narrow passages of the nose with their walls: half way would cut them.
  if (hu.grid.spacing[2] > 1.6) t.air = std::max(t.air, -400.0);
  constexpr double kFat = -90.0;
  t.fat = 0.5 * (kFat + t.soft);
  // Bone: half way to the dense four fifths' mark of what is surely bone (thin plates are dimmed by the blur), within
  // what is usual.
  std::size_t all = 0;
  for (int b = (200 - kLow) / kBin; b < kBins; ++b) all += histogram[b];
  std::size_t sum = 0;
  int b = (200 - kLow) / kBin;
  while (b < kBins - 1 && 5 * (sum += histogram[b]) < 4 * all) ++b;
  t.bone = std::clamp(0.5 * (t.soft + kLow + (b + 0.5) * kBin), 200.0, 330.0);
  return t;
}

Mask find_body(const Hounsfield& hu, const Thresholds& t) {
  const auto tissue = where(hu, [&](std::int16_t v) { return v > t.air; });
  std::array<int, 3> k{};
  const double fine =
      std::clamp(std::cbrt(static_cast<double>(count(tissue)) * tissue.grid.voxel_mm3()) / 80.0, 1.2, 3.0);
  for (int a = 0; a < 3; ++a) k[a] = std::max(1, static_cast<int>(std::lround(fine / tissue.grid.spacing[a])));
  const auto coarse = thinned(tissue, k);
  // In proportion to the patient, so that a couch under an adult is cut off and the lips of a preterm infant are not.
  const auto whole_tissue = components(coarse);
  if (whole_tissue.sizes.size() < 2)
    throw std::runtime_error("the series shows no tissue, only air; name the folder of a CT of the head");
  const double radius = 0.045 * std::cbrt(static_cast<double>(whole_tissue.sizes[1]) * coarse.grid.voxel_mm3());
  const auto core = largest_component(opened(coarse, radius));
  const auto near = dilated(core, radius + 4.0);
  const auto& c = near.grid;
  Mask allowed(tissue.grid);
  Mask seed(tissue.grid);
  for (int z = 0; z < tissue.grid.size[2]; ++z) {
    const int cz = std::min(z / k[2], c.size[2] - 1);
    for (int y = 0; y < tissue.grid.size[1]; ++y) {
      const int cy = std::min(y / k[1], c.size[1] - 1);
      for (int x = 0; x < tissue.grid.size[0]; ++x) {
        const auto i = tissue.grid.index(x, y, z);
        if (tissue.voxels[i] == 0) continue;
        const int cx = std::min(x / k[0], c.size[0] - 1);
        allowed.voxels[i] = near.at(cx, cy, cz);
        seed.voxels[i] = core.at(cx, cy, cz);
      }
    }
  }
  auto body = grown(seed, allowed);
  if (count(body) * hu.grid.voxel_mm3() < 2e4) {
    throw std::runtime_error("no head was found; the series must show the head from above the palate to the trachea");
  }
  return body;
}

Frame frame_of(const Hounsfield& hu, const Mask& body, const Thresholds& t) {
  const auto& g = hu.grid;
  struct Extent {
    double low = 0.0;
    double high = 0.0;
    bool any = false;
  };
  std::vector<Extent> slices(g.size[2]);
  for (int z = 0; z < g.size[2]; ++z) {
    std::vector<std::size_t> columns(g.size[0], 0);
    std::size_t all = 0;
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        if (hu.at(x, y, z) < t.bone || body.at(x, y, z) == 0) continue;
        ++columns[x];
        ++all;
      }
    }
    if (all * g.spacing[0] * g.spacing[1] < 40.0) continue;  // mm^2: noise or a wire
    // Half a per cent at each side may be metal or couch.
    std::size_t sum = 0;
    int low = 0;
    while (sum + columns[low] <= all / 200) sum += columns[low++];
    sum = 0;
    int high = g.size[0] - 1;
    while (sum + columns[high] <= all / 200) sum += columns[high--];
    slices[z] = {low * g.spacing[0], high * g.spacing[0], true};
  }
  int top = g.size[2] - 1;
  while (top >= 0 && !slices[top].any) --top;
  if (top < 0)
    throw std::runtime_error("no bone was found; the series must show the head from above the palate to the trachea");
  // The skull is widest within its own breadth of the vertex; shoulders come later.
  double breadth = 0.0;
  std::vector<double> middles;
  for (int z = top; z >= 0; --z) {
    const double depth = (top - z) * g.spacing[2];
    if (breadth > 0.0 && depth > 0.9 * breadth && depth > 30.0) break;
    if (!slices[z].any) continue;
    breadth = std::max(breadth, slices[z].high - slices[z].low);
    middles.push_back(g.origin[0] + 0.5 * (slices[z].low + slices[z].high));
  }
  // The smallest infant's skull is 0.6 of the term infant's.
  if (breadth < 0.5 * 83.6) {
    throw std::runtime_error(
        "no skull was found, only narrower bones: the series begins below the palate or shows another part of the "
        "body; "
        "name a CT that reaches from above the palate to below the larynx");
  }
  Frame frame;
  frame.scale = std::min(breadth / 83.6, 2.4);
  std::nth_element(middles.begin(), middles.begin() + middles.size() / 2, middles.end());
  frame.mid_x = middles[middles.size() / 2];
  frame.skull_top = g.origin[2] + top * g.spacing[2];
  return frame;
}

Head find_head(const Hounsfield& hu, const Mask& body, const Thresholds& t, const Frame& frame) {
  const auto tissue = where(hu, [&](std::int16_t v) { return v > t.air; });
  Head head;
  head.body = body;
  Mask mouth(hu.grid);
  head.lips = close_mouth(head.body, frame, mouth);
  auto shut = any_of(head.body, mouth);
  {
    // The ball closes the nostrils and other narrow ways in. Only the front of the face needs it.
    const auto face = bounds_of(head.body);
    const auto& g = hu.grid;
    const double front = g.origin[1] + face.low[1] * g.spacing[1];
    const double s = frame.scale;
    const auto box = box_between(g, {frame.mid_x - 22.0 * s, front - 8.0 * s, -1e6},
                                 {frame.mid_x + 22.0 * s, front + 30.0 * s, 1e6});
    const auto part = cropped(shut, box);
    paste(any_of(part, closed(part, 3.0 * s)), box, shut);
  }
  const auto& g = hu.grid;
  Mask border(g);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        // Not the lowest slice: there the trachea and the neck are cut open.
        if (x == 0 || y == 0 || x == g.size[0] - 1 || y == g.size[1] - 1 || z == g.size[2] - 1) border.at(x, y, z) = 1;
      }
    }
  }
  head.inside = inverted(grown(border, inverted(shut)));
  // What the ball closed on the outside of the face (folds of lips, nose and ears) is not inside the head, unless it
  // leads inside.
  const auto air_inside = without(head.inside, tissue);
  const auto deep = without(air_inside, without(shut, any_of(head.body, mouth)));
  const auto kept = grown(deep, air_inside);
  head.inside = any_of(any_of(head.body, kept), all_of(head.inside, tissue));
  head.inside = all_of(head.inside, inverted(without(air_inside, kept)));
  head.body = all_of(head.inside, tissue);
  return head;
}

}  // namespace vallecula::pipeline

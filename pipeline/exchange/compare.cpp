#include "pipeline/exchange/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {
namespace {

/// The box of a label's voxels in either map, a voxel wider: the surface needs to see what lies beside it.
Box box_of(const std::vector<std::uint16_t>& a, const std::vector<std::uint16_t>& b, std::uint16_t bit, const Grid& g) {
  Box box;
  box.low = g.size;
  std::size_t i = 0;
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x, ++i) {
        if (((a[i] | b[i]) & bit) == 0) continue;
        const std::array<int, 3> c{x, y, z};
        for (int k = 0; k < 3; ++k) {
          box.low[k] = std::min(box.low[k], c[k]);
          box.high[k] = std::max(box.high[k], c[k]);
        }
      }
    }
  }
  for (int k = 0; k < 3; ++k) {
    box.low[k] = std::max(0, box.low[k] - 1);
    box.high[k] = std::min(g.size[k] - 1, box.high[k] + 1);
  }
  return box;
}

Mask mask_in(const std::vector<std::uint16_t>& sets, std::uint16_t bit, const Grid& g, const Box& box) {
  Mask mask(cropped(g, box));
  std::size_t to = 0;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      const std::size_t row = g.index(box.low[0], y, z);
      for (int x = 0; x < mask.grid.size[0]; ++x) mask.voxels[to++] = (sets[row + x] & bit) != 0 ? 1 : 0;
    }
  }
  return mask;
}

/// Voxels with a neighbour outside; the grid's own edge is outside.
Mask surface_of(const Mask& mask) {
  const auto& g = mask.grid;
  Mask out(g);
  const auto zero = [&](int x, int y, int z) { return !g.contains(x, y, z) || mask.at(x, y, z) == 0; };
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        if (mask.at(x, y, z) == 0) continue;
        out.at(x, y, z) = zero(x - 1, y, z) || zero(x + 1, y, z) || zero(x, y - 1, z) || zero(x, y + 1, z) ||
                                  zero(x, y, z - 1) || zero(x, y, z + 1)
                              ? 1
                              : 0;
      }
    }
  }
  return out;
}

/// Distances from the voxels of one surface to the other.
std::vector<float> distances(const Mask& from, const Mask& to) {
  const auto field = distance_to(to);
  std::vector<float> out;
  for (std::size_t i = 0; i < from.voxels.size(); ++i) {
    if (from.voxels[i] != 0) out.push_back(field.voxels[i]);
  }
  return out;
}

/// The least distance that 95 of 100 do not exceed.
double percentile_95(std::vector<float>& values) {
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size()))) - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

void measure(const Mask& a, const Mask& b, LabelAgreement& out) {
  const auto surface_a = surface_of(a);
  const auto surface_b = surface_of(b);
  double sum = 0.0;
  std::size_t n = 0;
  for (auto way : {distances(surface_a, surface_b), distances(surface_b, surface_a)}) {
    for (const float d : way) {
      out.hausdorff_mm = std::max<double>(out.hausdorff_mm, d);
      sum += d;
    }
    n += way.size();
    out.hausdorff_95_mm = std::max(out.hausdorff_95_mm, percentile_95(way));
  }
  out.mean_surface_mm = sum / static_cast<double>(n);
}

/// The image's own axes as a grid: distances do not depend on how it lies in the patient.
Grid straightened(const Placement& place) {
  const auto s = place.spacing();
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    if (std::abs(dot(place.step[a], place.step[b])) > 1e-3 * s[a] * s[b])
      throw LabelMapError("compare: the axes of the first label map are not at right angles; resample it first");
  }
  Grid grid;
  grid.size = place.size;
  grid.spacing = s;
  return grid;
}

}  // namespace

Comparison compare_labels(const LabelImage& a, const LabelImage& b) {
  const auto grid = straightened(a.place);
  Comparison out;
  out.resampled = !same_place(a.place, b.place);
  std::vector<std::uint16_t> resampled;
  if (out.resampled) {
    resampled = sets_at(b, a.place);
    if (std::all_of(resampled.begin(), resampled.end(), [](std::uint16_t set) { return set == 0; }))
      throw LabelMapError(
          "compare: the second label map has no structure within the first's field of view; are they of the same scan "
          "and in the same frame?");
  }
  const auto& in_b = out.resampled ? resampled : b.sets;
  for (const auto& label : kLabelNames) {
    const auto bit = bit_of(label.value);
    LabelAgreement item;
    item.label = label.value;
    std::size_t both = 0;
    for (std::size_t i = 0; i < a.sets.size(); ++i) {
      const bool of_a = (a.sets[i] & bit) != 0;
      const bool of_b = (in_b[i] & bit) != 0;
      item.voxels[0] += of_a ? 1 : 0;
      item.voxels[1] += of_b ? 1 : 0;
      both += of_a && of_b ? 1 : 0;
    }
    const auto all = item.voxels[0] + item.voxels[1];
    if (all == 0) continue;
    for (int k = 0; k < 2; ++k) item.millilitres[k] = static_cast<double>(item.voxels[k]) * grid.voxel_mm3() / 1000.0;
    item.dice = 2.0 * static_cast<double>(both) / static_cast<double>(all);
    if (item.voxels[0] > 0 && item.voxels[1] > 0) {
      const auto box = box_of(a.sets, in_b, bit, grid);
      measure(mask_in(a.sets, bit, grid, box), mask_in(in_b, bit, grid, box), item);
    } else {
      item.hausdorff_mm = item.hausdorff_95_mm = item.mean_surface_mm = std::numeric_limits<double>::quiet_NaN();
    }
    out.structures.push_back(item);
  }
  return out;
}

}  // namespace vallecula::pipeline

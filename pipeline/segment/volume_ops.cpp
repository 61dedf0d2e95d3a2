#include "pipeline/segment/volume_ops.h"

#include <algorithm>
#include <numeric>

#include "pipeline/segment/runs.h"

namespace vallecula::pipeline {

Box whole(const Grid& grid) { return {{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}}; }

Box bounds_of(const Mask& mask, double margin_mm) {
  const auto& g = mask.grid;
  Box box{g.size, {-1, -1, -1}};
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      const auto* row = mask.voxels.data() + g.index(0, y, z);
      const int first = next_set(row, 0, g.size[0]);
      if (first == g.size[0]) continue;
      int last = g.size[0] - 1;
      while (row[last] == 0) --last;
      const std::array<int, 3> low{first, y, z};
      const std::array<int, 3> high{last, y, z};
      for (int a = 0; a < 3; ++a) {
        box.low[a] = std::min(box.low[a], low[a]);
        box.high[a] = std::max(box.high[a], high[a]);
      }
    }
  }
  if (box.empty()) return box;
  for (int a = 0; a < 3; ++a) {
    const int margin = static_cast<int>(std::ceil(margin_mm / g.spacing[a]));
    box.low[a] = std::max(0, box.low[a] - margin);
    box.high[a] = std::min(g.size[a] - 1, box.high[a] + margin);
  }
  return box;
}

Box box_between(const Grid& grid, const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const auto i = grid.nearest(a);
  const auto j = grid.nearest(b);
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = std::clamp(std::min(i[k], j[k]), 0, grid.size[k] - 1);
    box.high[k] = std::clamp(std::max(i[k], j[k]), 0, grid.size[k] - 1);
  }
  return box;
}

Grid cropped(const Grid& grid, const Box& box) {
  Grid out = grid;
  for (int a = 0; a < 3; ++a) {
    out.size[a] = box.high[a] - box.low[a] + 1;
    out.origin[a] = grid.origin[a] + box.low[a] * grid.spacing[a];
  }
  return out;
}

std::size_t count(const Mask& mask) { return std::accumulate(mask.voxels.begin(), mask.voxels.end(), std::size_t{0}); }

Mask all_of(const Mask& a, const Mask& b) {
  Mask out(a.grid);
  for (std::size_t i = 0; i < a.voxels.size(); ++i) out.voxels[i] = a.voxels[i] & b.voxels[i];
  return out;
}

Mask any_of(const Mask& a, const Mask& b) {
  Mask out(a.grid);
  for (std::size_t i = 0; i < a.voxels.size(); ++i) out.voxels[i] = a.voxels[i] | b.voxels[i];
  return out;
}

Mask without(const Mask& a, const Mask& b) {
  Mask out(a.grid);
  for (std::size_t i = 0; i < a.voxels.size(); ++i) out.voxels[i] = a.voxels[i] & (1 - b.voxels[i]);
  return out;
}

Mask inverted(const Mask& a) {
  Mask out(a.grid);
  for (std::size_t i = 0; i < a.voxels.size(); ++i) out.voxels[i] = 1 - a.voxels[i];
  return out;
}

Volume<float> to_float(const Hounsfield& volume) {
  Volume<float> out(volume.grid);
  std::copy(volume.voxels.begin(), volume.voxels.end(), out.voxels.begin());
  return out;
}

Volume<float> to_float(const Mask& mask) {
  Volume<float> out(mask.grid);
  std::copy(mask.voxels.begin(), mask.voxels.end(), out.voxels.begin());
  return out;
}

double value_at(const Volume<float>& volume, const std::array<double, 3>& p) {
  const auto& g = volume.grid;
  std::array<int, 3> i0{};
  std::array<double, 3> f{};
  for (int a = 0; a < 3; ++a) {
    const double index = std::clamp((p[a] - g.origin[a]) / g.spacing[a], 0.0, g.size[a] - 1.0);
    i0[a] = std::min(static_cast<int>(index), std::max(0, g.size[a] - 2));
    f[a] = index - i0[a];
  }
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    const double w =
        ((c & 1) != 0 ? f[0] : 1 - f[0]) * ((c & 2) != 0 ? f[1] : 1 - f[1]) * ((c & 4) != 0 ? f[2] : 1 - f[2]);
    if (w > 0.0) sum += w * volume.at(i0[0] + (c & 1), i0[1] + ((c >> 1) & 1), i0[2] + ((c >> 2) & 1));
  }
  return sum;
}

double grey_at(const Hounsfield& hu, const std::array<double, 3>& p) {
  const auto& g = hu.grid;
  std::array<int, 3> c{};
  std::array<double, 3> f{};
  for (int a = 0; a < 3; ++a) {
    const double at = (p[a] - g.origin[a]) / g.spacing[a];
    c[a] = std::clamp(static_cast<int>(std::floor(at + 1e-9)), 0, std::max(0, g.size[a] - 2));
    f[a] = std::clamp(at - c[a], 0.0, 1.0);
    if (f[a] < 1e-7) f[a] = 0.0;
  }
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1;
    const int y = (k >> 1) & 1;
    const int z = k >> 2;
    const double w = (x != 0 ? f[0] : 1.0 - f[0]) * (y != 0 ? f[1] : 1.0 - f[1]) * (z != 0 ? f[2] : 1.0 - f[2]);
    if (w > 0.0) sum += w * hu.at(c[0] + x, c[1] + y, c[2] + z);
  }
  return sum;
}

}  // namespace vallecula::pipeline

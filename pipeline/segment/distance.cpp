// What is done line by line, along each axis in turn: distances, morphology by distance, smoothing.
#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/parallel.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {
namespace {

constexpr float kFar = 1e9F;

/// Calls body(line, length) for each line of the volume along `axis`; what it writes into the line is put back. Lines
/// across the rows are taken sixteen neighbours at a time: a line of the processor's cache holds sixteen floats.
template <class Body>
void for_lines(Volume<float>& volume, int axis, const Body& body) {
  const auto& g = volume.grid;
  const std::size_t row = g.size[0];
  const std::size_t plane = row * g.size[1];
  float* data = volume.voxels.data();
  if (axis == 0) {
    parallel_for(g.size[2], [&](int z) {
      for (int y = 0; y < g.size[1]; ++y) body(data + z * plane + y * row, g.size[0]);
    });
    return;
  }
  constexpr int kWide = 16;
  const std::size_t stride = axis == 1 ? row : plane;
  const int n = g.size[axis];
  parallel_for(g.size[axis == 1 ? 2 : 1], [&](int outer) {
    std::vector<float> lines(static_cast<std::size_t>(n) * kWide);
    for (int x = 0; x < g.size[0]; x += kWide) {
      const int wide = std::min(kWide, g.size[0] - x);
      float* first = data + outer * (axis == 1 ? plane : row) + x;
      for (int q = 0; q < n; ++q) {
        for (int k = 0; k < wide; ++k) lines[static_cast<std::size_t>(k) * n + q] = first[q * stride + k];
      }
      for (int k = 0; k < wide; ++k) body(lines.data() + static_cast<std::size_t>(k) * n, n);
      for (int q = 0; q < n; ++q) {
        for (int k = 0; k < wide; ++k) first[q * stride + k] = lines[static_cast<std::size_t>(k) * n + q];
      }
    }
  });
}

/// Squared distances along a row of a mask.
void distance_row(const std::uint8_t* mask, float* f, int n, double spacing) {
  int last = -1;
  for (int q = 0; q < n; ++q) {
    if (mask[q] != 0) last = q;
    const double d = spacing * (q - last);
    f[q] = last < 0 ? kFar : static_cast<float>(d * d);
  }
  for (int q = last - 1; q >= 0; --q) {
    if (mask[q] != 0) last = q;
    const double d = spacing * (last - q);
    f[q] = std::min(f[q], static_cast<float>(d * d));
  }
}

/// Lower envelope of parabolas: squared distances along one line, from those within its voxels' own planes.
void distance_line(float* f, int n, double spacing) {
  thread_local std::vector<double> value;
  thread_local std::vector<double> border;
  thread_local std::vector<int> vertex;
  value.resize(n);
  border.resize(n + 1);
  vertex.resize(n);
  const double s2 = spacing * spacing;
  bool far = false;
  bool near = false;
  for (int q = 0; q < n; ++q) {
    value[q] = f[q];
    far = far || value[q] > 0.0;
    near = near || value[q] < kFar;
  }
  if (!near || !far) return;
  int k = -1;
  for (int q = 0; q < n; ++q) {
    if (value[q] >= kFar) continue;
    double s = -std::numeric_limits<double>::infinity();
    while (k >= 0) {
      const int v = vertex[k];
      s = (value[q] - value[v] + s2 * (static_cast<double>(q) * q - static_cast<double>(v) * v)) / (2.0 * s2 * (q - v));
      if (s > border[k]) break;
      --k;
    }
    if (k < 0) s = -std::numeric_limits<double>::infinity();
    ++k;
    vertex[k] = q;
    border[k] = s;
  }
  const int last = k;
  k = 0;
  for (int q = 0; q < n; ++q) {
    while (k < last && border[k + 1] < q) ++k;
    const double d = spacing * (q - vertex[k]);
    f[q] = static_cast<float>(d * d + value[vertex[k]]);
  }
}

/// Widened by a voxel to each side, cut at the grid.
Box widened(Box box, const Grid& g) {
  for (int a = 0; a < 3; ++a) {
    box.low[a] = std::max(0, box.low[a] - 1);
    box.high[a] = std::min(g.size[a] - 1, box.high[a] + 1);
  }
  return box;
}

}  // namespace

Volume<float> distance_to(const Mask& mask) {
  const auto& g = mask.grid;
  Volume<float> d(g);
  parallel_for(g.size[2], [&](int z) {
    for (int y = 0; y < g.size[1]; ++y) {
      const auto row = g.index(0, y, z);
      distance_row(mask.voxels.data() + row, d.voxels.data() + row, g.size[0], g.spacing[0]);
    }
  });
  for_lines(d, 1, [&](float* f, int n) { distance_line(f, n, g.spacing[1]); });
  for_lines(d, 2, [&](float* f, int n) {
    distance_line(f, n, g.spacing[2]);
    for (int q = 0; q < n; ++q) f[q] = f[q] >= kFar ? kFar : std::sqrt(f[q]);
  });
  return d;
}

Volume<float> signed_distance(const Mask& mask) {
  auto outside = distance_to(mask);
  const auto inside = distance_to(inverted(mask));
  const float half = static_cast<float>(0.5 * *std::min_element(mask.grid.spacing.begin(), mask.grid.spacing.end()));
  for (std::size_t i = 0; i < outside.voxels.size(); ++i) {
    auto& v = outside.voxels[i];
    v = mask.voxels[i] != 0 ? inside.voxels[i] - half : half - v;
  }
  return outside;
}

// Morphology changes nothing far from the mask: only its surroundings are looked at.

Mask dilated(const Mask& mask, double mm) {
  const auto box = bounds_of(mask, mm);
  Mask out(mask.grid);
  if (!box.empty()) paste(where(distance_to(cropped(mask, box)), [mm](float d) { return d <= mm; }), box, out);
  return out;
}

Mask eroded(const Mask& mask, double mm) {
  const auto bounds = bounds_of(mask);
  Mask out(mask.grid);
  if (bounds.empty()) return out;
  // The zero nearest to a one lies at most a voxel outside of the ones' box.
  const auto box = widened(bounds, mask.grid);
  paste(where(distance_to(inverted(cropped(mask, box))), [mm](float d) { return d > mm; }), box, out);
  return out;
}

Mask opened(const Mask& mask, double mm) { return dilated(eroded(mask, mm), mm); }

Mask closed(const Mask& mask, double mm) { return eroded(dilated(mask, mm), mm); }

Volume<float> smoothed(const Volume<float>& volume, double sigma_mm) {
  Volume<float> out = volume;
  if (!(sigma_mm > 0.0)) return out;
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = sigma_mm / volume.grid.spacing[axis];
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    if (radius < 1) continue;
    std::vector<float> kernel(2 * radius + 1);
    double sum = 0.0;
    for (int k = -radius; k <= radius; ++k) sum += std::exp(-0.5 * k * k / (sigma * sigma));
    for (int k = -radius; k <= radius; ++k)
      kernel[k + radius] = static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma)) / sum);
    for_lines(out, axis, [&](float* f, int n) {
      thread_local std::vector<float> line;
      line.resize(n + 2 * radius);
      for (int q = -radius; q < n + radius; ++q) line[q + radius] = f[std::clamp(q, 0, n - 1)];
      std::fill_n(f, n, 0.0F);
      for (int k = 0; k <= 2 * radius; ++k) {
        const float weight = kernel[k];
        const float* from = line.data() + k;
        for (int q = 0; q < n; ++q) f[q] += weight * from[q];
      }
    });
  }
  return out;
}

}  // namespace vallecula::pipeline

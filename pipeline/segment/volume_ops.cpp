#include "pipeline/segment/volume_ops.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

constexpr float kFar = 1e9F;

/// Calls body(first index, stride, length) for each line of the grid along `axis`.
template <class Body>
void for_lines(const Grid& g, int axis, const Body& body) {
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(g.size[0]),
                                          static_cast<std::size_t>(g.size[0]) * static_cast<std::size_t>(g.size[1])};
  const int outer = axis == 2 ? 1 : 2;
  const int inner = axis == 0 ? 1 : 0;
  parallel_for(g.size[outer], [&](int o) {
    for (int i = 0; i < g.size[inner]; ++i) body(o * stride[outer] + i * stride[inner], stride[axis], g.size[axis]);
  });
}

/// Lower envelope of parabolas: squared distances along one line.
void distance_line(float* f, std::size_t stride, int n, double spacing, std::vector<double>& value,
                   std::vector<double>& border, std::vector<int>& vertex) {
  value.resize(n);
  border.resize(n + 1);
  vertex.resize(n);
  const double s2 = spacing * spacing;
  bool any = false;
  for (int q = 0; q < n; ++q) {
    value[q] = f[q * stride];
    any = any || value[q] < kFar;
  }
  if (!any) return;
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
    f[q * stride] = static_cast<float>(d * d + value[vertex[k]]);
  }
}

template <class Visit>
void for_neighbours6(const Grid& g, std::size_t i, const Visit& visit) {
  const auto c = g.cell(i);
  const std::size_t row = g.size[0];
  const std::size_t plane = row * g.size[1];
  if (c[0] > 0) visit(i - 1);
  if (c[0] + 1 < g.size[0]) visit(i + 1);
  if (c[1] > 0) visit(i - row);
  if (c[1] + 1 < g.size[1]) visit(i + row);
  if (c[2] > 0) visit(i - plane);
  if (c[2] + 1 < g.size[2]) visit(i + plane);
}

}  // namespace

Box whole(const Grid& grid) { return {{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}}; }

Box bounds_of(const Mask& mask, double margin_mm) {
  const auto& g = mask.grid;
  Box box{g.size, {-1, -1, -1}};
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        if (mask.at(x, y, z) == 0) continue;
        const std::array<int, 3> c{x, y, z};
        for (int a = 0; a < 3; ++a) {
          box.low[a] = std::min(box.low[a], c[a]);
          box.high[a] = std::max(box.high[a], c[a]);
        }
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

Volume<float> distance_to(const Mask& mask) {
  Volume<float> d(mask.grid, kFar);
  for (std::size_t i = 0; i < d.voxels.size(); ++i) {
    if (mask.voxels[i] != 0) d.voxels[i] = 0.0F;
  }
  for (int axis = 0; axis < 3; ++axis) {
    for_lines(mask.grid, axis, [&](std::size_t first, std::size_t stride, int n) {
      thread_local std::vector<double> value;
      thread_local std::vector<double> border;
      thread_local std::vector<int> vertex;
      distance_line(d.voxels.data() + first, stride, n, mask.grid.spacing[axis], value, border, vertex);
    });
  }
  for (auto& v : d.voxels) v = v >= kFar ? kFar : std::sqrt(v);
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

Mask dilated(const Mask& mask, double mm) {
  return where(distance_to(mask), [mm](float d) { return d <= mm; });
}

Mask eroded(const Mask& mask, double mm) {
  return where(distance_to(inverted(mask)), [mm](float d) { return d > mm; });
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
    for_lines(volume.grid, axis, [&](std::size_t first, std::size_t stride, int n) {
      thread_local std::vector<float> line;
      line.resize(n + 2 * radius);
      float* f = out.voxels.data() + first;
      for (int q = -radius; q < n + radius; ++q) line[q + radius] = f[std::clamp(q, 0, n - 1) * stride];
      for (int q = 0; q < n; ++q) {
        float v = 0.0F;
        for (int k = 0; k <= 2 * radius; ++k) v += kernel[k] * line[q + k];
        f[q * stride] = v;
      }
    });
  }
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

Mask Components::mask(int which) const {
  return where(id, [which](int v) { return v == which; });
}

Components components(const Mask& mask) {
  Components c;
  c.id = Volume<int>(mask.grid, 0);
  std::vector<std::size_t> sizes{0};
  std::vector<std::size_t> stack;
  for (std::size_t start = 0; start < mask.voxels.size(); ++start) {
    if (mask.voxels[start] == 0 || c.id.voxels[start] != 0) continue;
    const int id = static_cast<int>(sizes.size());
    sizes.push_back(0);
    c.id.voxels[start] = id;
    stack.push_back(start);
    while (!stack.empty()) {
      const auto i = stack.back();
      stack.pop_back();
      ++sizes[id];
      for_neighbours6(mask.grid, i, [&](std::size_t n) {
        if (mask.voxels[n] == 0 || c.id.voxels[n] != 0) return;
        c.id.voxels[n] = id;
        stack.push_back(n);
      });
    }
  }
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin() + 1, order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  std::vector<int> rank(sizes.size());
  c.sizes.resize(sizes.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    rank[order[r]] = static_cast<int>(r);
    c.sizes[r] = sizes[order[r]];
  }
  for (auto& id : c.id.voxels) id = rank[id];
  return c;
}

Mask largest_component(const Mask& mask) { return components(mask).mask(1); }

Mask grown(const Mask& seed, const Mask& allowed) {
  Mask out(seed.grid);
  std::vector<std::size_t> stack;
  for (std::size_t i = 0; i < seed.voxels.size(); ++i) {
    if (seed.voxels[i] == 0 || allowed.voxels[i] == 0) continue;
    out.voxels[i] = 1;
    stack.push_back(i);
  }
  while (!stack.empty()) {
    const auto i = stack.back();
    stack.pop_back();
    for_neighbours6(seed.grid, i, [&](std::size_t n) {
      if (allowed.voxels[n] == 0 || out.voxels[n] != 0) return;
      out.voxels[n] = 1;
      stack.push_back(n);
    });
  }
  return out;
}

Mask with_holes_filled(const Mask& mask) {
  const auto& g = mask.grid;
  Mask border(g);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        const bool edge = x == 0 || y == 0 || z == 0 || x == g.size[0] - 1 || y == g.size[1] - 1 || z == g.size[2] - 1;
        if (edge && mask.at(x, y, z) == 0) border.at(x, y, z) = 1;
      }
    }
  }
  return inverted(grown(border, inverted(mask)));
}

Mask holes_of_slice(const Mask& mask, int z) {
  Box box = whole(mask.grid);
  box.low[2] = z;
  box.high[2] = z;
  const auto slice = cropped(mask, box);
  const auto n = static_cast<std::ptrdiff_t>(slice.grid.count());
  // Between two full slices, so that nothing gets out above or below.
  Grid between = slice.grid;
  between.size[2] = 3;
  Mask stack(between, 1);
  std::copy(slice.voxels.begin(), slice.voxels.end(), stack.voxels.begin() + n);
  stack = with_holes_filled(stack);
  Mask filled(slice.grid);
  std::copy(stack.voxels.begin() + n, stack.voxels.begin() + 2 * n, filled.voxels.begin());
  return without(filled, slice);
}

Volume<std::uint8_t> flooded(const Volume<float>& cost, const Volume<std::uint8_t>& markers, const Mask& allowed) {
  struct Item {
    float cost;
    std::uint32_t order;
    std::size_t i;
    bool operator>(const Item& o) const { return cost != o.cost ? cost > o.cost : order > o.order; }
  };
  Volume<std::uint8_t> out(cost.grid);
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::uint32_t order = 0;
  for (std::size_t i = 0; i < markers.voxels.size(); ++i) {
    if (markers.voxels[i] == 0 || allowed.voxels[i] == 0) continue;
    out.voxels[i] = markers.voxels[i];
    queue.push({cost.voxels[i], order++, i});
  }
  while (!queue.empty()) {
    const auto item = queue.top();
    queue.pop();
    for_neighbours6(cost.grid, item.i, [&](std::size_t n) {
      if (allowed.voxels[n] == 0 || out.voxels[n] != 0) return;
      out.voxels[n] = out.voxels[item.i];
      queue.push({std::max(cost.voxels[n], item.cost), order++, n});
    });
  }
  return out;
}

Volume<std::uint8_t> shared_by_travel(const Volume<float>& cost, const Volume<std::uint8_t>& markers,
                                      const Mask& allowed) {
  const auto& g = cost.grid;
  Volume<std::uint8_t> out(g);
  Volume<float> paid(g, kFar);
  using Item = std::pair<float, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (std::size_t i = 0; i < markers.voxels.size(); ++i) {
    if (markers.voxels[i] == 0 || allowed.voxels[i] == 0) continue;
    out.voxels[i] = markers.voxels[i];
    paid.voxels[i] = 0.0F;
    queue.push({0.0F, i});
  }
  const std::size_t row = g.size[0];
  const std::size_t plane = row * g.size[1];
  while (!queue.empty()) {
    const auto [spent, i] = queue.top();
    queue.pop();
    if (spent > paid.voxels[i]) continue;
    for_neighbours6(g, i, [&](std::size_t n) {
      if (allowed.voxels[n] == 0) return;
      const std::size_t apart = n > i ? n - i : i - n;
      const double mm = apart == 1 ? g.spacing[0] : apart == plane ? g.spacing[2] : g.spacing[1];
      const float price = spent + static_cast<float>(0.5 * mm * (cost.voxels[i] + cost.voxels[n]));
      if (price >= paid.voxels[n]) return;
      paid.voxels[n] = price;
      out.voxels[n] = out.voxels[i];
      queue.push({price, n});
    });
  }
  return out;
}

Volume<float> path_length(const Mask& seed, const Mask& allowed) {
  const auto& g = seed.grid;
  Volume<float> d(g, kFar);
  using Item = std::pair<float, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (std::size_t i = 0; i < seed.voxels.size(); ++i) {
    if (seed.voxels[i] == 0 || allowed.voxels[i] == 0) continue;
    d.voxels[i] = 0.0F;
    queue.push({0.0F, i});
  }
  while (!queue.empty()) {
    const auto [length, i] = queue.top();
    queue.pop();
    if (length > d.voxels[i]) continue;
    const auto c = g.cell(i);
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (!g.contains(c[0] + dx, c[1] + dy, c[2] + dz)) continue;
          const auto n = g.index(c[0] + dx, c[1] + dy, c[2] + dz);
          if (allowed.voxels[n] == 0) continue;
          const double sx = dx * g.spacing[0];
          const double sy = dy * g.spacing[1];
          const double sz = dz * g.spacing[2];
          const auto way = length + static_cast<float>(std::sqrt(sx * sx + sy * sy + sz * sz));
          if (way < d.voxels[n]) {
            d.voxels[n] = way;
            queue.push({way, n});
          }
        }
      }
    }
  }
  return d;
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

}  // namespace vallecula::pipeline

#include <algorithm>
#include <cmath>
#include <queue>

#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {
namespace {

constexpr float kUnpaid = 1e9F;

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
  Volume<float> paid(g, kUnpaid);
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
  Volume<float> d(g, kUnpaid);
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

}  // namespace vallecula::pipeline

#include <algorithm>

#include "pipeline/segment/runs.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::pipeline {

int Runs::find(int i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

/// Joins the runs of two neighbouring rows that overlap; the earlier run becomes the root.
void Runs::join(int row, int other) {
  const std::size_t shift = static_cast<std::size_t>(row - other) * length_;
  int b = row_[other];
  for (int a = row_[row]; a < row_[row + 1]; ++a) {
    const std::size_t from = runs_[a].first - shift;
    const std::size_t to = from + runs_[a].length;
    while (b < row_[other + 1] && runs_[b].first + runs_[b].length <= from) ++b;
    for (int k = b; k < row_[other + 1] && runs_[k].first < to; ++k) {
      const int i = find(a);
      const int j = find(k);
      if (i != j) parent_[std::max(i, j)] = std::min(i, j);
    }
  }
}

Runs::Runs(const Mask& mask) : length_(mask.grid.size[0]) {
  const auto& g = mask.grid;
  const int rows = g.size[1] * g.size[2];
  row_.reserve(static_cast<std::size_t>(rows) + 1);
  for (int row = 0; row < rows; ++row) {
    row_.push_back(static_cast<int>(runs_.size()));
    const std::size_t first = static_cast<std::size_t>(row) * length_;
    const auto* voxels = mask.voxels.data() + first;
    const int n = g.size[0];
    for (int x = next_set(voxels, 0, n); x < n;) {
      const int end = next_clear(voxels, x, n);
      runs_.push_back({first + x, end - x});
      x = next_set(voxels, end, n);
    }
  }
  row_.push_back(static_cast<int>(runs_.size()));
  parent_.resize(runs_.size());
  std::iota(parent_.begin(), parent_.end(), 0);
  for (int row = 0; row < rows; ++row) {
    if (row % g.size[1] != 0) join(row, row - 1);
    if (row >= g.size[1]) join(row, row - g.size[1]);
  }
  // Roots come before their runs, so one pass makes all point straight at theirs.
  for (auto& p : parent_) p = parent_[p];
}

namespace {

/// Sets what belongs to the chosen roots.
Mask drawn(const Grid& grid, const Runs& runs, const std::vector<std::uint8_t>& chosen) {
  Mask out(grid);
  for (std::size_t r = 0; r < runs.all().size(); ++r) {
    const auto& run = runs.all()[r];
    if (chosen[runs.root(static_cast<int>(r))] != 0) std::fill_n(out.voxels.begin() + run.first, run.length, 1);
  }
  return out;
}

}  // namespace

Mask Components::mask(int which) const {
  return where(id, [which](int v) { return v == which; });
}

int piece_at(const Components& parts, const std::array<double, 3>& point, double reach_mm) {
  const auto& g = parts.id.grid;
  const auto reach = std::array<double, 3>{reach_mm, reach_mm, reach_mm};
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  for (int a = 0; a < 3; ++a) {
    low[a] = point[a] - reach[a];
    high[a] = point[a] + reach[a];
  }
  const auto box = box_between(g, low, high);
  double best = reach_mm * reach_mm;
  int id = 0;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y) {
      for (int x = box.low[0]; x <= box.high[0]; ++x) {
        if (parts.id.at(x, y, z) == 0) continue;
        const auto p = g.position(x, y, z);
        double d2 = 0.0;
        for (int a = 0; a < 3; ++a) d2 += (p[a] - point[a]) * (p[a] - point[a]);
        if (d2 > best) continue;
        best = d2;
        id = parts.id.at(x, y, z);
      }
    }
  }
  return id;
}

Components components(const Mask& mask) {
  const Runs runs(mask);
  // Numbered by their first voxel, then by size.
  std::vector<int> number(runs.all().size(), 0);
  std::vector<std::size_t> sizes{0};
  for (std::size_t r = 0; r < runs.all().size(); ++r) {
    const int root = runs.root(static_cast<int>(r));
    if (root == static_cast<int>(r)) {
      number[r] = static_cast<int>(sizes.size());
      sizes.push_back(0);
    }
    sizes[number[root]] += runs.all()[r].length;
  }
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin() + 1, order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  std::vector<int> rank(sizes.size());
  Components c;
  c.sizes.resize(sizes.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    rank[order[r]] = static_cast<int>(r);
    c.sizes[r] = sizes[order[r]];
  }
  c.id = Volume<int>(mask.grid, 0);
  for (std::size_t r = 0; r < runs.all().size(); ++r) {
    const auto& run = runs.all()[r];
    std::fill_n(c.id.voxels.begin() + run.first, run.length, rank[number[runs.root(static_cast<int>(r))]]);
  }
  return c;
}

Mask largest_component(const Mask& mask) {
  const Runs runs(mask);
  std::vector<std::size_t> sizes(runs.all().size(), 0);
  for (std::size_t r = 0; r < sizes.size(); ++r) sizes[runs.root(static_cast<int>(r))] += runs.all()[r].length;
  std::vector<std::uint8_t> chosen(sizes.size(), 0);
  if (!sizes.empty()) chosen[std::max_element(sizes.begin(), sizes.end()) - sizes.begin()] = 1;
  return drawn(mask.grid, runs, chosen);
}

Mask grown(const Mask& seed, const Mask& allowed) {
  const Runs runs(allowed);
  std::vector<std::uint8_t> chosen(runs.all().size(), 0);
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    const auto& run = runs.all()[r];
    auto& take = chosen[runs.root(static_cast<int>(r))];
    if (take == 0 && next_set(seed.voxels.data() + run.first, 0, run.length) < run.length) take = 1;
  }
  return drawn(allowed.grid, runs, chosen);
}

Mask with_holes_filled(const Mask& mask) {
  const auto& g = mask.grid;
  const Runs runs(inverted(mask));
  std::vector<std::uint8_t> chosen(runs.all().size(), 0);
  for (std::size_t r = 0; r < chosen.size(); ++r) {
    const auto& run = runs.all()[r];
    const auto c = g.cell(run.first);
    const bool edge = c[0] == 0 || c[0] + run.length == g.size[0] || c[1] == 0 || c[1] == g.size[1] - 1 || c[2] == 0 ||
                      c[2] == g.size[2] - 1;
    if (edge) chosen[runs.root(static_cast<int>(r))] = 1;
  }
  return inverted(drawn(g, runs, chosen));
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

}  // namespace vallecula::pipeline

#include "pipeline/pose/sheets.h"

#include <algorithm>
#include <cmath>

#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

constexpr double kNodeMm = 1.7;   ///< between nodes (term)
constexpr double kBelowMm = 16.0; ///< the lattice goes on below the scan's end (term)
constexpr float kFaint = 2e-3F;   ///< what a cell without the sheet still resists: so a sheet goes on smoothly beyond it

/// One voxel per point, the border's going on outside.
template <class T>
T nearest_of(const Volume<T>& v, const Vector3& p) {
  auto c = v.grid.nearest(p);
  for (int a = 0; a < 3; ++a) c[a] = std::clamp(c[a], 0, v.grid.size[a] - 1);
  return v.at(c[0], c[1], c[2]);
}

Grid lattice_of(const Grid& scan, double top_z, double scale, double step) {
  Grid g;
  const Vector3 low = scan.origin - Vector3{0.0, 0.0, kBelowMm * scale};
  Vector3 high = scan.position(scan.size[0] - 1, scan.size[1] - 1, scan.size[2] - 1);
  high[2] = std::min(high[2], top_z);
  for (int a = 0; a < 3; ++a) {
    g.spacing[a] = step;
    g.origin[a] = low[a] - 0.5 * step;
    g.size[a] = static_cast<int>(std::ceil((high[a] - g.origin[a]) / step)) + 2;
  }
  return g;
}

}  // namespace

/// A lattice with what its nodes are tied to and how stiffly they hold together.
struct Sheets::Level {
  Grid grid;
  std::array<std::vector<std::uint8_t>, 2> content;
  std::vector<std::uint8_t> split;
  std::vector<std::uint8_t> tie;
  std::array<std::array<std::vector<float>, 3>, 2> edge;   ///< [sheet][axis] from a node to the next
  std::array<std::vector<float>, 2> pull;                  ///< weight of the spring to `aim`
  std::array<std::array<std::vector<float>, 3>, 2> aim;
  std::array<std::vector<float>, 3> load;                  ///< force on the lower sheet's free nodes
  std::array<std::array<std::vector<float>, 3>, 2> shift;  ///< the solution

  Level(const Parts& parts, const Aim& aim_, double scale, double step)
      : grid(lattice_of(parts.lower.grid, parts.top_z, scale, step)) {
    const auto n = grid.count();
    split.assign(n, 0);
    tie.assign(n, 0);
    for (int sheet = 0; sheet < 2; ++sheet) {
      content[sheet].assign(n, 0);
      pull[sheet].assign(n, 0.0F);
      for (int a = 0; a < 3; ++a) {
        edge[sheet][a].assign(n, 0.0F);
        aim[sheet][a].assign(n, 0.0F);
        shift[sheet][a].assign(n, 0.0F);
      }
    }
    fill_cells(parts);
    fill_ties(parts, aim_);
    fill_pulls(parts.upper_pulls, kUpper);
    fill_pulls(parts.lower_pulls, kLower);
  }

  /// A pressure from inside the tongue on its free face.
  void press_outwards() {
    const std::array<std::size_t, 3> step{1, step_of(1), step_of(2)};
    for (int a = 0; a < 3; ++a) load[a].assign(grid.count(), 0.0F);
    for (int z = 1; z + 1 < grid.size[2]; ++z) {
      for (int y = 1; y + 1 < grid.size[1]; ++y) {
        for (int x = 1; x + 1 < grid.size[0]; ++x) {
          const auto i = grid.index(x, y, z);
          if (split[i] == 0) continue;
          for (int a = 0; a < 3; ++a) {
            // Content is the cells': those before and behind the node along this axis.
            for (int k = 0; k < 4; ++k) {
              const auto side = i - ((k & 1) != 0 ? step[(a + 1) % 3] : 0) - ((k & 2) != 0 ? step[(a + 2) % 3] : 0);
              load[a][i] += 0.02F * (content[kLower][side - step[a]] - content[kLower][side]);
            }
          }
        }
      }
    }
  }

  std::size_t step_of(int axis) const {
    return axis == 0 ? 1 : axis == 1 ? static_cast<std::size_t>(grid.size[0])
                                     : static_cast<std::size_t>(grid.size[0]) * grid.size[1];
  }

  void fill_cells(const Parts& parts) {
    const auto row = step_of(1);
    const auto slab = step_of(2);
    for (int z = 0; z + 1 < grid.size[2]; ++z) {
      for (int y = 0; y + 1 < grid.size[1]; ++y) {
        for (int x = 0; x + 1 < grid.size[0]; ++x) {
          const auto i = grid.index(x, y, z);
          std::array<float, 2> stiffness{0.0F, 0.0F};
          for (int c = 0; c < 8; ++c) {
            const auto p = grid.position(x + ((c & 1) != 0 ? 0.75 : 0.25), y + ((c & 2) != 0 ? 0.75 : 0.25),
                                         z + ((c & 4) != 0 ? 0.75 : 0.25));
            const int sheet = nearest_of(parts.lower, p) != 0 ? kLower : kUpper;
            ++content[sheet][i];
            stiffness[sheet] += 0.125F * nearest_of(parts.stiffness, p);
          }
          for (int sheet = 0; sheet < 2; ++sheet) {
            const float w = 0.25F * std::max(stiffness[sheet], kFaint);
            for (const auto d : {std::size_t{0}, row, slab, row + slab}) edge[sheet][0][i + d] += w;
            for (const auto d : {std::size_t{0}, std::size_t{1}, slab, slab + 1}) edge[sheet][1][i + d] += w;
            for (const auto d : {std::size_t{0}, std::size_t{1}, row, row + 1}) edge[sheet][2][i + d] += w;
          }
        }
      }
    }
    for (const auto& p : parts.cut) {
      std::array<int, 3> c{};
      for (int a = 0; a < 3; ++a)
        c[a] = std::clamp(static_cast<int>(std::floor((p[a] - grid.origin[a]) / grid.spacing[a])), 0, grid.size[a] - 2);
      const auto i = grid.index(c[0], c[1], c[2]);
      for (int k = 0; k < 8; ++k)
        split[i + ((k & 1) != 0 ? 1 : 0) + ((k & 2) != 0 ? row : 0) + ((k & 4) != 0 ? slab : 0)] = 1;
    }
  }

  void fill_ties(const Parts& parts, const Aim& turns) {
    const auto& g = parts.ties.grid;
    const auto row = step_of(1);
    const auto slab = step_of(2);
    const auto bind = [&](const Vector3& p, std::uint8_t to) {
      std::array<int, 3> c{};
      for (int a = 0; a < 3; ++a) {
        c[a] = static_cast<int>(std::floor((p[a] - grid.origin[a]) / grid.spacing[a]));
        if (c[a] < 0 || c[a] > grid.size[a] - 2) return;
      }
      const auto i = grid.index(c[0], c[1], c[2]);
      for (int k = 0; k < 8; ++k) {
        auto& t = tie[i + ((k & 1) != 0 ? 1 : 0) + ((k & 2) != 0 ? row : 0) + ((k & 4) != 0 ? slab : 0)];
        t = std::max(t, to);
      }
    };
    for (std::size_t i = 0; i < g.count(); ++i) {
      if (parts.ties.voxels[i] != 0) bind(g.position(i), parts.ties.voxels[i]);
    }
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const auto p = grid.position(i);
      if (p[2] >= parts.top_z - 1e-9) tie[i] = static_cast<std::uint8_t>(Tie::skull);
      // Below the scan what lies under a tied place goes with it.
      if (p[2] < g.origin[2]) tie[i] = std::max(tie[i], nearest_of(parts.ties, p));
      if (tie[i] == 0) continue;
      const auto to = tied(static_cast<Tie>(tie[i]), turns, p) - p;
      for (int sheet = 0; sheet < 2; ++sheet) {
        if (sheet == kLower && split[i] != 0) continue;
        for (int a = 0; a < 3; ++a) shift[sheet][a][i] = static_cast<float>(to[a]);
      }
    }
  }

  void fill_pulls(const std::vector<Pull>& pulls, int sheet) {
    std::vector<float> sum(grid.count(), 0.0F);
    for (const auto& pull_to : pulls) {
      std::array<int, 3> low{};
      std::array<int, 3> high{};
      for (int a = 0; a < 3; ++a) {
        const double at = pull_to.at[a] - grid.origin[a];
        low[a] = std::max(0, static_cast<int>(std::ceil((at - pull_to.radius_mm) / grid.spacing[a])));
        high[a] = std::min(grid.size[a] - 1, static_cast<int>(std::floor((at + pull_to.radius_mm) / grid.spacing[a])));
      }
      for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
          for (int x = low[0]; x <= high[0]; ++x) {
            const double d = distance(grid.position(x, y, z), pull_to.at) / pull_to.radius_mm;
            if (d >= 1.0) continue;
            const auto i = grid.index(x, y, z);
            const float w = pull_to.weight * static_cast<float>(1.0 - d * d);
            const float before = sum[i];
            sum[i] += w;
            pull[sheet][i] = std::max(pull[sheet][i], w);
            for (int a = 0; a < 3; ++a) {
              auto& to = aim[sheet][a][i];
              to = (before * to + w * static_cast<float>(pull_to.way[a])) / sum[i];
            }
          }
        }
      }
    }
  }

  void start_from(const Level& coarse) {
    for (int sheet = 0; sheet < 2; ++sheet) {
      for (int a = 0; a < 3; ++a) {
        Volume<float> field(coarse.grid);
        field.voxels = coarse.shift[sheet][a];
        parallel_for(grid.size[2], [&](int z) {
          for (int y = 0; y < grid.size[1]; ++y) {
            for (int x = 0; x < grid.size[0]; ++x) {
              const auto i = grid.index(x, y, z);
              if (tie[i] != 0 && (sheet == kUpper || split[i] == 0)) continue;
              shift[sheet][a][i] = static_cast<float>(value_at(field, grid.position(x, y, z)));
            }
          }
        });
      }
    }
  }

  /// Successive over-relaxation, red and black: the result does not depend on the number of threads.
  void relax(int rounds, float factor) {
    const std::array<std::size_t, 3> step{1, step_of(1), step_of(2)};
    for (int round = 0; round < rounds; ++round) {
      for (const int colour : {0, 1}) {
        parallel_for(grid.size[2], [&](int z) {
          for (int y = 0; y < grid.size[1]; ++y) {
            for (int x = (y + z + colour) & 1; x < grid.size[0]; x += 2) {
              const auto i = grid.index(x, y, z);
              const std::array<int, 3> c{x, y, z};
              if (split[i] == 0) {
                if (tie[i] == 0) relax_node(i, c, step, {true, true}, factor);
              } else {
                if (tie[i] == 0) relax_node(i, c, step, {true, false}, factor);
                relax_node(i, c, step, {false, true}, factor);
              }
            }
          }
        });
      }
    }
  }

  void relax_node(std::size_t i, const std::array<int, 3>& c, const std::array<std::size_t, 3>& step,
                  const std::array<bool, 2>& sheets, float factor) {
    float all = 0.0F;
    std::array<float, 3> sum{};
    for (int sheet = 0; sheet < 2; ++sheet) {
      if (!sheets[sheet]) continue;
      const auto add = [&](std::size_t j, float w) {
        all += w;
        for (int a = 0; a < 3; ++a) sum[a] += w * shift[sheet][a][j];
      };
      for (int axis = 0; axis < 3; ++axis) {
        if (c[axis] > 0) add(i - step[axis], edge[sheet][axis][i - step[axis]]);
        if (c[axis] + 1 < grid.size[axis]) add(i + step[axis], edge[sheet][axis][i]);
      }
      if (sheet == kLower && !load[0].empty()) {
        for (int a = 0; a < 3; ++a) sum[a] += load[a][i];
      }
      if (pull[sheet][i] > 0.0F) {
        all += pull[sheet][i];
        for (int a = 0; a < 3; ++a) sum[a] += pull[sheet][i] * aim[sheet][a][i];
      }
    }
    if (!(all > 0.0F)) return;
    for (int a = 0; a < 3; ++a) {
      const int first = sheets[0] ? 0 : 1;
      const float value = shift[first][a][i] + factor * (sum[a] / all - shift[first][a][i]);
      for (int sheet = 0; sheet < 2; ++sheet) {
        if (sheets[sheet]) shift[sheet][a][i] = value;
      }
    }
  }
};

Sheets::Sheets(const Parts& parts, const Aim& aim, double scale) {
  Level coarse(parts, aim, scale, 3.0 * kNodeMm * scale);
  coarse.relax(150, 1.85F);
  Level fine(parts, aim, scale, kNodeMm * scale);
  fine.start_from(coarse);
  fine.relax(60, 1.8F);
  fine.relax(4, 1.0F);
  lattice_ = fine.grid;
  content_ = fine.content;
  split_ = fine.split;
  tie_ = fine.tie;
  shift_ = fine.shift;
  if (!parts.cut.empty()) keep_volume(coarse, fine);
}

/// Springs know no volume; muscle keeps it. What a pressure inside the tongue would move is added until it does.
void Sheets::keep_volume(Level& coarse, Level& fine) {
  const double first = lower_volume_ratio();
  const auto still = coarse.shift;
  coarse.press_outwards();
  coarse.relax(100, 1.8F);
  for (int sheet = 0; sheet < 2; ++sheet) {
    for (int a = 0; a < 3; ++a) {
      for (std::size_t i = 0; i < still[sheet][a].size(); ++i) coarse.shift[sheet][a][i] -= still[sheet][a][i];
      fine.shift[sheet][a].assign(fine.shift[sheet][a].size(), 0.0F);
    }
  }
  fine.start_from(coarse);
  const auto base = shift_;
  const auto add = [&](double times) {
    for (int sheet = 0; sheet < 2; ++sheet) {
      for (int a = 0; a < 3; ++a) {
        for (std::size_t i = 0; i < base[sheet][a].size(); ++i)
          shift_[sheet][a][i] = base[sheet][a][i] + static_cast<float>(times) * fine.shift[sheet][a][i];
      }
    }
  };
  double before = 0.0;
  double before_ratio = first;
  double times = first < 1.0 ? 1.0 : -1.0;
  for (int round = 0; round < 5; ++round) {
    add(times);
    const double ratio = lower_volume_ratio();
    if (std::abs(ratio - 1.0) < 0.002 || std::abs(ratio - before_ratio) < 1e-6) break;
    const double next = times + (1.0 - ratio) * (times - before) / (ratio - before_ratio);
    before = times;
    before_ratio = ratio;
    times = next;
  }
}

bool Sheets::slides(std::size_t node) const {
  bool jaw = false;
  bool skull = false;
  // A step farther than the cell: the wedge between two bones is squeezed as a whole.
  const auto c = lattice_.cell(node);
  for (int z = c[2] - 1; z <= c[2] + 2; ++z) {
    for (int y = c[1] - 1; y <= c[1] + 2; ++y) {
      for (int x = c[0] - 1; x <= c[0] + 2; ++x) {
        if (!lattice_.contains(x, y, z)) continue;
        const auto tie = static_cast<Tie>(tie_[lattice_.index(x, y, z)]);
        jaw = jaw || tie == Tie::jaw;
        skull = skull || tie == Tie::skull;
      }
    }
  }
  return jaw && skull;
}

Vector3 Sheets::displacement(Sheet sheet, std::size_t node) const {
  return {shift_[sheet][0][node], shift_[sheet][1][node], shift_[sheet][2][node]};
}

Vector3 Sheets::moved(Sheet sheet, const Vector3& p) const {
  std::array<int, 3> c{};
  std::array<double, 3> f{};
  for (int a = 0; a < 3; ++a) {
    const double at = (p[a] - lattice_.origin[a]) / lattice_.spacing[a];
    if (a == 2 && at > lattice_.size[a] - 1) return p;  // above all that moves
    c[a] = std::clamp(static_cast<int>(std::floor(at)), 0, lattice_.size[a] - 2);
    f[a] = std::clamp(at - c[a], 0.0, 1.0);
  }
  Vector3 out = p;
  for (int k = 0; k < 8; ++k) {
    const int x = k & 1;
    const int y = (k >> 1) & 1;
    const int z = k >> 2;
    const double w = (x != 0 ? f[0] : 1.0 - f[0]) * (y != 0 ? f[1] : 1.0 - f[1]) * (z != 0 ? f[2] : 1.0 - f[2]);
    out = out + w * displacement(sheet, lattice_.index(c[0] + x, c[1] + y, c[2] + z));
  }
  return out;
}

namespace {

/// Calls visit(cell, volume ratio of one of its tetrahedra).
template <class Visit>
void each_tet(const Sheets& sheets, Sheet sheet, const Visit& visit) {
  const auto& g = sheets.lattice();
  for (int z = 0; z + 1 < g.size[2]; ++z) {
    for (int y = 0; y + 1 < g.size[1]; ++y) {
      for (int x = 0; x + 1 < g.size[0]; ++x) {
        const auto i = g.index(x, y, z);
        if (sheets.content(sheet, i) <= 0.0) continue;
        std::array<Vector3, 8> corner{};
        for (int k = 0; k < 8; ++k) {
          const int cx = x + (k & 1);
          const int cy = y + ((k >> 1) & 1);
          const int cz = z + (k >> 2);
          corner[k] = g.position(cx, cy, cz) + sheets.displacement(sheet, g.index(cx, cy, cz));
        }
        for (const auto& t : kCellTets) {
          const auto& a = corner[t[0]];
          const double six = dot(cross(corner[t[1]] - a, corner[t[2]] - a), corner[t[3]] - a);
          visit(i, six / g.voxel_mm3());
        }
      }
    }
  }
}

}  // namespace

double Sheets::smallest_jacobian() const {
  double least = 1.0;
  for (const auto sheet : {kUpper, kLower}) {
    each_tet(*this, sheet, [&](std::size_t i, double v) {
      if (v < least && !slides(i)) least = v;
    });
  }
  return least;
}

double Sheets::folded_mm3() const {
  double folded = 0.0;
  for (const auto sheet : {kUpper, kLower}) {
    each_tet(*this, sheet, [&](std::size_t i, double v) {
      if (v <= 0.0 && !slides(i)) folded += content(sheet, i) * lattice_.voxel_mm3() / 6.0;
    });
  }
  return folded;
}

double Sheets::lower_volume_ratio() const {
  double before = 0.0;
  double after = 0.0;
  each_tet(*this, kLower, [&](std::size_t i, double v) {
    before += content(kLower, i) / 6.0;
    after += content(kLower, i) * v / 6.0;
  });
  return before > 0.0 ? after / before : 1.0;
}

}  // namespace vallecula::pipeline

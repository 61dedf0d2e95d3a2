#include "pipeline/mesh/remesh.h"

#include <algorithm>

#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/mesh/vector3.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

/// A triangle mesh that can be edited: each point knows its triangles; dead triangles have corner -1.
class Mesh {
 public:
  Mesh(const Surface& surface, const RemeshOptions& options) : options_(options), points_(surface.points) {
    triangles_ = surface.triangles;
    around_.resize(points_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (const int v : triangles_[t]) around_[v].push_back(static_cast<int>(t));
    }
    target_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) target_[i] = options_.edge_mm(points_[i]);
  }

  void split_long() {
    // Points appended here are visited too, so long edges are halved until none is left.
    for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
      for (bool again = true; again;) {
        again = false;
        for (const int n : neighbours(v)) {
          if (length(v, n) > 4.0 / 3.0 * wanted(v, n)) {
            split(v, n);
            again = true;
            break;
          }
        }
      }
    }
  }

  void collapse_short() {
    for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
      for (bool again = true; again && !around_[v].empty();) {
        again = false;
        auto near = neighbours(v);
        std::sort(near.begin(), near.end(), [&](int a, int b) {
          const double la = length(v, a);
          const double lb = length(v, b);
          return la != lb ? la < lb : a < b;
        });
        for (const int n : near) {
          if (length(v, n) >= 0.8 * wanted(v, n)) break;
          if (collapse(v, n)) {
            again = true;
            break;
          }
        }
      }
    }
  }

  void flip_for_valence() {
    for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
      for (const int n : neighbours(v)) {
        if (n > v) flip(v, n);
      }
    }
  }

  void relax(const TriangleTree& reference) {
    std::vector<Point> moved(points_.size());
    constexpr std::size_t kChunk = 1024;
    parallel_for(static_cast<int>((points_.size() + kChunk - 1) / kChunk), [&](int chunk) {
      const std::size_t first = chunk * kChunk;
      for (std::size_t v = first; v < std::min(points_.size(), first + kChunk); ++v) moved[v] = relaxed(v, reference);
    });
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (around_[v].empty() || !keeps_normals(static_cast<int>(v), moved[v])) continue;
      points_[v] = moved[v];
      target_[v] = options_.edge_mm(points_[v]);
    }
  }

  Surface result() const {
    Surface out;
    std::vector<int> to(points_.size(), -1);
    for (const auto& t : triangles_) {
      if (t[0] < 0) continue;
      std::array<int, 3> tri{};
      for (int k = 0; k < 3; ++k) {
        int& n = to[t[k]];
        if (n < 0) {
          n = static_cast<int>(out.points.size());
          out.points.push_back(points_[t[k]]);
        }
        tri[k] = n;
      }
      out.triangles.push_back(tri);
    }
    return out;
  }

 private:
  double length(int a, int b) const { return distance(points_[a], points_[b]); }
  double wanted(int a, int b) const { return std::min(target_[a], target_[b]); }

  Vector3 area_normal(int t) const {
    const auto& c = triangles_[t];
    return cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]);
  }

  /// Moved along the surface towards the middle of its triangles.
  Point relaxed(std::size_t v, const TriangleTree& reference) const {
    Vector3 normal{};
    Vector3 centre{};
    double weight = 0.0;
    for (const int t : around_[v]) {
      const auto n = area_normal(t);
      normal = normal + n;
      // Area over the wanted area: evens out the sizes in proportion to what is wanted there.
      const double w = norm(n) / (target_[v] * target_[v]);
      const auto& c = triangles_[t];
      centre = centre + (w / 3.0) * (points_[c[0]] + points_[c[1]] + points_[c[2]]);
      weight += w;
    }
    if (!(weight > 0.0)) return points_[v];
    normal = unit(normal);
    Vector3 step = (1.0 / weight) * centre - points_[v];
    step = step - dot(step, normal) * normal;
    return reference.nearest(points_[v] + 0.6 * step).point;
  }

  std::vector<int> neighbours(int v) const {
    std::vector<int> out;
    for (const int t : around_[v]) {
      for (const int n : triangles_[t]) {
        if (n != v && std::find(out.begin(), out.end(), n) == out.end()) out.push_back(n);
      }
    }
    return out;
  }

  /// The triangles at an edge; both -1 unless there are exactly two.
  std::array<int, 2> at_edge(int a, int b) const {
    std::array<int, 2> found{-1, -1};
    int n = 0;
    for (const int t : around_[a]) {
      const auto& c = triangles_[t];
      if (c[0] != b && c[1] != b && c[2] != b) continue;
      if (n == 2) return {-1, -1};
      found[n++] = t;
    }
    return n == 2 ? found : std::array<int, 2>{-1, -1};
  }

  int opposite(int t, int a, int b) const {
    for (const int c : triangles_[t]) {
      if (c != a && c != b) return c;
    }
    return -1;
  }

  void forget(int v, int t) {
    auto& list = around_[v];
    list.erase(std::find(list.begin(), list.end(), t));
  }

  void split(int a, int b) {
    const auto pair = at_edge(a, b);
    if (pair[0] < 0) return;
    const int m = static_cast<int>(points_.size());
    points_.push_back(0.5 * (points_[a] + points_[b]));
    target_.push_back(options_.edge_mm(points_[m]));
    around_.emplace_back();
    for (const int t : pair) {
      const int o = opposite(t, a, b);
      auto half = triangles_[t];
      for (int& c : triangles_[t]) {
        if (c == b) c = m;
      }
      for (int& c : half) {
        if (c == a) c = m;
      }
      const int fresh = static_cast<int>(triangles_.size());
      triangles_.push_back(half);
      forget(b, t);
      around_[m].push_back(t);
      around_[m].push_back(fresh);
      around_[b].push_back(fresh);
      around_[o].push_back(fresh);
    }
  }

  /// Would the triangles around `v` (except those at `except`) keep their side and not become needles if `v` moved to
  /// `p`?
  bool keeps_normals(int v, const Point& p, int except = -1) const {
    for (const int t : around_[v]) {
      const auto& c = triangles_[t];
      if (except >= 0 && (c[0] == except || c[1] == except || c[2] == except)) continue;
      const auto before = area_normal(t);
      std::array<Vector3, 3> corner{points_[c[0]], points_[c[1]], points_[c[2]]};
      for (int k = 0; k < 3; ++k) {
        if (c[k] == v) corner[k] = p;
      }
      const auto after = cross(corner[1] - corner[0], corner[2] - corner[0]);
      const double longest =
          std::max({distance(corner[0], corner[1]), distance(corner[1], corner[2]), distance(corner[2], corner[0])});
      if (norm(after) < 0.02 * longest * longest) {
        // A needle may only pass when it was a worse one before.
        if (norm(after) <= norm(before)) return false;
        continue;
      }
      // The direction of a sliver says nothing, so it cannot veto.
      if (norm(before) > 0.02 * longest * longest && dot(unit(before), unit(after)) < 0.5) return false;
    }
    return true;
  }

  bool collapse(int keep, int gone) {
    const auto pair = at_edge(keep, gone);
    if (pair[0] < 0) return false;
    // Link condition: the only common neighbours are the two opposite corners, else the surface would pinch.
    const auto near_keep = neighbours(keep);
    const auto near_gone = neighbours(gone);
    int common = 0;
    for (const int n : near_gone) common += std::find(near_keep.begin(), near_keep.end(), n) != near_keep.end() ? 1 : 0;
    if (common != 2) return false;
    for (const int t : pair) {
      if (around_[opposite(t, keep, gone)].size() <= 3) return false;
    }
    Point place = 0.5 * (points_[keep] + points_[gone]);
    for (const int n : near_gone) {
      if (n != keep && distance(points_[n], place) > 4.0 / 3.0 * std::min(target_[n], target_[keep])) return false;
    }
    for (const int n : near_keep) {
      if (n != gone && distance(points_[n], place) > 4.0 / 3.0 * std::min(target_[n], target_[keep])) return false;
    }
    if (!keeps_normals(keep, place, gone) || !keeps_normals(gone, place, keep)) return false;
    for (const int t : pair) {
      const auto c = triangles_[t];
      for (const int v : c) forget(v, t);
      triangles_[t] = {-1, -1, -1};
    }
    for (const int t : around_[gone]) {
      for (int& c : triangles_[t]) {
        if (c == gone) c = keep;
      }
      around_[keep].push_back(t);
    }
    around_[gone].clear();
    points_[keep] = place;
    target_[keep] = options_.edge_mm(place);
    return true;
  }

  void flip(int a, int b) {
    const auto pair = at_edge(a, b);
    if (pair[0] < 0) return;
    const int c = opposite(pair[0], a, b);
    const int d = opposite(pair[1], a, b);
    if (c < 0 || d < 0 || c == d) return;
    const auto valence = [&](int v) { return static_cast<int>(around_[v].size()); };
    if (valence(a) <= 3 || valence(b) <= 3) return;
    const auto deviation = [](int n) { return (n - 6) * (n - 6); };
    const int before = deviation(valence(a)) + deviation(valence(b)) + deviation(valence(c)) + deviation(valence(d));
    const int after =
        deviation(valence(a) - 1) + deviation(valence(b) - 1) + deviation(valence(c) + 1) + deviation(valence(d) + 1);
    if (after >= before) return;
    for (const int t : around_[c]) {
      const auto& k = triangles_[t];
      if (k[0] == d || k[1] == d || k[2] == d) return;
    }
    const auto n0 = area_normal(pair[0]);
    const auto n1 = area_normal(pair[1]);
    // Orientation of the first triangle: does it run a to b or b to a?
    const auto& first = triangles_[pair[0]];
    const bool forward =
        (first[0] == a && first[1] == b) || (first[1] == a && first[2] == b) || (first[2] == a && first[0] == b);
    const std::array<int, 3> t0 = forward ? std::array<int, 3>{c, a, d} : std::array<int, 3>{c, d, a};
    const std::array<int, 3> t1 = forward ? std::array<int, 3>{c, d, b} : std::array<int, 3>{c, b, d};
    const auto normal = [&](const std::array<int, 3>& t) {
      return cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
    };
    const auto m0 = normal(t0);
    const auto m1 = normal(t1);
    const auto side = unit(n0 + n1);
    const double size = distance(points_[c], points_[d]);
    if (dot(unit(m0), side) < 0.8 || dot(unit(m1), side) < 0.8 || norm(m0) < 0.1 * size * size ||
        norm(m1) < 0.1 * size * size)
      return;
    triangles_[pair[0]] = t0;
    triangles_[pair[1]] = t1;
    forget(a, pair[1]);
    forget(b, pair[0]);
    around_[c].push_back(pair[1]);
    around_[d].push_back(pair[0]);
  }

  const RemeshOptions& options_;
  std::vector<Point> points_;
  std::vector<double> target_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::vector<int>> around_;
};

}  // namespace

Surface remeshed(const Surface& surface, const RemeshOptions& options) {
  const TriangleTree reference(surface);
  Mesh mesh(surface, options);
  for (int round = 0; round < options.rounds; ++round) {
    mesh.split_long();
    mesh.collapse_short();
    mesh.flip_for_valence();
    mesh.relax(reference);
    if (options.progress) options.progress((round + 1.0) / options.rounds);
  }
  return mesh.result();
}

}  // namespace vallecula::pipeline

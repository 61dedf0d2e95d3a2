#include "pipeline/mesh/tet_optimize.h"

#include <algorithm>
#include <numeric>

#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

/// Smallest sine of the six dihedral angles; the volume's sign goes with it. sine = 3 V l / (2 A B) for the edge l
/// between faces A and B.
double sine_quality(const std::array<Point, 4>& p) {
  const auto e1 = p[1] - p[0];
  const auto e2 = p[2] - p[0];
  const auto e3 = p[3] - p[0];
  const double six_v = dot(cross(e1, e2), e3);
  // Twice the areas of the faces opposite to each corner.
  const double a0 = norm(cross(p[2] - p[1], p[3] - p[1]));
  const double a1 = norm(cross(e2, e3));
  const double a2 = norm(cross(e1, e3));
  const double a3 = norm(cross(e1, e2));
  const double least =
      std::min({norm(e1) / (a2 * a3), norm(e2) / (a1 * a3), norm(e3) / (a1 * a2), distance(p[1], p[2]) / (a0 * a3),
                distance(p[1], p[3]) / (a0 * a2), distance(p[2], p[3]) / (a0 * a1)});
  const double q = six_v * least;
  return std::isfinite(q) ? q : -1.0;
}

class Optimizer {
 public:
  Optimizer(TetMesh& mesh, std::size_t surface_points, const Surface& surface)
      : mesh_(mesh), surface_points_(surface_points), reference_(surface) {
    around_.resize(mesh.points.size());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      for (const int v : mesh.tets[t]) around_[v].push_back(static_cast<int>(t));
    }
  }

  double worst_at(int v) const {
    double worst = 1.0;
    for (const int t : around_[v]) worst = std::min(worst, quality(t));
    return worst;
  }

  bool improve(int v) {
    const Point start = mesh_.points[v];
    const double before = worst_at(v);
    double size = 0.0;
    int edges = 0;
    Vector3 centre{};
    for (const int t : around_[v]) {
      for (const int n : mesh_.tets[t]) {
        if (n == v) continue;
        size += distance(mesh_.points[n], start);
        centre = centre + mesh_.points[n];
        ++edges;
      }
    }
    if (edges == 0) return false;
    size /= edges;
    centre = (1.0 / edges) * centre;
    Point best = start;
    double best_quality = before;
    const auto attempt = [&](Point p) {
      if (static_cast<std::size_t>(v) < surface_points_) p = reference_.nearest(p).point;
      mesh_.points[v] = p;
      const double q = worst_at(v);
      if (q > best_quality + 1e-4) {
        best_quality = q;
        best = p;
      }
    };
    attempt(start + 0.5 * (centre - start));
    for (double step = 0.24 * size; step > 0.02 * size; step *= 0.5) {
      const Point from = best;
      for (int a = 0; a < 3; ++a) {
        for (const double s : {-step, step}) {
          Point p = from;
          p[a] += s;
          attempt(p);
        }
      }
      for (int corner = 0; corner < 8; ++corner) {
        Point p = from;
        for (int a = 0; a < 3; ++a) p[a] += ((corner >> a) & 1) != 0 ? 0.577 * step : -0.577 * step;
        attempt(p);
      }
    }
    mesh_.points[v] = best;
    return best_quality > before;
  }

 private:
  double quality(int t) const {
    const auto& c = mesh_.tets[t];
    return sine_quality({mesh_.points[c[0]], mesh_.points[c[1]], mesh_.points[c[2]], mesh_.points[c[3]]});
  }

  TetMesh& mesh_;
  std::size_t surface_points_;
  std::vector<std::vector<int>> around_;
  TriangleTree reference_;
};

}  // namespace

void optimize_points(TetMesh& mesh, std::size_t surface_points, const Surface& surface, int rounds, bool slide) {
  Optimizer optimizer(mesh, surface_points, surface);
  std::vector<int> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> worst(order.size());
    for (std::size_t v = 0; v < worst.size(); ++v) worst[v] = optimizer.worst_at(static_cast<int>(v));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return worst[a] < worst[b]; });
    bool any = false;
    for (const int v : order) {
      if (!slide && static_cast<std::size_t>(v) < surface_points) continue;
      if (worst[v] > 0.5) break;  // 30 degrees: nothing to gain for the stiffness
      any = optimizer.improve(v) || any;
    }
    if (!any) return;
  }
}

}  // namespace vallecula::pipeline

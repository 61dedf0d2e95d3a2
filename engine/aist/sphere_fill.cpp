// Filling the soft body with spheres and tying them to it.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "engine/aist/sphere_ties.h"
#include "engine/aist/sphere_tree.h"
#include "engine/mesh/triangle_bvh.h"

namespace vallecula::engine {

namespace {

constexpr int kClusterSize = 32;
constexpr double kMostProtrusion = 0.00005;  // a surface sphere may stick out by 0.05 mm at a bend of the surface
// Of face_sag: the roundest tool a face need follow; the least is about what a blade may be inside tissue, the most bounds coarse
// meshes.
constexpr double kRoundestTool = 0.005, kLeastSag = 0.00008, kMostSag = 0.00024;  // m
// A sphere inside resists once the tool is nearer to its centre than this share of its radius: tissue pressed flat by a
// blade's face never is, tissue that an edge cuts into always.
constexpr double kCoreShare = 0.35;

/// Finds the tetrahedron of a point by the boxes of the tetrahedra, on a grid of about one tetrahedron a cell.
class TetLocator {
 public:
  explicit TetLocator(const SoftBodyDescription& soft) : soft_(soft) {
    low_ = high_ = soft.nodes.front();
    for (const Vec3& p : soft.nodes) {
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
    cell_ = std::cbrt((high_ - low_).prod() / static_cast<double>(soft.tets.size())) * 1.5;
    for (int a = 0; a < 3; ++a) size_[a] = std::max(1, static_cast<int>((high_[a] - low_[a]) / cell_) + 1);
    cells_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
    for (std::size_t t = 0; t < soft.tets.size(); ++t) {
      Vec3 box_low = soft.nodes[soft.tets[t][0]], box_high = box_low;
      for (int v : soft.tets[t]) {
        box_low = box_low.cwiseMin(soft.nodes[v]);
        box_high = box_high.cwiseMax(soft.nodes[v]);
      }
      for_cells(box_low, box_high, [&](std::size_t c) { cells_[c].push_back(static_cast<int>(t)); });
    }
  }

  /// Tetrahedron that holds p and p's weights in it; of a point just outside, the one it is least outside of.
  int locate(const Vec3& p, std::array<double, 4>& weights) const {
    int best = -1;
    double best_inside = -1e30;
    for_cells(p, p, [&](std::size_t c) {
      for (int t : cells_[c]) {
        std::array<double, 4> w = barycentric(t, p);
        const double inside = *std::min_element(w.begin(), w.end());
        if (inside > best_inside) {
          best_inside = inside;
          best = t;
          weights = w;
        }
      }
    });
    return best;
  }

  /// Tetrahedra whose centroid lies within `radius` of p.
  std::vector<int> within(const Vec3& p, double radius) const {
    std::set<int> found;
    for_cells(p - Vec3::Constant(radius), p + Vec3::Constant(radius), [&](std::size_t c) {
      for (int t : cells_[c]) {
        const auto& k = soft_.tets[t];
        const Vec3 centroid = (soft_.nodes[k[0]] + soft_.nodes[k[1]] + soft_.nodes[k[2]] + soft_.nodes[k[3]]) / 4;
        if ((centroid - p).squaredNorm() <= radius * radius) found.insert(t);
      }
    });
    return {found.begin(), found.end()};
  }

 private:
  template <class Visit>
  void for_cells(const Vec3& low, const Vec3& high, Visit visit) const {
    int from[3], to[3];
    for (int a = 0; a < 3; ++a) {
      from[a] = std::clamp(static_cast<int>((low[a] - low_[a]) / cell_), 0, size_[a] - 1);
      to[a] = std::clamp(static_cast<int>((high[a] - low_[a]) / cell_), 0, size_[a] - 1);
    }
    for (int k = from[2]; k <= to[2]; ++k)
      for (int j = from[1]; j <= to[1]; ++j)
        for (int i = from[0]; i <= to[0]; ++i) visit((static_cast<std::size_t>(k) * size_[1] + j) * size_[0] + i);
  }

  std::array<double, 4> barycentric(int t, const Vec3& p) const {
    const auto& k = soft_.tets[t];
    const auto g = shape_gradients(soft_.nodes[k[0]], soft_.nodes[k[1]], soft_.nodes[k[2]], soft_.nodes[k[3]]);
    std::array<double, 4> w;
    for (int c = 1; c < 4; ++c) w[c] = g.col(c).dot(p - soft_.nodes[k[0]]);
    w[0] = 1 - w[1] - w[2] - w[3];
    return w;
  }

  const SoftBodyDescription& soft_;
  Vec3 low_, high_;
  double cell_ = 1.0;
  int size_[3];
  std::vector<std::vector<int>> cells_;
};

/// The paper's grid: a cell whose sphere lies inside gets it, any other is split in 8 while levels remain.
void fill_cell(const TriangleBvh& bvh, const Vec3& centre, double radius, int level, int levels, double reach,
               std::vector<InnerSphere>& out) {
  const double half_diagonal = radius * std::sqrt(3.0);
  const double d = bvh.signed_distance(centre, reach);
  if (d > half_diagonal) return;  // the whole cell is outside
  if (d <= -radius) {
    InnerSphere sphere;
    sphere.centre = centre;
    sphere.radius = radius;
    sphere.level = level;
    out.push_back(sphere);
    return;
  }
  if (level + 1 >= levels) return;
  for (int child = 0; child < 8; ++child) {
    const Vec3 offset((child & 1) ? 0.5 : -0.5, (child & 2) ? 0.5 : -0.5, (child & 4) ? 0.5 : -0.5);
    fill_cell(bvh, centre + radius * offset, radius / 2, level + 1, levels, reach, out);
  }
}

/// The grid whose first cell's corner is `low`.
std::vector<InnerSphere> lay_grid(const TriangleBvh& bvh, const Vec3& low, const Vec3& high, double radius, int levels,
                                  double reach) {
  const double edge = 2 * radius;
  std::vector<InnerSphere> spheres;
  for (double z = low.z() + radius; z - radius < high.z(); z += edge)
    for (double y = low.y() + radius; y - radius < high.y(); y += edge)
      for (double x = low.x() + radius; x - radius < high.x(); x += edge)
        fill_cell(bvh, Vec3(x, y, z), radius, 0, levels, reach, spheres);
  return spheres;
}

/// The paper leaves open where its grid begins: it is moved in quarters of a cell along one axis after the other, and stays each
/// time where its spheres fill most of the body; of equals the first.
std::vector<InnerSphere> best_grid(const TriangleBvh& bvh, Vec3 low, const Vec3& high, double radius, int levels,
                                   double reach) {
  constexpr int kPlaces = 4;
  const auto filled = [](const std::vector<InnerSphere>& spheres) {
    double sum = 0.0;
    for (const InnerSphere& s : spheres) sum += s.radius * s.radius * s.radius;
    return sum;
  };
  std::vector<InnerSphere> best = lay_grid(bvh, low, high, radius, levels, reach);
  for (int axis = 0; axis < 3; ++axis) {
    const double from = low[axis];
    for (int n = 1; n < kPlaces; ++n) {
      Vec3 moved = low;
      moved[axis] = from - 2 * radius * n / kPlaces;
      std::vector<InnerSphere> spheres = lay_grid(bvh, moved, high, radius, levels, reach);
      if (!(filled(spheres) > filled(best) * (1 + 1e-9))) continue;
      best = std::move(spheres);
      low = moved;
    }
  }
  return best;
}

/// `full`: spheres that touch the surface from inside at points all over it, as large as its shape allows.
void cover_surface(const TriangleBvh& bvh, const FillSettings& settings, std::vector<InnerSphere>& out) {
  const TriangleMesh& mesh = bvh.mesh();
  struct Sample {
    Vec3 point, normal;
    double area = 0.0, sag = 0.0;
    bool vertex = false;
    std::int32_t triangle = -1;
    std::array<double, 3> weight{};
  };
  std::map<std::array<long long, 3>, Sample> samples;  // points shared by neighbouring faces are met once
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& tri = mesh.triangles[t];
    const Vec3 &a = mesh.points[tri[0]], &b = mesh.points[tri[1]], &c = mesh.points[tri[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int parts = std::max(1, static_cast<int>(std::ceil(longest / settings.surface_spacing)));
    const double area = (b - a).cross(c - a).norm() / 2;
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j) {
        const Vec3 p = a + (b - a) * (double(i) / parts) + (c - a) * (double(j) / parts);
        const std::array<long long, 3> key = {std::llround(p.x() * 1e8), std::llround(p.y() * 1e8), std::llround(p.z() * 1e8)};
        Sample& s = samples[key];
        if (s.triangle < 0) {
          s.point = p;
          s.normal = Vec3::Zero();
          s.triangle = static_cast<std::int32_t>(t);
          s.weight = {1.0 - double(i + j) / parts, double(i) / parts, double(j) / parts};
        }
        // Vertices share the whole surface among themselves: they carry the force. A face's other points share it again, by
        // the sub-triangles that meet at each (6 inside the face, 3 on an edge).
        s.vertex = (i == 0 && j == 0) || i == parts || j == parts;
        const int sides = int(i == 0) + int(j == 0) + int(i + j == parts);
        const double share = s.vertex ? area / 3 : (sides == 0 ? 6 : 3) * area / (3.0 * parts * parts);
        s.area += share;
        s.sag = std::max(s.sag, face_sag(longest));
        s.normal += share * bvh.triangle_normal(static_cast<int>(t));
      }
  }
  for (const auto& [key, s] : samples) {
    const Vec3 normal = s.normal.normalized();
    double radius = settings.surface_radius;
    Vec3 centre;
    for (;;) {
      centre = s.point - radius * normal;
      const double depth = -bvh.signed_distance(centre, 2 * radius);
      if (radius - depth <= kMostProtrusion || radius < kMostProtrusion) break;
      radius *= 0.7;
    }
    InnerSphere sphere;
    sphere.centre = centre;
    sphere.radius = radius;
    sphere.level = settings.levels + (radius < 0.5 * settings.surface_radius ? 1 : 0);
    sphere.area = s.area;
    sphere.triangle = s.triangle;
    sphere.surface_weight = s.weight;
    sphere.standoff = s.vertex ? 0.0 : -s.sag;
    out.push_back(sphere);
  }
}

/// Orders spheres into clusters of neighbours by halving along the longest side.
void cluster(std::vector<InnerSphere>& spheres, int first, int count, std::vector<SphereCluster>& out) {
  if (count <= kClusterSize) {
    SphereCluster c;
    c.first = first;
    c.count = count;
    out.push_back(c);
    return;
  }
  Vec3 low = spheres[first].centre, high = low;
  for (int i = first; i < first + count; ++i) {
    low = low.cwiseMin(spheres[i].centre);
    high = high.cwiseMax(spheres[i].centre);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(spheres.begin() + first, spheres.begin() + first + half, spheres.begin() + first + count,
                   [axis](const InnerSphere& a, const InnerSphere& b) {
                     for (int k = 0; k < 3; ++k) {
                       const int x = (axis + k) % 3;
                       if (a.centre[x] != b.centre[x]) return a.centre[x] < b.centre[x];
                     }
                     return a.radius < b.radius;
                   });
  cluster(spheres, first, half, out);
  cluster(spheres, first + half, count - half, out);
}

}  // namespace

double face_sag(double longest_edge) {
  return std::clamp(longest_edge * longest_edge / (8 * kRoundestTool), kLeastSag, kMostSag);
}

SphereTree fill_spheres(const SoftBodyDescription& soft, const SoftSurface& surface, const FillSettings& settings) {
  SphereTree tree;
  TriangleMesh mesh;
  mesh.points = soft.nodes;
  mesh.triangles = surface.triangles;
  const TriangleBvh bvh(mesh);
  double volume = 0.0;
  for (const auto& k : soft.tets) volume += tet_volume(soft.nodes[k[0]], soft.nodes[k[1]], soft.nodes[k[2]], soft.nodes[k[3]]);
  tree.mean_tet_volume = volume / static_cast<double>(soft.tets.size());
  tree.coarse_radius = std::cbrt(3 * settings.sphere_ratio * tree.mean_tet_volume / (4 * M_PI));

  Vec3 low = soft.nodes.front(), high = low;
  for (const Vec3& p : soft.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double reach = (high - low).norm();
  std::vector<InnerSphere> spheres = best_grid(bvh, low, high, tree.coarse_radius, settings.levels, reach);
  if (settings.coverage == Coverage::full) cover_surface(bvh, settings, spheres);
  if (spheres.empty()) throw std::invalid_argument("no inner sphere fits into the soft body; take a smaller sphere ratio");

  cluster(spheres, 0, static_cast<int>(spheres.size()), tree.clusters);
  const TetLocator locator(soft);
  for (InnerSphere& s : spheres) {
    s.tet = locator.locate(s.centre, s.weight);
    const TriangleBvh::Hit hit = bvh.closest(s.centre, reach);
    s.core = settings.coverage == Coverage::full && s.level < settings.levels;
    if (s.core) s.standoff = kCoreShare * s.radius;
    if (s.triangle < 0) {  // of the grid
      s.triangle = hit.triangle;
      for (int k = 0; k < 3; ++k) s.surface_weight[k] = hit.weights[k];
      s.area = M_PI * s.radius * s.radius;  // it answers for its shadow
    }
    const std::vector<int> enclosed = locator.within(s.centre, s.radius);
    s.tied = static_cast<std::int32_t>(enclosed.size());
    tie_sphere(soft, enclosed, s, tree);
    s.touchable = s.core;
    for (int k = 0; k < 3; ++k)
      s.touchable |= s.surface_weight[k] > 0 && soft.node_anchor[mesh.triangles[s.triangle][k]] < 0;
    if (static_cast<int>(tree.spheres_per_level.size()) <= s.level) tree.spheres_per_level.resize(s.level + 1, 0);
    ++tree.spheres_per_level[s.level];
  }
  for (SphereCluster& c : tree.clusters) {
    std::set<std::int32_t> nodes;
    for (int i = c.first; i < c.first + c.count; ++i) {
      for (int v : soft.tets[spheres[i].tet]) nodes.insert(v);
      for (int v : mesh.triangles[spheres[i].triangle]) nodes.insert(v);
    }
    c.first_node = static_cast<std::int32_t>(tree.cluster_nodes.size());
    c.node_count = static_cast<std::int32_t>(nodes.size());
    tree.cluster_nodes.insert(tree.cluster_nodes.end(), nodes.begin(), nodes.end());
  }
  tree.spheres = std::move(spheres);
  tree.distances = sphere_distances(tree, settings.levels);
  return tree;
}

CoverageReport measure_coverage(const SphereTree& tree, const SoftBodyDescription& soft, const SoftSurface& surface,
                                int samples) {
  constexpr double kCovered = 0.00025;
  CoverageReport report;
  double total = 0.0;
  std::vector<double> sums;
  for (const auto& t : surface.triangles) {
    total += (soft.nodes[t[1]] - soft.nodes[t[0]]).cross(soft.nodes[t[2]] - soft.nodes[t[0]]).norm();
    sums.push_back(total);
  }
  int covered = 0;
  for (int i = 0; i < samples; ++i) {
    // A low-discrepancy sequence (Roberts' R2) inside the face, faces chosen evenly by area.
    const double at = total * (i + 0.5) / samples;
    const std::size_t t = std::lower_bound(sums.begin(), sums.end(), at) - sums.begin();
    double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0), v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto& k = surface.triangles[std::min(t, sums.size() - 1)];
    const Vec3 p = soft.nodes[k[0]] * (1 - u - v) + soft.nodes[k[1]] * u + soft.nodes[k[2]] * v;
    double gap = 1e9;
    for (const InnerSphere& s : tree.spheres) gap = std::min(gap, (p - s.centre).norm() - s.radius);
    gap = std::max(0.0, gap);
    report.uncovered_depth_m = std::max(report.uncovered_depth_m, gap);
    report.mean_gap_m += gap / samples;
    covered += gap <= kCovered ? 1 : 0;
  }
  report.covered_fraction = double(covered) / samples;
  return report;
}

}  // namespace vallecula::engine

#include "engine/aist/sphere_ties.h"

#include <Eigen/LU>
#include <algorithm>
#include <set>

namespace vallecula::engine {

namespace {

// Of the sum of the radii. Spheres of cells that share a face touch (1); a coarse one is 1.11 from the split cells beside it;
// across an edge of the grid it is 1.41.
constexpr double kNearlyTouching = 1.15;

}  // namespace

void tie_sphere(const SoftBodyDescription& soft, const std::vector<int>& enclosed, InnerSphere& sphere, SphereTree& tree) {
  std::set<std::int32_t> nodes(soft.tets[sphere.tet].begin(), soft.tets[sphere.tet].end());
  for (int t : enclosed) nodes.insert(soft.tets[t].begin(), soft.tets[t].end());
  const double count = static_cast<double>(nodes.size());
  Vec3 mean = Vec3::Zero();
  for (int v : nodes) mean += soft.nodes[v] / count;
  Mat3 spread = Mat3::Zero();
  for (int v : nodes) spread += (soft.nodes[v] - mean) * (soft.nodes[v] - mean).transpose();
  // Least sum of squares under sum w = 1, sum w x = c; with four nodes these are the barycentric coordinates.
  const Vec3 tilt = spread.inverse() * (sphere.centre - mean);
  sphere.first_tied = static_cast<std::int32_t>(tree.tied_nodes.size());
  sphere.tied_count = static_cast<std::int32_t>(nodes.size());
  for (int v : nodes) {
    tree.tied_nodes.push_back(v);
    tree.tied_weights.push_back(static_cast<float>(1 / count + (soft.nodes[v] - mean).dot(tilt)));
  }
}

std::vector<SphereDistance> sphere_distances(const SphereTree& tree, int levels) {
  const auto& spheres = tree.spheres;
  std::vector<std::int32_t> order;  // along x: only spheres within a coarse diameter are compared
  for (std::size_t s = 0; s < spheres.size(); ++s)
    if (spheres[s].level < levels) order.push_back(static_cast<std::int32_t>(s));
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return std::pair(spheres[a].centre.x(), a) < std::pair(spheres[b].centre.x(), b);
  });
  std::vector<SphereDistance> pairs;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const InnerSphere &a = spheres[order[i]], &b = spheres[order[j]];
      if (b.centre.x() - a.centre.x() > 2 * kNearlyTouching * tree.coarse_radius) break;
      const double distance = (b.centre - a.centre).norm();
      if (distance <= kNearlyTouching * (a.radius + b.radius)) pairs.push_back({order[i], order[j], distance});
    }
  return pairs;
}

}  // namespace vallecula::engine

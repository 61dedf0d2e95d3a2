#include "engine/aist/sphere_ties.h"

#include <Eigen/LU>
#include <set>

namespace vallecula::engine {

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

}  // namespace vallecula::engine

// Exact closest point on a triangle mesh, by a bounding-box tree. Fixed meshes only: built once, outside any tick.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "engine/types.h"

namespace vallecula::engine {

/// Closest point of triangle (a, b, c) to p, and its barycentric weights (Ericson, Real-Time Collision
/// Detection, 5.1.5).
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3* weights = nullptr);

class TriangleBvh {
 public:
  explicit TriangleBvh(const TriangleMesh& mesh);

  struct Hit {
    int triangle = -1;
    Vec3 point = Vec3::Zero();
    Vec3 weights = Vec3::Zero();
    double distance = 0.0;
  };
  /// Nearest surface point within `limit` (m); triangle -1 where there is none. `known` (m): some point of the surface
  /// is known to be that near, the last hit's for one; the answer is the same, and comes sooner.
  Hit closest(const Vec3& p, double limit, double known = std::numeric_limits<double>::infinity()) const;
  /// Distance with its sign: negative inside. The sign comes from the angle-weighted pseudo-normal of the nearest
  /// feature (Baerentzen and Aanaes 2005), exact for closed meshes. `limit` and `known` as in closest(): beyond the
  /// limit +limit.
  double signed_distance(const Vec3& p, double limit, Hit* hit = nullptr,
                         double known = std::numeric_limits<double>::infinity()) const;

  /// Calls visit(triangle) for the triangles of leaves whose box meets [low, high], until it returns false.
  template <class Visit>
  void visit_near(const Vec3& low, const Vec3& high, Visit visit) const {
    int stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--depth])];
      if ((node.low.array() > high.array()).any() || (node.high.array() < low.array()).any()) continue;
      if (node.right < 0) {
        for (int i = node.first; i < node.first + node.count; ++i)
          if (!visit(order_[static_cast<std::size_t>(i)])) return;
        continue;
      }
      stack[depth++] = node.right;
      stack[depth++] = static_cast<int>(&node - nodes_.data()) + 1;
    }
  }

  const TriangleMesh& mesh() const { return mesh_; }
  Vec3 triangle_normal(int t) const { return face_normals_[static_cast<std::size_t>(t)]; }

 private:
  struct Node {
    Vec3 low, high;
    int first = 0, count = 0;  // leaf: range in order_
    int right = -1;            // inner: left child follows its parent
  };
  int build(int first, int count);
  Vec3 pseudo_normal(const Hit& hit) const;

  TriangleMesh mesh_;
  std::vector<int> order_;
  std::vector<std::array<Vec3, 3>> corners_;  // of the triangles in that order
  std::vector<Node> nodes_;
  std::vector<Vec3> face_normals_, vertex_normals_;
  std::vector<std::array<Vec3, 3>> edge_normals_;  // of edges (0,1), (1,2), (2,0)
};

/// Number of edges that are not shared by exactly two triangles of opposite direction; 0 for a closed, oriented mesh.
int count_open_edges(const TriangleMesh& mesh);

}  // namespace vallecula::engine

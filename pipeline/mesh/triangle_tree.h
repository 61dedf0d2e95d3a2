// A tree of boxes about the triangles of a surface: the nearest point, which triangles come near each other, which side
// a point lies on.
#pragma once

#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

class TriangleTree {
 public:
  /// `surface` is copied; it may be empty.
  explicit TriangleTree(const Surface& surface);

  struct Nearest {
    Point point{};
    int triangle = -1;       ///< -1: the surface has none
    double distance2 = 0.0;  ///< mm^2
  };
  Nearest nearest(const Point& p) const;

  const Surface& surface() const { return surface_; }

  /// Calls visit(triangle) for every triangle whose box meets the closed box.
  template <class Visit>
  void for_each_in(const Point& low, const Point& high, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<int, 64> stack;  // the tree is balanced: its depth is the logarithm of the number of triangles
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const auto& node = nodes_[stack[--top]];
      bool meets = true;
      for (int a = 0; a < 3; ++a) meets = meets && node.low[a] <= high[a] && node.high[a] >= low[a];
      if (!meets) continue;
      if (node.count == 0) {
        stack[top++] = node.first;
        stack[top++] = node.first + 1;
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
    }
  }

 private:
  struct Node {
    Point low{};
    Point high{};
    int first = 0;  ///< of the triangles in order_, or the first of two children
    int count = 0;  ///< of triangles; 0 for an inner node
  };
  void build(int node, int first, int count, const std::vector<Point>& centres);

  Surface surface_;
  std::vector<Node> nodes_;
  std::vector<int> order_;
};

/// Distance of points from a surface with the side they lie on, by the angle-weighted normal at the nearest point
/// (Baerentzen and Aanaes 2005).
class SurfaceDistance {
 public:
  /// `surface` is copied; it may be empty.
  explicit SurfaceDistance(const Surface& surface);

  /// mm; negative inside of a closed surface that looks outwards.
  double at(const Point& p) const;

 private:
  TriangleTree tree_;
  std::vector<Point> point_normals_;
  std::vector<std::array<Point, 3>> edge_normals_;  ///< of the edges that begin at a triangle's corners
};

}  // namespace vallecula::pipeline

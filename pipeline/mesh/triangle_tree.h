// A tree of boxes about the triangles of a surface: the nearest point, and which triangles come near each other.
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

  /// Distance of a point from the surface, mm: negative inside of a closed one that looks outwards (by the
  /// angle-weighted normal at the nearest point, Baerentzen and Aanaes 2005).
  double signed_distance(const Point& p) const;

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
  std::vector<Point> point_normals_;
  std::vector<std::array<Point, 3>> edge_normals_;  ///< of the edges that begin at a triangle's corners
};

}  // namespace vallecula::pipeline

// The baseline of the paper's Figure 6: direct collision of primitives. The tissue's surface triangles hang in a tree of boxes
// that is refitted every tick and descended against the tool's own tree; near pairs of triangles are tested vertex against
// face, face against vertex, and edge against edge. What it finds are the same constraints the sphere tree gives.
#pragma once

#include <vector>

#include "engine/contact/contact_constraint.h"
#include "engine/contact/tissue_contact.h"
#include "engine/mesh/triangle_bvh.h"

namespace vallecula::engine {

/// What stays: the tree's topology over the surface at rest, the tool's triangles.
class TriangleCollision {
 public:
  TriangleCollision() = default;
  TriangleCollision(const std::vector<Vec3>& rest, const SoftSurface& surface, const TriangleMesh& tool);

  struct Node {
    std::int32_t first = 0, count = 0;  ///< leaf: range of `order`
    std::int32_t right = -1;            ///< inner: the left child follows its parent; -1: leaf
  };
  struct Edge {
    std::int32_t a, b;
    double sag = 0.0;  ///< of the tissue's: what it gives way before it resists between its vertices (face_sag), m
  };
  std::vector<Node> nodes;               ///< a parent before its children
  std::vector<std::int32_t> order;       ///< surface triangles by leaf
  std::vector<std::int32_t> vertices;    ///< the body's nodes on the surface
  std::vector<std::int32_t> vertex_of;   ///< per node: its place in `vertices`, -1 inside
  std::vector<float> vertex_area;        ///< m^2, a third of the triangles around
  std::vector<std::array<std::int32_t, 3>> triangle_edges;       ///< of the tissue
  std::vector<Edge> edges;
  std::vector<std::array<std::int32_t, 3>> tool_triangle_edges;  ///< of the tool
  std::vector<Edge> tool_edges;
  std::vector<TriangleBvh> tool;         ///< one, or none

  /// Most constraints a tick can give.
  std::size_t most_contacts() const { return vertices.size() + edges.size() + (tool.empty() ? 0 : tool[0].mesh().points.size()); }
};

/// What changes in a tick; sized once.
struct TriangleScratch {
  explicit TriangleScratch(const TriangleCollision& collision);

  struct Box {
    Vec3 low, high;
  };
  struct Near {                 ///< nearest primitive of the other body so far
    double squared = 0.0;
    std::int32_t triangle = -1; ///< surface triangle or tool triangle
    std::int64_t tick = -1;
  };
  struct NearEdge {
    double squared = 0.0;
    Vec3 tool_point = Vec3::Zero();  ///< tool frame
    double along = 0.0;              ///< of the tissue's edge, from a to b
    std::int32_t triangle = -1;
    std::int64_t tick = -1;
  };
  std::vector<Vec3> position;   ///< per node, tool frame
  std::vector<Box> boxes;       ///< per tree node, tool frame
  std::vector<Near> near_vertex, near_tool_vertex;
  std::vector<NearEdge> near_edge;
  std::vector<std::int32_t> touched_vertices, touched_tool_vertices, touched_edges;
  std::int64_t tick = 0;
};

/// Finds this tick's constraints; see find_contacts for what they mean. Only vertices of the tissue remember their
/// multipliers.
void find_triangle_contacts(const TriangleCollision& collision, const SoftSurface& surface, const TissueModel& model,
                            const TissueState& tissue, const Pose& tool, const Pose& previous,
                            float contact_stiffness_per_area, TriangleScratch& scratch, ContactState& contacts) noexcept;

}  // namespace vallecula::engine

#include "engine/contact/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace vallecula::engine {

namespace {

constexpr double kReach = 0.0005;  // m: constraints are set up this far ahead of touch, plus the tool's way in the tick
constexpr double kDeepest = 0.002;  // m: a vertex further inside the tool has lost it
constexpr int kLeafSize = 4;

std::int32_t edge_index(std::map<std::pair<int, int>, std::int32_t>& known, std::vector<TriangleCollision::Edge>& edges,
                        int a, int b) {
  const auto [it, fresh] = known.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(edges.size()));
  if (fresh) edges.push_back({std::min(a, b), std::max(a, b), 0.0});
  return it->second;
}

std::vector<std::array<std::int32_t, 3>> edges_of(const std::vector<std::array<int, 3>>& triangles,
                                                  std::vector<TriangleCollision::Edge>& edges) {
  std::map<std::pair<int, int>, std::int32_t> known;
  std::vector<std::array<std::int32_t, 3>> of;
  for (const auto& t : triangles)
    of.push_back({edge_index(known, edges, t[0], t[1]), edge_index(known, edges, t[1], t[2]),
                  edge_index(known, edges, t[2], t[0])});
  return of;
}

int build(const std::vector<Vec3>& centres, TriangleCollision& c, int first, int count) {
  const int index = static_cast<int>(c.nodes.size());
  c.nodes.push_back({first, count, -1});
  if (count <= kLeafSize) return index;
  Vec3 low = centres[c.order[first]], high = low;
  for (int i = first; i < first + count; ++i) {
    low = low.cwiseMin(centres[c.order[i]]);
    high = high.cwiseMax(centres[c.order[i]]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int half = count / 2;
  std::nth_element(c.order.begin() + first, c.order.begin() + first + half, c.order.begin() + first + count,
                   [&](std::int32_t a, std::int32_t b) {
                     return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
                   });
  build(centres, c, first, half);
  c.nodes[index].right = build(centres, c, first + half, count - half);
  return index;
}

/// Closest points of two segments (Ericson, Real-Time Collision Detection, 5.1.9), as shares of their lengths. False
/// where one of them lies at an end: then a vertex test sees the pair.
bool closest_inside_segments(const Vec3& p, const Vec3& d1, const Vec3& q, const Vec3& d2, double& s, double& t) {
  const Vec3 r = p - q;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const double denominator = a * e - b * b;
  if (!(denominator > 1e-12 * a * e)) return false;
  s = (b * f - c * e) / denominator;
  t = (b * s + f) / e;
  return s > 0 && s < 1 && t > 0 && t < 1;
}

}  // namespace

TriangleCollision::TriangleCollision(const std::vector<Vec3>& rest, const SoftSurface& surface,
                                     const TriangleMesh& mesh) {
  std::vector<Vec3> centres;
  vertex_of.assign(rest.size(), -1);
  for (const auto& t : surface.triangles) {
    centres.push_back((rest[t[0]] + rest[t[1]] + rest[t[2]]) / 3);
    const double third = (rest[t[1]] - rest[t[0]]).cross(rest[t[2]] - rest[t[0]]).norm() / 6;
    for (int v : t) {
      if (vertex_of[v] < 0) {
        vertex_of[v] = static_cast<std::int32_t>(vertices.size());
        vertices.push_back(v);
        vertex_area.push_back(0.0f);
      }
      vertex_area[vertex_of[v]] += static_cast<float>(third);
    }
  }
  order.resize(centres.size());
  std::iota(order.begin(), order.end(), 0);
  build(centres, *this, 0, static_cast<int>(order.size()));
  triangle_edges = edges_of(surface.triangles, edges);
  for (Edge& e : edges) e.sag = face_sag((rest[e.a] - rest[e.b]).norm());
  tool_triangle_edges = edges_of(mesh.triangles, tool_edges);
  tool.emplace_back(mesh);
}

TriangleScratch::TriangleScratch(const TriangleCollision& c)
    : position(c.vertex_of.size()),
      boxes(c.nodes.size()),
      near_vertex(c.vertices.size()),
      near_tool_vertex(c.tool.empty() ? 0 : c.tool[0].mesh().points.size()),
      near_edge(c.edges.size()) {
  touched_vertices.reserve(near_vertex.size());
  touched_tool_vertices.reserve(near_tool_vertex.size());
  touched_edges.reserve(near_edge.size());
}

namespace {

/// Keeps the nearer of what a primitive has met; the first meeting of a tick lists it.
template <class Meeting>
bool nearer(Meeting& known, double squared, std::int64_t tick, std::vector<std::int32_t>& touched, std::int32_t index) {
  if (known.tick != tick) {
    known.tick = tick;
    known.squared = squared;
    touched.push_back(index);
    return true;
  }
  if (squared >= known.squared) return false;
  known.squared = squared;
  return true;
}

/// All primitive tests of one pair of triangles within `reach`.
void test_pair(const TriangleCollision& c, const SoftSurface& surface, std::int32_t soft, std::int32_t rigid,
               double reach, TriangleScratch& s) {
  const TriangleMesh& tool = c.tool[0].mesh();
  const auto& k = surface.triangles[soft];
  const auto& m = tool.triangles[rigid];
  const Vec3* x[3] = {&s.position[k[0]], &s.position[k[1]], &s.position[k[2]]};
  const Vec3* y[3] = {&tool.points[m[0]], &tool.points[m[1]], &tool.points[m[2]]};
  const double reach_squared = reach * reach;
  for (int i = 0; i < 3; ++i) {
    const double squared = (closest_on_triangle(*x[i], *y[0], *y[1], *y[2]) - *x[i]).squaredNorm();
    if (squared > reach_squared) continue;
    const std::int32_t v = c.vertex_of[k[i]];
    if (nearer(s.near_vertex[v], squared, s.tick, s.touched_vertices, v)) s.near_vertex[v].triangle = soft;
  }
  for (int i = 0; i < 3; ++i) {
    const double squared = (closest_on_triangle(*y[i], *x[0], *x[1], *x[2]) - *y[i]).squaredNorm();
    if (squared > reach_squared) continue;
    if (nearer(s.near_tool_vertex[m[i]], squared, s.tick, s.touched_tool_vertices, m[i]))
      s.near_tool_vertex[m[i]].triangle = soft;
  }
  for (int i = 0; i < 3; ++i) {
    const std::int32_t e = c.triangle_edges[soft][i];
    const TriangleCollision::Edge& edge = c.edges[e];
    const Vec3 &p = s.position[edge.a], d1 = s.position[edge.b] - p;
    for (int j = 0; j < 3; ++j) {
      const TriangleCollision::Edge& other = c.tool_edges[c.tool_triangle_edges[rigid][j]];
      const Vec3 &q = tool.points[other.a], d2 = tool.points[other.b] - q;
      double along, along_tool;
      if (!closest_inside_segments(p, d1, q, d2, along, along_tool)) continue;
      const Vec3 at = q + along_tool * d2;
      const double squared = (p + along * d1 - at).squaredNorm();
      if (squared > reach_squared) continue;
      TriangleScratch::NearEdge& known = s.near_edge[e];
      if (nearer(known, squared, s.tick, s.touched_edges, e)) {
        known.tool_point = at;
        known.along = along;
        known.triangle = soft;
      }
    }
  }
}

}  // namespace

void find_triangle_contacts(const TriangleCollision& collision, const SoftSurface& surface, const TissueModel& model,
                            const TissueState& tissue, const Pose& tool, const Pose& previous,
                            float contact_stiffness_per_area, TriangleScratch& scratch,
                            ContactState& contacts) noexcept {
  contacts.count = 0;
  ++scratch.tick;
  scratch.touched_vertices.clear();
  scratch.touched_tool_vertices.clear();
  scratch.touched_edges.clear();
  const TriangleBvh& rigid = collision.tool[0];
  const Mat3 to_world = tool.rotation.toRotationMatrix();
  const Mat3 to_tool = to_world.transpose();
  const double moved =
      (tool.position - previous.position).norm() + 0.1 * tool.rotation.angularDistance(previous.rotation);
  const double reach = std::max(kReach + moved, kDeepest);

  for (std::int32_t v : collision.vertices)
    scratch.position[v] = to_tool * (model.rest[v] + tissue.displacement[v] - tool.position);
  // Children come after their parents, so that one pass from the end refits the tree.
  for (std::size_t n = collision.nodes.size(); n-- > 0;) {
    const TriangleCollision::Node& node = collision.nodes[n];
    TriangleScratch::Box& box = scratch.boxes[n];
    if (node.right >= 0) {
      box.low = scratch.boxes[n + 1].low.cwiseMin(scratch.boxes[node.right].low);
      box.high = scratch.boxes[n + 1].high.cwiseMax(scratch.boxes[node.right].high);
      continue;
    }
    box.low = box.high = scratch.position[surface.triangles[collision.order[node.first]][0]];
    for (int i = node.first; i < node.first + node.count; ++i)
      for (int v : surface.triangles[collision.order[i]]) {
        box.low = box.low.cwiseMin(scratch.position[v]);
        box.high = box.high.cwiseMax(scratch.position[v]);
      }
  }
  const Vec3 margin = Vec3::Constant(reach);
  std::int32_t stack[64];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::int32_t n = stack[--depth];
    const TriangleCollision::Node& node = collision.nodes[n];
    const Vec3 low = scratch.boxes[n].low - margin, high = scratch.boxes[n].high + margin;
    if (node.right >= 0) {
      bool meets = false;
      rigid.visit_near(low, high, [&meets](int) {
        meets = true;
        return false;
      });
      if (!meets) continue;
      stack[depth++] = node.right;
      stack[depth++] = n + 1;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = collision.order[i];
      const auto& k = surface.triangles[t];
      const Vec3 &a = scratch.position[k[0]], &b = scratch.position[k[1]], &c = scratch.position[k[2]];
      rigid.visit_near(a.cwiseMin(b).cwiseMin(c) - margin, a.cwiseMax(b).cwiseMax(c) + margin, [&](int r) {
        test_pair(collision, surface, t, r, reach, scratch);
        return true;
      });
    }
  }

  const auto add = [&](const Vec3& normal, double gap, float area, std::int32_t triangle) -> ContactConstraint& {
    ContactConstraint& c = contacts.constraints[contacts.count++];
    c = ContactConstraint{};
    c.normal = from_vec3(to_world * normal);
    c.gap = static_cast<float>(gap);
    c.stiffness = contact_stiffness_per_area * area;
    c.triangle = triangle;
    for (int k = 0; k < 4; ++k) {
      c.node[k] = surface.triangles[triangle][std::min(k, 2)];
      c.weight[k] = 0.0f;
    }
    c.active = gap < 0;
    return c;
  };
  // What is out of reach has let go and starts anew.
  for (std::size_t v = 0; v < collision.vertices.size(); ++v)
    if (scratch.near_vertex[v].tick != scratch.tick) contacts.memory[v] = SphereContact{};
  const auto held = [&](const ContactConstraint& c) {
    for (int k = 0; k < 3; ++k)
      if (c.weight[k] != 0.0f && !model.fixed(c.node[k])) return false;
    return true;
  };
  std::sort(scratch.touched_vertices.begin(), scratch.touched_vertices.end());
  for (std::int32_t v : scratch.touched_vertices) {
    const std::int32_t node = collision.vertices[v];
    if (model.fixed(node)) continue;
    TriangleBvh::Hit hit;
    const double distance = rigid.signed_distance(scratch.position[node], reach, &hit);
    if (hit.triangle < 0 || distance > kReach + moved || distance < -kDeepest) {
      contacts.memory[v] = SphereContact{};
      continue;
    }
    const Vec3 way = scratch.position[node] - hit.point;
    const Vec3 normal = std::abs(distance) > 1e-9 ? Vec3(way / distance) : rigid.triangle_normal(hit.triangle);
    ContactConstraint& c = add(normal, distance, collision.vertex_area[v], scratch.near_vertex[v].triangle);
    for (int k = 0; k < 3; ++k) c.weight[k] = c.node[k] == node ? 1.0f : 0.0f;
    c.memory = v;
    c.multiplier = contacts.memory[v].multiplier;
    c.active |= contacts.memory[v].pushing;
  }
  for (std::int32_t v : scratch.touched_tool_vertices) {
    const std::int32_t t = scratch.near_tool_vertex[v].triangle;
    const auto& k = surface.triangles[t];
    const Vec3 &a = scratch.position[k[0]], &b = scratch.position[k[1]], &c = scratch.position[k[2]];
    Vec3 weights;
    const Vec3& at = rigid.mesh().points[v];
    const Vec3 on = closest_on_triangle(at, a, b, c, &weights);
    const Vec3 outward = (b - a).cross(c - a).normalized();
    double sag = 0.0;
    for (std::int32_t e : collision.triangle_edges[t]) sag = std::max(sag, collision.edges[e].sag);
    const double gap = (at - on).dot(outward) + sag;
    if (gap > kReach + moved || gap < -kDeepest || weights.minCoeff() <= 0) continue;
    ContactConstraint& constraint = add(-outward, gap, collision.vertex_area[collision.vertex_of[k[0]]], t);
    for (int i = 0; i < 3; ++i) constraint.weight[i] = static_cast<float>(weights[i]);
    if (held(constraint)) --contacts.count;  // nothing there can give way
  }
  for (std::int32_t e : scratch.touched_edges) {
    const TriangleScratch::NearEdge& near = scratch.near_edge[e];
    const TriangleCollision::Edge& edge = collision.edges[e];
    const Vec3 at = scratch.position[edge.a] + near.along * (scratch.position[edge.b] - scratch.position[edge.a]);
    const Vec3 way = at - near.tool_point;
    const double size = way.norm();
    if (!(size > 1e-9)) continue;
    const double distance = rigid.signed_distance(at, reach) < 0 ? -size : size, gap = distance + edge.sag;
    if (gap > kReach + moved || gap < -kDeepest) continue;
    ContactConstraint& c = add(way / distance, gap, collision.vertex_area[collision.vertex_of[edge.a]], near.triangle);
    for (int k = 0; k < 3; ++k)
      c.weight[k] = static_cast<float>(c.node[k] == edge.a ? 1 - near.along : c.node[k] == edge.b ? near.along : 0.0);
    if (held(c)) --contacts.count;
  }
}

}  // namespace vallecula::engine

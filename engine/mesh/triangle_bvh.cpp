#include "engine/mesh/triangle_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

namespace vallecula::engine {

namespace {

constexpr int kLeafSize = 4;

double box_distance_squared(const Vec3& p, const Vec3& low, const Vec3& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

std::pair<int, int> edge_key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, Vec3* weights) {
  const auto found = [&](double u, double v, double w) -> Vec3 {
    if (weights) *weights = Vec3(u, v, w);
    return u * a + v * b + w * c;
  };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return found(1, 0, 0);
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return found(0, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return found(1 - v, v, 0);
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return found(0, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return found(1 - w, 0, w);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return found(0, 1 - w, w);
  }
  const double denominator = va + vb + vc;
  if (!(denominator > 0)) return found(1, 0, 0);  // a degenerate triangle: any of its points will do
  const double v = vb / denominator, w = vc / denominator;
  return found(1 - v - w, v, w);
}

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) : mesh_(mesh) {
  const std::size_t count = mesh_.triangles.size();
  if (count == 0) throw std::invalid_argument("a surface without triangles has no distance");
  face_normals_.resize(count);
  edge_normals_.assign(count, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  vertex_normals_.assign(mesh_.points.size(), Vec3::Zero());
  std::map<std::pair<int, int>, Vec3> edges;
  for (std::size_t t = 0; t < count; ++t) {
    const auto& tri = mesh_.triangles[t];
    const Vec3 &a = mesh_.points[tri[0]], &b = mesh_.points[tri[1]], &c = mesh_.points[tri[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    face_normals_[t] = length > 0 ? Vec3(normal / length) : Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vec3 &o = mesh_.points[tri[k]], &e = mesh_.points[tri[(k + 1) % 3]], &f = mesh_.points[tri[(k + 2) % 3]];
      const Vec3 u = e - o, v = f - o;
      const double scale = u.norm() * v.norm();
      const double angle = scale > 0 ? std::acos(std::clamp(u.dot(v) / scale, -1.0, 1.0)) : 0.0;
      vertex_normals_[tri[k]] += angle * face_normals_[t];
      auto [it, fresh] = edges.try_emplace(edge_key(tri[k], tri[(k + 1) % 3]), Vec3::Zero());
      it->second += face_normals_[t];
    }
  }
  for (std::size_t t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k)
      edge_normals_[t][k] = edges.at(edge_key(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]));
  order_.resize(count);
  corners_.reserve(count);
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(2 * count / kLeafSize + 2);
  build(0, static_cast<int>(count));
  for (int t : order_) {
    const auto& tri = mesh_.triangles[t];
    corners_.push_back({mesh_.points[tri[0]], mesh_.points[tri[1]], mesh_.points[tri[2]]});
  }
}

int TriangleBvh::build(int first, int count) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int i = first; i < first + count; ++i)
    for (int v : mesh_.triangles[order_[i]]) {
      low = low.cwiseMin(mesh_.points[v]);
      high = high.cwiseMax(mesh_.points[v]);
    }
  nodes_[index].low = low;
  nodes_[index].high = high;
  nodes_[index].first = first;
  nodes_[index].count = count;
  if (count <= kLeafSize) return index;
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const auto centre = [&](int t) {
    const auto& tri = mesh_.triangles[t];
    return mesh_.points[tri[0]][axis] + mesh_.points[tri[1]][axis] + mesh_.points[tri[2]][axis];
  };
  const int half = count / 2;
  std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                   [&](int a, int b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a < b; });
  build(first, half);
  nodes_[index].right = build(first + half, count - half);
  nodes_[index].count = 0;
  return index;
}

TriangleBvh::Hit TriangleBvh::closest(const Vec3& p, double limit, double known) const {
  // Rounding may not decide: what is left out is farther than what is kept by more than any rounding is.
  constexpr double kFarther = 1.0 + 1e-9, kLeast = 1e-22;
  Hit best;
  double best_squared = limit * limit;
  double enough = kFarther * known * known + kLeast;
  struct Ahead {
    int node;
    double squared;  // from its box
  };
  Ahead stack[64];
  int top = 0;
  stack[top++] = {0, box_distance_squared(p, nodes_[0].low, nodes_[0].high)};
  while (top > 0) {
    const Ahead ahead = stack[--top];
    if (ahead.squared > best_squared || ahead.squared > enough) continue;
    const Node& node = nodes_[ahead.node];
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto& [a, b, c] = corners_[i];
        if (box_distance_squared(p, a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)) > enough) continue;
        Vec3 weights;
        const Vec3 q = closest_on_triangle(p, a, b, c, &weights);
        const double squared = (p - q).squaredNorm();
        if (squared < best_squared || (best.triangle < 0 && squared <= best_squared)) {
          best_squared = squared;
          enough = std::min(enough, kFarther * squared + kLeast);
          best.triangle = order_[i];
          best.point = q;
          best.weights = weights;
        }
      }
      continue;
    }
    const int left = ahead.node + 1, right = node.right;
    const double dl = box_distance_squared(p, nodes_[left].low, nodes_[left].high);
    const double dr = box_distance_squared(p, nodes_[right].low, nodes_[right].high);
    stack[top++] = dl < dr ? Ahead{right, dr} : Ahead{left, dl};  // the nearer one is looked at first
    stack[top++] = dl < dr ? Ahead{left, dl} : Ahead{right, dr};
  }
  best.distance = best.triangle >= 0 ? std::sqrt(best_squared) : limit;
  return best;
}

Vec3 TriangleBvh::pseudo_normal(const Hit& hit) const {
  constexpr double kOnFeature = 1e-9;
  const auto& tri = mesh_.triangles[hit.triangle];
  int zeros = 0, zero_at = -1, one_at = -1;
  for (int k = 0; k < 3; ++k) {
    if (hit.weights[k] <= kOnFeature) {
      ++zeros;
      zero_at = k;
    } else {
      one_at = k;
    }
  }
  if (zeros >= 2) return vertex_normals_[tri[one_at]];
  if (zeros == 1) return edge_normals_[hit.triangle][(zero_at + 1) % 3];  // the edge opposite to the zero weight
  return face_normals_[hit.triangle];
}

double TriangleBvh::signed_distance(const Vec3& p, double limit, Hit* hit, double known) const {
  const Hit found = closest(p, limit, known);
  if (hit) *hit = found;
  if (found.triangle < 0) return limit;
  return (p - found.point).dot(pseudo_normal(found)) < 0 ? -found.distance : found.distance;
}

int count_open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> balance, uses;
  for (const auto& tri : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = tri[k], b = tri[(k + 1) % 3];
      balance[edge_key(a, b)] += a < b ? 1 : -1;
      uses[edge_key(a, b)] += 1;
    }
  int open = 0;
  for (const auto& [key, sum] : balance) open += (sum != 0 || uses.at(key) % 2 != 0) ? 1 : 0;
  return open;
}

}  // namespace vallecula::engine

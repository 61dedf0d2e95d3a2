#include "gui/session/plane_section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace vallecula::gui {

using engine::Vec3;

std::vector<std::vector<Vec3>> plane_section(const engine::TriangleMesh& surface, const Vec3& point,
                                             const Vec3& normal) {
  std::vector<double> height(surface.points.size());
  for (std::size_t i = 0; i < height.size(); ++i) height[i] = normal.dot(surface.points[i] - point);
  // Triangles of one turn share each edge in opposite directions: where one goes through the plane downwards its
  // neighbour goes upwards, so that a step through each triangle from the one edge to the other goes round.
  using Edge = std::pair<int, int>;
  std::map<Edge, Edge> next;
  for (const auto& t : surface.triangles) {
    Edge down{-1, -1}, up{-1, -1};
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const bool above_a = height[static_cast<std::size_t>(a)] > 0, above_b = height[static_cast<std::size_t>(b)] > 0;
      if (above_a != above_b) (above_a ? down : up) = std::minmax(a, b);
    }
    if (down.first >= 0) next[down] = up;
  }
  std::vector<std::vector<Vec3>> outlines;
  while (!next.empty()) {
    const Edge first = next.begin()->first;
    std::vector<Vec3> outline;
    Edge at = first;
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
      const auto a = static_cast<std::size_t>(at.first), b = static_cast<std::size_t>(at.second);
      const double share = height[a] / (height[a] - height[b]);
      outline.push_back(surface.points[a] + share * (surface.points[b] - surface.points[a]));
      at = found->second;
      next.erase(found);
    }
    if (at == first && outline.size() >= 3) outlines.push_back(std::move(outline));
  }
  return outlines;
}

Outline measured(const std::vector<Vec3>& outline, const Vec3& left, const Vec3& front) {
  Outline out;
  if (outline.size() < 3) return out;
  const Vec3 origin = outline.front();
  double area = 0, mx = 0, my = 0, mxx = 0, myy = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 p = outline[i] - origin, q = outline[(i + 1) % outline.size()] - origin;
    const double px = left.dot(p), py = front.dot(p), qx = left.dot(q), qy = front.dot(q);
    const double cross = px * qy - qx * py;
    area += cross / 2;
    mx += (px + qx) * cross / 6;
    my += (py + qy) * cross / 6;
    mxx += (px * px + px * qx + qx * qx) * cross / 12;
    myy += (py * py + py * qy + qy * qy) * cross / 12;
  }
  if (area == 0.0) return out;
  const double x = mx / area, y = my / area;
  const double spread_x = std::sqrt(std::max(0.0, mxx / area - x * x));
  const double spread_y = std::sqrt(std::max(0.0, myy / area - y * y));
  out.area = std::abs(area);
  out.centre = origin + x * left + y * front;
  if (spread_x > 0 && spread_y > 0) {
    out.half_left = std::sqrt(out.area / M_PI * spread_x / spread_y);
    out.half_front = std::sqrt(out.area / M_PI * spread_y / spread_x);
  }
  return out;
}

bool holds(const std::vector<Vec3>& outline, const Vec3& point, const Vec3& left, const Vec3& front) {
  bool inside = false;
  const double x = left.dot(point), y = front.dot(point);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const double py = front.dot(p), qy = front.dot(q);
    if ((py > y) == (qy > y)) continue;
    const double px = left.dot(p);
    if (x < px + (y - py) / (qy - py) * (left.dot(q) - px)) inside = !inside;
  }
  return inside;
}

}  // namespace vallecula::gui

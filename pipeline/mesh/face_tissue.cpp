#include "pipeline/mesh/face_tissue.h"

#include <algorithm>
#include <map>

#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

std::uint8_t label_at(const Labels& labels, const Point& p) {
  const auto c = labels.grid.nearest(p);
  return labels.grid.contains(c[0], c[1], c[2]) ? labels.at(c[0], c[1], c[2]) : static_cast<std::uint8_t>(kBackground);
}

/// What is in front of the triangle: the first thing met going outwards that is not the head's own tissue.
std::uint8_t in_front(const Labels& labels, const Point& p, const Vector3& normal, double reach) {
  for (double d = 0.3; d <= 1.0; d += 0.35) {
    const auto label = label_at(labels, p + (d * reach) * normal);
    if (label == kAirway || label == kTongue || label == kEpiglottis) return label;
  }
  return kBackground;
}

}  // namespace

std::vector<std::uint8_t> face_tissue(const Surface& face, const Segmentation& s) {
  const double k = s.frame.scale;
  const auto throat = s.throat;
  const auto labels = cropped(s.labels, throat);
  const auto to_jaw = distance_to(cropped(s.bones.mandible, throat));
  const auto to_skull = distance_to(cropped(s.bones.skull, throat));
  const auto to_larynx = distance_to(where(labels, [](std::uint8_t v) { return v == kLarynx; }));
  const auto to_palate = distance_to(where(labels, [](std::uint8_t v) { return v == kSoftPalate; }));
  const Point upper = s.landmarks.at("upper_gum_midline");
  const Point lower = s.landmarks.at("lower_gum_midline");
  const auto& glottis = s.airway.glottis;
  std::vector<Point> lip_edges;
  for (const auto& lips : s.head.lips) {
    const double x = s.hu.grid.origin[0] + lips.x * s.hu.grid.spacing[0];
    lip_edges.push_back({x, lips.upper[0], lips.upper[1]});
    lip_edges.push_back({x, lips.lower[0], lips.lower[1]});
  }
  const auto near_lips = [&](const Point& p) {
    for (const auto& e : lip_edges) {
      const double ahead = p[1] - e[1];
      if (distance(p, e) < 4.2 * k && ahead < 2.6 * k) return true;
    }
    return false;
  };

  std::vector<std::uint8_t> tissue(face.triangles.size());
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    const auto& c = face.triangles[t];
    const Point p = (1.0 / 3.0) * (face.points[c[0]] + face.points[c[1]] + face.points[c[2]]);
    const auto normal = unit(cross(face.points[c[1]] - face.points[c[0]], face.points[c[2]] - face.points[c[0]]));
    const auto front = in_front(labels, p, normal, 2.0 * k);
    auto kind = Tissue::skin;
    if (front != kBackground) {
      kind = Tissue::mucosa;
      const double up = dot(p - glottis.centre, glottis.normal);
      const bool on_palate = p[2] > upper[2] - 4.0 * k && p[2] < upper[2] + 4.5 * k && p[1] < upper[1] + 30.0 * k &&
                             value_at(to_skull, p) < 3.0 * k;
      if (value_at(to_larynx, p) < 0.9 * k ||
          (up > -11.0 * k && up < 1.0 * k && distance(p, glottis.centre + up * glottis.normal) < 6.0 * k)) {
        kind = Tissue::larynx;
      } else if (value_at(to_palate, p) < 1.0 * k) {
        kind = Tissue::palate;
      } else if (on_palate) {
        // The ridge of the gum, and inside of it the roof.
        const bool roof = normal[2] < -0.55 && p[1] > upper[1] + 4.0 * k &&
                          std::abs(p[0] - upper[0]) < 4.0 * k + 0.35 * (p[1] - upper[1]);
        kind = roof ? Tissue::palate : Tissue::gum;
      } else if (value_at(to_jaw, p) < 2.3 * k && p[2] > lower[2] - 6.0 * k) {
        kind = Tissue::gum;
      }
    }
    if (kind != Tissue::larynx && kind != Tissue::gum && kind != Tissue::palate && near_lips(p)) kind = Tissue::lip;
    tissue[t] = static_cast<std::uint8_t>(kind);
  }

  // Majority of the neighbours over edges, three times.
  std::map<std::pair<int, int>, std::array<int, 2>> edges;
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    for (int e = 0; e < 3; ++e) {
      const int a = face.triangles[t][e];
      const int b = face.triangles[t][(e + 1) % 3];
      auto& pair = edges.try_emplace({std::min(a, b), std::max(a, b)}, std::array<int, 2>{-1, -1}).first->second;
      (pair[0] < 0 ? pair[0] : pair[1]) = static_cast<int>(t);
    }
  }
  for (int pass = 0; pass < 3; ++pass) {
    std::vector<std::array<std::uint8_t, 6>> votes(tissue.size());
    for (const auto& [edge, pair] : edges) {
      if (pair[1] < 0) continue;
      ++votes[pair[0]][tissue[pair[1]]];
      ++votes[pair[1]][tissue[pair[0]]];
    }
    for (std::size_t t = 0; t < tissue.size(); ++t) {
      for (std::uint8_t v = 0; v < 6; ++v) {
        if (votes[t][v] >= 2) tissue[t] = v;
      }
    }
  }
  return tissue;
}

void smooth_tissue_borders(Surface& face, const Surface& reference, int rounds) {
  const TriangleTree tree(reference);
  std::map<std::pair<int, int>, std::array<int, 2>> edges;
  std::vector<std::vector<int>> around(face.points.size());
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    for (int e = 0; e < 3; ++e) {
      const int a = face.triangles[t][e];
      const int b = face.triangles[t][(e + 1) % 3];
      auto& pair = edges.try_emplace({std::min(a, b), std::max(a, b)}, std::array<int, 2>{-1, -1}).first->second;
      (pair[0] < 0 ? pair[0] : pair[1]) = static_cast<int>(t);
      around[a].push_back(static_cast<int>(t));
    }
  }
  std::map<int, std::vector<int>> border;  // a point's neighbours along borders
  for (const auto& [edge, pair] : edges) {
    if (pair[1] < 0 || face.tissue[pair[0]] == face.tissue[pair[1]]) continue;
    border[edge.first].push_back(edge.second);
    border[edge.second].push_back(edge.first);
  }
  const auto normal_of = [&](int t) {
    const auto& c = face.triangles[t];
    return cross(face.points[c[1]] - face.points[c[0]], face.points[c[2]] - face.points[c[0]]);
  };
  // The points beside a border follow, so that no triangle there becomes a needle.
  std::map<int, std::vector<int>> beside;
  for (const auto& [edge, pair] : edges) {
    (void)pair;
    for (const auto& [v, n] : {edge, std::pair{edge.second, edge.first}}) {
      if (border.count(n) != 0 && border.count(v) == 0) beside[v];
    }
  }
  for (const auto& [edge, pair] : edges) {
    (void)pair;
    for (const auto& [v, n] : {edge, std::pair{edge.second, edge.first}}) {
      if (const auto found = beside.find(v); found != beside.end()) found->second.push_back(n);
    }
  }
  const auto move = [&](int v, const Point& target) {
    Vector3 normal{};
    std::vector<Vector3> before;
    for (const int t : around[v]) {
      before.push_back(normal_of(t));
      normal = normal + before.back();
    }
    normal = unit(normal);
    const Point start = face.points[v];
    const Vector3 step = target - start;
    face.points[v] = tree.nearest(start + 0.5 * (step - dot(step, normal) * normal)).point;
    for (std::size_t i = 0; i < around[v].size(); ++i) {
      const auto after = normal_of(around[v][i]);
      if (dot(unit(after), unit(before[i])) < 0.9 || norm(after) < 0.5 * norm(before[i])) {
        face.points[v] = start;
        return;
      }
    }
  };
  for (int round = 0; round < rounds; ++round) {
    for (const auto& [v, neighbours] : border) {
      if (neighbours.size() == 2) move(v, 0.5 * (face.points[neighbours[0]] + face.points[neighbours[1]]));
    }
    for (const auto& [v, neighbours] : beside) {
      Vector3 sum{};
      for (const int n : neighbours) sum = sum + face.points[n];
      move(v, (1.0 / static_cast<double>(neighbours.size())) * sum);
    }
  }
}

}  // namespace vallecula::pipeline

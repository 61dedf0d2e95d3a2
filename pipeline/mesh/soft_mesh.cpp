#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/inflate.h"
#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/soft_surface.h"
#include "pipeline/mesh/tet_optimize.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "pipeline/mesh/vector3.h"
#include "pipeline/segment/reslice.h"

namespace vallecula::pipeline {
namespace {

/// Epiglottis where most of the tetrahedron lies nearer to the leaf than to the tongue.
void name_tissue(const Segmentation& s, TetMesh& mesh) {
  if (!s.epiglottis.seen) return;
  const auto labels = cropped(s.labels, s.throat);
  const auto to_leaf = distance_to(s.epiglottis.mask);
  const auto to_tongue = distance_to(where(labels, [](std::uint8_t v) { return v == kTongue; }));
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& c = mesh.tets[t];
    const Point centre = 0.25 * (mesh.points[c[0]] + mesh.points[c[1]] + mesh.points[c[2]] + mesh.points[c[3]]);
    int votes = value_at(to_leaf, centre) < value_at(to_tongue, centre) ? 2 : 0;
    for (const int v : c) {
      const Point p = 0.5 * (centre + mesh.points[v]);
      votes += value_at(to_leaf, p) < value_at(to_tongue, p) ? 1 : 0;
    }
    mesh.tissue[t] = votes >= 4 ? 1 : 0;
  }
}

/// Against tissue the border comes from the partition (soft is zero there), against air from the grey values.
void name_contacts(const Segmentation& s, const AnatomyFields& f, std::size_t surface_points, TetMesh& mesh) {
  mesh.contact.assign(mesh.points.size(), static_cast<std::uint8_t>(Contact::inside));
  for (std::size_t v = 0; v < surface_points; ++v) {
    const auto& p = mesh.points[v];
    const bool against_tissue = value_at(f.soft, p) < 0.35 * s.frame.scale && value_at(f.solid, p) > 0.25;
    mesh.contact[v] = static_cast<std::uint8_t>(against_tissue ? Contact::tissue : Contact::free);
  }
}

/// Nodes of the underside that lie against tissue are held: by the hyoid near it, by the larynx at the leaf's foot,
/// else by the jaw. Nodes that border air are free, and so is the back of a tongue that only lies against the palate of
/// a closed mouth.
void name_anchors(const Segmentation& s, const Surface& border, TetMesh& mesh) {
  const double k = s.frame.scale;
  const Point hyoid = s.landmarks.at("hyoid");
  std::vector<std::uint8_t> in_leaf(mesh.points.size(), 0);
  std::vector<std::uint8_t> in_tongue(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const int v : mesh.tets[t]) (mesh.tissue[t] != 0 ? in_leaf : in_tongue)[v] = 1;
  }
  double foot = 1e30;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (in_leaf[v] != 0) foot = std::min(foot, mesh.points[v][2]);
  }
  const auto normals = point_normals(border);
  std::vector<std::pair<double, std::size_t>> held;  // by distance from the hyoid
  for (std::size_t v = 0; v < border.points.size(); ++v) {
    const auto& p = mesh.points[v];
    if (in_leaf[v] != 0 && p[2] < foot + 2.0 * k) {
      mesh.anchor[v] = static_cast<std::uint8_t>(Anchor::larynx);
      continue;
    }
    if (in_tongue[v] == 0) continue;
    if (mesh.contact[v] != static_cast<std::uint8_t>(Contact::tissue)) continue;
    const bool upper_side = normals[v][2] > 0.2 || (normals[v][2] > -0.3 && normals[v][1] > 0.5);
    if (!upper_side) held.emplace_back(distance(p, hyoid), v);
  }
  std::sort(held.begin(), held.end());
  // The hyoid holds what lies within its reach; a tongue whose root was not grown that far hangs on it by the nearest
  // tenth.
  const std::size_t at_least = held.size() / 10;
  for (std::size_t i = 0; i < held.size(); ++i) {
    const bool near = held[i].first < 9.0 * k || i < at_least;
    mesh.anchor[held[i].second] = static_cast<std::uint8_t>(near ? Anchor::hyoid : Anchor::mandible);
  }
}

struct Filled {
  SoftSurface soft;
  TetMesh mesh;
};

/// What a person can do about a border that crosses itself at a place.
TetrahedralizeError hopeless(const Segmentation& s, const Point& at) {
  const auto labels = cropped(s.labels, s.throat);
  const auto away = [&](std::uint8_t label) {
    return value_at(distance_to(where(labels, [label](std::uint8_t v) { return v == label; })), at);
  };
  const char* name = away(kEpiglottis) < away(kTongue) ? "epiglottis" : "tongue";
  const auto p = moved(inverse_of(s.pose.scan_to_package), at);
  std::ostringstream text;
  text.precision(1);
  text << name << ": its border crosses itself near " << std::fixed << p[0] << ", " << p[1] << ", " << p[2]
       << " mm (LPS, the scan's frame); smooth it there in an editor (3D Slicer) and give it with --labels";
  return TetrahedralizeError(text.str());
}

/// A border drawn by voxels, or carried to where the jaw was opened, can have steps too rough for its triangles: they
/// are smoothed where these cross, and stay so in `field`.
SoftSurface smooth_enough(const Segmentation& s, Volume<float>& field, double factor) {
  constexpr int kRounds = 8;
  auto soft = soft_surface(s, field, factor);
  for (int round = 0; round < kRounds; ++round) {
    const auto places = crossings(soft);
    if (places.empty()) break;
    smooth_about(places, soft, field);
    soft = soft_surface(s, field, factor);
  }
  return soft;
}

/// With the edges that give the wanted count. Their number goes with about the inverse cube of the edge; how exactly is
/// measured on the way.
Filled filled_to_count(const Segmentation& s, Volume<float>& field, int tetrahedra) {
  constexpr int kAttempts = 8;
  constexpr double kNear = 0.04;
  const double wanted = std::log(static_cast<double>(tetrahedra));
  std::optional<Filled> best;
  double best_off = 0.0;
  std::vector<std::array<double, 2>> tried;  // logarithms of factor and count
  // A border drawn by voxels is smoothed at once; one carried by an opened jaw may not need it with other sizes; one
  // cut from grey values as they were measured crosses only where something is wrong with it, and is named.
  bool smooth = !s.replaced.empty();
  const bool carried = s.pose.mouth_opened_deg != 0.0 || s.pose.extension_deg != 0.0;
  int crossed = 0;
  double factor = std::cbrt(4000.0 / tetrahedra);
  for (int attempt = 0;; ++attempt) {
    Filled now;
    try {
      now.soft = smooth ? smooth_enough(s, field, factor) : soft_surface(s, field, factor);
      TetrahedralizeOptions options;
      options.edge_mm = [&](const Point& p) { return 1.1 * now.soft.edge_mm(p); };
      now.mesh = tetrahedralized(now.soft.mesh, options);
      const double count = std::log(static_cast<double>(now.mesh.tets.size()));
      tried.push_back({std::log(factor), count});
      if (!best || std::abs(count - wanted) < best_off) {
        best = std::move(now);
        best_off = std::abs(count - wanted);
      }
    } catch (const TetrahedralizeError& e) {
      // A surface that crosses itself somewhere on the thin leaf does not with other sizes.
      if (attempt + 1 == kAttempts && !best) {
        if (const auto places = crossings(now.soft); !places.empty()) throw hopeless(s, places.front());
        // Of too few triangles the two sides of the thin leaf nearly meet, which kills the generator.
        throw TetrahedralizeError(std::string(e.what()) +
                                  "; import it with another number of tetrahedra (4000 is usual)");
      }
      if (attempt + 1 == kAttempts) return std::move(*best);
      if (carried && !smooth && ++crossed == 2) {
        smooth = true;
        factor /= 0.96;
      } else {
        factor *= 0.96;
      }
      continue;
    }
    if (best_off < kNear || attempt + 1 == kAttempts) return std::move(*best);
    double slope = -3.0;
    if (tried.size() > 1) {
      const auto& a = tried[tried.size() - 2];
      const auto& b = tried.back();
      slope = std::clamp((b[1] - a[1]) / (b[0] - a[0]), -4.0, -1.5);
    }
    factor = std::exp(tried.back()[0] + (wanted - tried.back()[1]) / slope);
  }
}

/// The border with the points as they are in the mesh, where they come first.
Surface border_of(const TetMesh& mesh, const Surface& surface) {
  Surface border = surface;
  std::copy_n(mesh.points.begin(), border.points.size(), border.points.begin());
  return border;
}

/// Filled and improved; tissue, anchors and contacts not yet named.
Filled well_shaped(const Segmentation& s, Volume<float>& field, int tetrahedra) {
  auto filled = filled_to_count(s, field, tetrahedra);
  auto& [soft, mesh] = filled;
  constexpr int kRounds = 20;
  const auto surface_points = soft.mesh.points.size();
  const auto as_filled = mesh;
  optimize_points(mesh, surface_points, soft.track, kRounds);
  if (!self_intersections(border_of(mesh, soft.mesh)).empty()) {
    mesh = as_filled;  // whose border the mesh generator has accepted
    optimize_points(mesh, surface_points, soft.track, kRounds, false);
  }
  return filled;
}

}  // namespace

TetMesh soft_mesh(const Segmentation& s, const AnatomyFields& f, int tetrahedra) {
  // A thin tetrahedron that could not be helped is not there with other sizes.
  constexpr double kGoodAngle = 10.0;
  auto field = soft_field(s, f);
  Filled best;
  double best_angle = -1.0;
  for (const double share : {1.0, 0.97, 1.03, 0.95}) {
    auto now = well_shaped(s, field, static_cast<int>(std::lround(share * tetrahedra)));
    const double angle = quality_of(now.mesh).smallest_dihedral_deg;
    if (angle > best_angle) {
      best = std::move(now);
      best_angle = angle;
    }
    if (best_angle > kGoodAngle) break;
  }
  auto& mesh = best.mesh;
  name_tissue(s, mesh);
  name_contacts(s, f, best.soft.mesh.points.size(), mesh);
  name_anchors(s, border_of(mesh, best.soft.mesh), mesh);
  return std::move(mesh);
}

}  // namespace vallecula::pipeline

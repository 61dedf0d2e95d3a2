#include "pipeline/mesh/anatomy_surfaces.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "pipeline/mesh/face_tissue.h"
#include "pipeline/mesh/inflate.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/mesh/mend.h"
#include "pipeline/mesh/remesh.h"
#include "pipeline/mesh/sampled_volume.h"
#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/vector3.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {
namespace {

using Axes = std::array<std::vector<double>, 3>;

/// Values of a field function at all crossings of the axes.
template <class Field>
std::vector<float> sampled(const Axes& axes, const Field& field) {
  std::vector<float> values(axes[0].size() * axes[1].size() * axes[2].size());
  parallel_for(static_cast<int>(axes[2].size()), [&](int z) {
    std::size_t i = static_cast<std::size_t>(z) * axes[0].size() * axes[1].size();
    for (const double y : axes[1]) {
      for (const double x : axes[0]) values[i++] = static_cast<float>(field(Point{x, y, axes[2][z]}));
    }
  });
  return values;
}

std::array<Point, 2> corners(const Grid& g) {
  return {g.position(0, 0, 0), g.position(g.size[0] - 1, g.size[1] - 1, g.size[2] - 1)};
}

bool holds(const Grid& g, const Point& p) {
  const auto [low, high] = corners(g);
  for (int a = 0; a < 3; ++a) {
    if (p[a] < low[a] || p[a] > high[a]) return false;
  }
  return true;
}

/// Blends sizes: `fine` near a place, growing with the distance from it.
double graded(double fine, double coarse, double away, double over) {
  return fine + (coarse - fine) * std::clamp(away / over, 0.0, 1.0);
}

double outside_of(const Grid& box, const Point& p) {
  const auto [low, high] = corners(box);
  double d2 = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double d = std::max({low[a] - p[a], p[a] - high[a], 0.0});
    d2 += d * d;
  }
  return std::sqrt(d2);
}

/// Middles of the triangles that cross others.
std::vector<Point> places_of(const Surface& s, const std::vector<std::array<int, 2>>& pairs) {
  std::vector<Point> places;
  for (const auto& pair : pairs) {
    const auto& t = s.triangles[pair[0]];
    places.push_back((1.0 / 3.0) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]));
  }
  return places;
}

/// The largest part with triangles of the wanted size, mended; it holds `fuller` times what was cut.
Surface finished(const Surface& rough, double fuller, const RemeshOptions& options, const char* name) {
  constexpr double kReach = 4.0;  // in wanted edges: so far about a crossing the triangles become smaller
  constexpr double kFiner = 0.6;
  constexpr int kTries = 4;
  const auto whole = largest_part(rough);
  const double volume = fuller * size_of(whole).volume_mm3;
  Surface best;
  std::vector<Point> crossings;
  std::size_t fewest = 0;
  // Where a sheet is thinner than the triangles are long two sides may cross: smaller triangles there part them.
  for (int attempt = 0; attempt < kTries; ++attempt) {
    auto finer = options;
    const double smaller = std::pow(kFiner, attempt);
    finer.edge_mm = [&](const Point& p) {
      const double edge = options.edge_mm(p);
      double factor = 1.0;
      for (const auto& c : crossings) {
        if (distance(c, p) < kReach * edge) factor = smaller;
      }
      return factor * edge;
    };
    const auto even = largest_part(remeshed(whole, finer));
    auto out = mended(inflated(even, inflation_to(even, volume)));
    const auto left = self_intersections(out);
    const auto places = places_of(out, left);
    crossings.insert(crossings.end(), places.begin(), places.end());
    if (attempt == 0 || left.size() < fewest) {
      best = std::move(out);
      fewest = left.size();
    }
    if (fewest == 0) break;
  }
  require_solid(best, name);
  return best;
}

Surface face_surface(const Segmentation& s, const AnatomyFields& f, const std::function<void(double)>& progress) {
  const double k = s.frame.scale;
  const auto [low, high] = corners(s.hu.grid);
  const auto throat = cropped(s.hu.grid, s.throat);
  const auto [t_low, t_high] = corners(throat);
  const Point gum = s.landmarks.at("upper_gum_midline");
  // Fine from the larynx to the bridge of the nose and from the lips to the back wall.
  Axes axes;
  axes[0] = graded_axis(low[0], high[0], gum[0] - 20.0 * k, gum[0] + 20.0 * k, 0.55 * k, 1.5 * k);
  axes[1] = graded_axis(low[1], high[1], t_low[1] - 6.0 * k, s.airway.glottis.centre[1] + 13.0 * k, 0.55 * k, 1.5 * k);
  axes[2] = graded_axis(low[2], high[2], s.airway.glottis.centre[2] - 14.0 * k, gum[2] + 28.0 * k, 0.6 * k, 1.5 * k);
  Grid fine;
  fine.origin = {gum[0] - 19.0 * k, t_low[1] - 5.0 * k, s.airway.glottis.centre[2] - 13.0 * k};
  fine.size = {2, 2, 2};
  fine.spacing = {38.0 * k, s.airway.glottis.centre[1] + 17.0 * k - t_low[1], gum[2] + 27.0 * k - fine.origin[2]};
  // Where samples lie further apart than the border is thick the field must be smoothed first, or the surface has
  // steps.
  const auto broad = smoothed(f.solid, 1.0 * k);
  const auto values = sampled(axes, [&](const Point& p) {
    const double away = std::clamp(outside_of(fine, p) / (4.0 * k), 0.0, 1.0);
    double solid = away < 1.0 ? (1.0 - away) * value_at(f.solid, p) : 0.0;
    if (away > 0.0) solid += away * value_at(broad, p);
    return holds(throat, p) ? std::min(solid, -value_at(f.soft, p)) : solid;
  });
  Grid mouth;  // where the operator looks
  mouth.origin = {gum[0] - 17.0 * k, t_low[1] - 4.0 * k, s.airway.glottis.centre[2] - 8.0 * k};
  mouth.size = {2, 2, 2};
  mouth.spacing = {34.0 * k, s.airway.glottis.centre[1] + 12.0 * k - mouth.origin[1],
                   gum[2] + 8.0 * k - mouth.origin[2]};
  RemeshOptions options;
  options.rounds = 4;
  options.progress = [&progress](double done) { progress(0.5 + 0.1 * done); };
  options.edge_mm = [&](const Point& p) {
    const double away = outside_of(mouth, p);
    const double edge = graded(0.85 * k, 2.6 * k, away, 24.0 * k) + graded(0.0, k, away - 24.0 * k, 60.0 * k);
    // What the tongue lies on is seen by nobody and touched by no tool.
    const bool bed = value_at(f.solid, p) > 0.5 && holds(throat, p) && value_at(f.soft, p) > -0.5 * k;
    return bed ? std::max(edge, 1.6 * k) : edge;
  };
  const auto rough = isosurface(axes, values);
  progress(0.2);
  auto face = finished(rough, 1.0, options, "the face");
  face.tissue = face_tissue(face, s);
  smooth_tissue_borders(face, rough, 8);
  face = mended(face);
  require_solid(face, "the face");
  return face;
}

Surface airway_surface(const Segmentation& s, const AnatomyFields& f) {
  const double k = s.frame.scale;
  const auto box = cropped(s.hu.grid, bounds_of(s.airway.lumen, 2.0));
  const auto [low, high] = corners(box);
  const double step = 0.6 * k;
  Axes axes;
  for (int a = 0; a < 3; ++a) axes[a] = graded_axis(low[a], high[a], low[a], high[a], step, step);
  const auto field = [&](const Point& p) { return std::min(-value_at(f.solid, p), value_at(f.airway_side, p)); };
  RemeshOptions options;
  options.rounds = 3;
  options.edge_mm = [k](const Point&) { return 1.2 * k; };
  const auto rough = isosurface(axes, sampled(axes, field));
  return finished(rough, sampled_volume(box, field) / size_of(rough).volume_mm3, options, "the airway");
}

Surface bone_surface(const Volume<float>& field, double edge, const char* name) {
  RemeshOptions options;
  options.rounds = 3;
  options.edge_mm = [edge](const Point&) { return edge; };
  return finished(isosurface(field), 1.0, options, name);
}

/// The upper jaw: the part of the skull about the hard palate and the upper gum.
Mask maxilla_of(const Segmentation& s) {
  const double k = s.frame.scale;
  const Point gum = s.landmarks.at("upper_gum_midline");
  const auto box = box_between(s.hu.grid, gum + k * Vector3{-19.0, -4.0, -8.0}, gum + k * Vector3{19.0, 31.0, 9.0});
  Mask out(s.hu.grid);
  const auto part = cropped(s.bones.skull, box);
  if (count(part) > 0) paste(largest_component(part), box, out);
  return out;
}

Surface mandible_surface(const Segmentation& s) {
  if (count(s.bones.mandible) == 0)
    throw std::runtime_error(
        "the lower jaw could not be parted from the skull, so it has no surface; the series must show the whole jaw");
  return bone_surface(bone_field(s, kMandible, s.bones.mandible, s.bones.skull), 1.6 * s.frame.scale, "the lower jaw");
}

Surface palate_surface(const Segmentation& s) {
  const auto maxilla = maxilla_of(s);
  if (count(maxilla) == 0)
    throw std::runtime_error(
        "no bone of the upper jaw was found above the mouth, so the palate has no surface; the series must show the "
        "head from above the palate");
  const auto others = any_of(without(s.bones.skull, maxilla), s.bones.mandible);
  return bone_surface(bone_field(s, kSkull, maxilla, others), 1.4 * s.frame.scale, "the palate");
}

Surface glottis_surface(const Segmentation& s) {
  Surface out;
  out.points = s.airway.glottis_outline;
  // By ears: the outline is not convex, so a fan would lie on itself.
  vtkNew<vtkPolygon> polygon;
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    polygon->GetPointIds()->InsertNextId(static_cast<vtkIdType>(i));
    polygon->GetPoints()->InsertNextPoint(out.points[i].data());
  }
  vtkNew<vtkIdList> corners;
  polygon->Triangulate(corners);
  for (vtkIdType i = 0; i + 2 < corners->GetNumberOfIds(); i += 3) {
    out.triangles.push_back({static_cast<int>(corners->GetId(i)), static_cast<int>(corners->GetId(i + 1)),
                             static_cast<int>(corners->GetId(i + 2))});
  }
  return out;
}

}  // namespace

std::map<std::string, Surface> surfaces_of(const Segmentation& s, const AnatomyFields& f,
                                           const std::function<void(const std::string&, double)>& progress) {
  const auto say = [&](const char* part, double done) {
    if (progress) progress(part, done);
  };
  // The face takes longer than all others together.
  auto others = std::async(std::launch::async, [&] {
    std::map<std::string, Surface> out;
    out["airway"] = airway_surface(s, f);
    out["mandible"] = mandible_surface(s);
    out["palate"] = palate_surface(s);
    out["glottis"] = glottis_surface(s);
    return out;
  });
  say("face", 0.1);  // the fields were made before
  auto face = face_surface(s, f, [&](double done) { say("face", 0.1 + 0.8 * done); });
  say("airway", 0.9);  // and what else is not done yet
  auto out = others.get();
  out["face"] = std::move(face);
  say("jaw and palate", 1.0);
  return out;
}

}  // namespace vallecula::pipeline

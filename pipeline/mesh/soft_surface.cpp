#include "pipeline/mesh/soft_surface.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pipeline/mesh/inflate.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/mesh/mend.h"
#include "pipeline/mesh/remesh.h"
#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/vector3.h"
#include "pipeline/parallel.h"

namespace vallecula::pipeline {

Volume<float> soft_field(const Segmentation& s, const AnatomyFields& f) {
  const double k = s.frame.scale;
  const auto labels = cropped(s.labels, s.throat);
  const auto soft = where(labels, [](std::uint8_t v) { return v == kTongue || v == kEpiglottis; });
  const auto box = cropped(labels.grid, bounds_of(soft, 2.5 * k));
  Grid lattice;
  lattice.origin = box.origin;
  for (int a = 0; a < 3; ++a) {
    const double length = (box.size[a] - 1) * box.spacing[a];
    const int cells = std::max(1, static_cast<int>(std::ceil(length / (0.5 * k))));
    lattice.size[a] = cells + 1;
    lattice.spacing[a] = length / cells;
  }
  Volume<float> field(lattice);
  parallel_for(lattice.size[2], [&](int z) {
    for (int y = 0; y < lattice.size[1]; ++y) {
      for (int x = 0; x < lattice.size[0]; ++x) {
        const auto p = lattice.position(x, y, z);
        field.at(x, y, z) = static_cast<float>(std::min(value_at(f.solid, p), value_at(f.soft, p)));
      }
    }
  });
  return field;
}

SoftSurface soft_surface(const Segmentation& s, const Volume<float>& field, double edge_factor) {
  const double k = s.frame.scale;
  SoftSurface out;
  out.fine = largest_part(isosurface(field));
  const auto to_leaf = std::make_shared<Volume<float>>(distance_to(s.epiglottis.mask));
  const bool leaf = s.epiglottis.seen;
  out.edge_mm = [to_leaf, leaf, k, edge_factor](const Point& p) {
    const double fine = 1.15 * k * edge_factor;
    const double coarse = 2.5 * k * edge_factor;
    if (!leaf) return coarse;
    return fine + (coarse - fine) * std::clamp((value_at(*to_leaf, p) - 0.5 * k) / (7.0 * k), 0.0, 1.0);
  };
  RemeshOptions options;
  options.rounds = 8;
  options.edge_mm = out.edge_mm;
  const auto even = largest_part(remeshed(out.fine, options));
  // Not the leaf: it is a sheet of one layer of tetrahedra, whose stiffness goes with the cube of its thickness.
  const auto share = [&](const Point& p) {
    return leaf ? std::clamp(value_at(*to_leaf, p) / (4.0 * k), 0.0, 1.0) : 1.0;
  };
  const double by = inflation_to(even, size_of(out.fine).volume_mm3, share);
  out.mesh = mended(inflated(even, by, share));
  out.track = inflated(out.fine, by, share);
  return out;
}

std::vector<Point> crossings(const SoftSurface& soft) {
  std::vector<Point> places;
  for (const auto& pair : self_intersections(soft.mesh)) {
    const auto& t = soft.mesh.triangles[pair[0]];
    const auto& points = soft.mesh.points;
    places.push_back((1.0 / 3.0) * (points[t[0]] + points[t[1]] + points[t[2]]));
  }
  return places;
}

void smooth_about(const std::vector<Point>& places, const SoftSurface& soft, Volume<float>& field) {
  // In edges: what is wider than four standard deviations stays.
  constexpr double kSigma = 0.3;
  constexpr double kReach = 1.0;
  Mask about(field.grid);
  double edge = 1e9;
  for (const auto& p : places) {
    edge = std::min(edge, soft.edge_mm(p));
    const auto c = field.grid.nearest(p);
    if (field.grid.contains(c[0], c[1], c[2])) about.at(c[0], c[1], c[2]) = 1;
  }
  if (count(about) == 0) return;
  const auto box = bounds_of(about, 3.0 * edge);
  const auto share = smoothed(to_float(dilated(cropped(about, box), kReach * edge)), kSigma * edge);
  auto here = cropped(field, box);
  // The field reaches further outside than inside: uneven depths would move the border.
  auto even = here;
  for (auto& v : even.voxels) v = std::clamp(v, -1.0F, 1.0F);
  even = smoothed(even, kSigma * edge);
  for (std::size_t i = 0; i < here.voxels.size(); ++i)
    here.voxels[i] += share.voxels[i] * (even.voxels[i] - here.voxels[i]);
  paste(here, box, field);
}

}  // namespace vallecula::pipeline

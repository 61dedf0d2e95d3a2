#include "gui/views/fine_tongue.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "gui/session/poly_data.h"
#include "gui/views/drawn_triangles.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/package/label_map.h"
#include "pipeline/segment/reslice.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::gui {
namespace {

using pipeline::Point;

constexpr double kCellMm = 3.0, kOutsideMm = 1.5;  // of the grid that tetrahedra are looked up by
constexpr double kTriangleMm = 0.45;               // of the surface's triangles, about
constexpr int kTongueTriangles = 10000;
constexpr int kFairings = 15;
constexpr double kPassBand = 0.1;  // the steps of voxels go, the shape stays

std::array<int, 3> cell_of(const Point& p) {
  return {static_cast<int>(std::floor(p[0] / kCellMm)), static_cast<int>(std::floor(p[1] / kCellMm)),
          static_cast<int>(std::floor(p[2] / kCellMm))};
}

/// Tongue and epiglottis alone, with a rim, at no more than kTriangleMm; from 0 outside to 1 inside.
pipeline::Volume<float> soft_share(const pipeline::Labels& labels) {
  const auto& g = labels.grid;
  std::array<int, 3> low = g.size, high{-1, -1, -1}, stride{};
  for (std::size_t i = 0; i < labels.voxels.size(); ++i)
    if (labels.voxels[i] == pipeline::kTongue || labels.voxels[i] == pipeline::kEpiglottis) {
      const auto c = g.cell(i);
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], c[a]);
        high[a] = std::max(high[a], c[a]);
      }
    }
  pipeline::Grid part;
  if (high[0] < 0) return pipeline::Volume<float>(part, 0.0f);
  for (int a = 0; a < 3; ++a) {
    stride[a] = std::max(1, static_cast<int>(kTriangleMm / g.spacing[a] + 0.25));
    part.spacing[a] = stride[a] * g.spacing[a];
    part.size[a] = (high[a] - low[a]) / stride[a] + 9;
    part.origin[a] = g.origin[a] + (low[a] - 4 * stride[a] + 0.5 * (stride[a] - 1)) * g.spacing[a];
  }
  pipeline::Volume<float> share(part, 0.0f);
  const float one = 1.0f / static_cast<float>(stride[0] * stride[1] * stride[2]);
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const auto v = labels.at(x, y, z);
        if (v == pipeline::kTongue || v == pipeline::kEpiglottis)
          share.at(4 + (x - low[0]) / stride[0], 4 + (y - low[1]) / stride[1], 4 + (z - low[2]) / stride[2]) += one;
      }
  return share;
}

bool fits(const pipeline::TetMesh& mesh, vtkPolyData* surface) {
  std::map<std::array<int, 3>, int> faces;
  for (const auto& t : mesh.tets)
    for (int left_out = 0; left_out < 4; ++left_out) {
      std::array<int, 3> face{};
      for (int k = 0, n = 0; k < 4; ++k)
        if (k != left_out) face[static_cast<std::size_t>(n++)] = t[static_cast<std::size_t>(k)];
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  double sum = 0.0;
  int count = 0;
  for (const auto& [face, times] : faces)
    if (times == 1)
      for (const int node : face) {
        double nearest[3], squared = 0.0;
        vtkIdType cell = 0;
        int part = 0;
        locator->FindClosestPoint(mesh.points[static_cast<std::size_t>(node)].data(), nearest, cell, part, squared);
        sum += std::sqrt(squared);
        ++count;
      }
  return count > 0 && sum < kFitsMm * count;
}

}  // namespace

std::vector<TetTie> tie_to_tets(const pipeline::TetMesh& mesh, const std::vector<Point>& points_mm) {
  struct Tet {
    Eigen::Matrix3d to_shares;
    Eigen::Vector3d origin;
  };
  const auto at = [&](int node) {
    const Point& p = mesh.points[static_cast<std::size_t>(node)];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  std::vector<Tet> tets;
  std::map<std::array<int, 3>, std::vector<int>> in_cell;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& t = mesh.tets[i];
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = at(t[static_cast<std::size_t>(k + 1)]) - at(t[0]);
    tets.push_back({edges.inverse(), at(t[0])});
    Point low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
    for (const int node : t)
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], mesh.points[static_cast<std::size_t>(node)][a] - kOutsideMm);
        high[a] = std::max(high[a], mesh.points[static_cast<std::size_t>(node)][a] + kOutsideMm);
      }
    const auto from = cell_of(low), to = cell_of(high);
    for (int x = from[0]; x <= to[0]; ++x)
      for (int y = from[1]; y <= to[1]; ++y)
        for (int z = from[2]; z <= to[2]; ++z) in_cell[{x, y, z}].push_back(static_cast<int>(i));
  }
  std::vector<int> all(tets.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  std::vector<TetTie> ties;
  ties.reserve(points_mm.size());
  for (const Point& p : points_mm) {
    const auto found = in_cell.find(cell_of(p));
    double best = -1e30;
    TetTie tie;
    for (const int i : found == in_cell.end() ? all : found->second) {
      const Tet& tet = tets[static_cast<std::size_t>(i)];
      const Eigen::Vector3d s = tet.to_shares * (Eigen::Vector3d(p[0], p[1], p[2]) - tet.origin);
      const double first = 1.0 - s.sum(), least = std::min(first, s.minCoeff());
      if (least <= best) continue;
      best = least;
      tie.nodes = mesh.tets[static_cast<std::size_t>(i)];
      tie.shares = {static_cast<float>(first), static_cast<float>(s[0]), static_cast<float>(s[1]),
                    static_cast<float>(s[2])};
    }
    ties.push_back(tie);
  }
  return ties;
}

std::optional<pipeline::Surface> segmented_tongue(const pipeline::PatientPackage& package,
                                                  const pipeline::Labels& labels) {
  pipeline::Volume<float> field = soft_share(labels);
  if (field.voxels.empty()) return std::nullopt;
  const auto& d = field.grid.spacing;
  field = pipeline::smoothed(field, std::min({d[0], d[1], d[2]}));
  for (float& v : field.voxels) v -= 0.5f;
  pipeline::Surface surface = pipeline::isosurface(field);
  if (surface.triangles.empty()) return std::nullopt;
  for (Point& p : surface.points) p = pipeline::moved(package.pose.scan_to_package, p);
  vtkNew<vtkWindowedSincPolyDataFilter> fair;
  fair->SetInputData(poly_data(surface.points, surface.triangles));
  fair->SetNumberOfIterations(kFairings);
  fair->SetPassBand(kPassBand);
  fair->NormalizeCoordinatesOn();
  fair->Update();
  const auto drawn = with_fewer_triangles(fair->GetOutput(), kTongueTriangles);
  if (!fits(package.tongue, drawn)) return std::nullopt;
  pipeline::Surface tongue;
  tongue.points.resize(static_cast<std::size_t>(drawn->GetNumberOfPoints()));
  for (std::size_t i = 0; i < tongue.points.size(); ++i)
    drawn->GetPoint(static_cast<vtkIdType>(i), tongue.points[i].data());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < drawn->GetNumberOfCells(); ++i) {
    drawn->GetCellPoints(i, corners);
    tongue.triangles.push_back({static_cast<int>(corners->GetId(0)), static_cast<int>(corners->GetId(1)),
                                static_cast<int>(corners->GetId(2))});
  }
  return tongue;
}

}  // namespace vallecula::gui

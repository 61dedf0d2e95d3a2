// The tongue's fine surface: where it lies at rest against the exact shape that was segmented, and that it goes with the
// tetrahedra.
#include "gui/views/fine_tongue.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>

#include "gui/views/soft_surface.h"
#include "pipeline/package/label_map.h"

namespace vallecula::gui {
namespace {

using pipeline::Point;

constexpr double kHalf[3] = {12.0, 16.0, 9.0};  // mm, of an ellipsoid as large as a newborn's tongue
constexpr double kSpacing[3] = {0.5, 0.5, 0.8};

/// How far inside (positive) a point is, mm; exact at the surface to first order.
double depth(const Point& p) {
  double f = 0.0, slope = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double q = p[static_cast<std::size_t>(a)] / kHalf[a];
    f += q * q;
    slope += 4.0 * q * q / (kHalf[a] * kHalf[a]);
  }
  return (1.0 - f) / std::max(std::sqrt(slope), 1e-9);
}

pipeline::Labels ellipsoid_labels() {
  pipeline::Grid grid;
  for (std::size_t a = 0; a < 3; ++a) {
    grid.spacing[a] = kSpacing[a];
    grid.size[a] = static_cast<int>(2.0 * (kHalf[a] + 4.0) / kSpacing[a]);
    grid.origin[a] = -0.5 * (grid.size[a] - 1) * kSpacing[a] + 0.137;  // not in step with the shape
  }
  pipeline::Labels labels(grid, 0);
  for (std::size_t i = 0; i < labels.voxels.size(); ++i)
    if (depth(grid.position(i)) > 0.0) labels.voxels[i] = pipeline::kTongue;
  return labels;
}

/// Coarse: Kuhn's six tetrahedra in cubes of `step`, about the ellipsoid, their outer nodes drawn onto it.
pipeline::PatientPackage ellipsoid_package(double step) {
  pipeline::PatientPackage package;
  auto& mesh = package.tongue;
  const int n = static_cast<int>(20.0 / step);
  std::vector<int> number(static_cast<std::size_t>((2 * n + 1) * (2 * n + 1) * (2 * n + 1)), -1);
  const auto node = [&](int i, int j, int k) {
    int& id = number[static_cast<std::size_t>(((k + n) * (2 * n + 1) + j + n) * (2 * n + 1) + i + n)];
    if (id < 0) {
      id = static_cast<int>(mesh.points.size());
      mesh.points.push_back({i * step, j * step, k * step});
    }
    return id;
  };
  for (int k = -n; k < n; ++k)
    for (int j = -n; j < n; ++j)
      for (int i = -n; i < n; ++i) {
        if (depth({(i + 0.5) * step, (j + 0.5) * step, (k + 0.5) * step}) < 0.0) continue;
        int c[8];
        for (int corner = 0; corner < 8; ++corner)
          c[corner] = node(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2 & 1));
        const int ways[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
        for (const auto& way : ways) {
          mesh.tets.push_back({c[0], c[way[0]], c[way[1]], c[7]});
          mesh.tissue.push_back(0);
        }
      }
  for (Point& p : mesh.points)
    if (depth(p) < 0.6 * step) {
      double f = 0.0;
      for (std::size_t a = 0; a < 3; ++a) f += p[a] * p[a] / (kHalf[a] * kHalf[a]);
      for (double& x : p) x /= std::sqrt(f);
    }
  return package;
}

TEST(FineTongue, LiesAtRestWhereTheSegmentedShapeIs) {
  const auto surface = segmented_tongue(ellipsoid_package(2.5), ellipsoid_labels());
  ASSERT_TRUE(surface);
  double mean = 0.0, worst = 0.0;
  for (const Point& p : surface->points) {
    mean += std::abs(depth(p)) / static_cast<double>(surface->points.size());
    worst = std::max(worst, std::abs(depth(p)));
  }
  std::cout << surface->triangles.size() << " triangles, mean " << mean << " mm, worst " << worst << " mm\n";
  // Voxels of 0.5 x 0.5 x 0.8 mm know their shape to half a voxel at worst, a tenth in the mean.
  EXPECT_LT(mean, 0.08);
  EXPECT_LT(worst, 0.40);
}

TEST(FineTongue, GoesExactlyWithAnAffineMotionOfTheTetrahedra) {
  const auto package = ellipsoid_package(2.5);
  const auto fine = segmented_tongue(package, ellipsoid_labels());
  ASSERT_TRUE(fine);
  Eigen::Matrix3d stretch;
  stretch << 1.10, 0.20, -0.05, -0.15, 0.85, 0.10, 0.05, 0.08, 1.05;
  const Eigen::Vector3d shift(3.0, -7.0, 11.0);
  const auto moved = [&](const Point& p) { return (stretch * Eigen::Vector3d(p[0], p[1], p[2]) + shift).eval(); };
  SoftSurface surface(package.tongue, *fine);
  std::vector<float> nodes;
  for (const Point& p : package.tongue.points) {
    const Eigen::Vector3d q = 1e-3 * moved(p);
    for (int a = 0; a < 3; ++a) nodes.push_back(static_cast<float>(q[a]));
  }
  surface.update(nodes);
  const auto first = surface.surface()->GetNumberOfPoints() - static_cast<vtkIdType>(fine->points.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < fine->points.size(); ++i) {
    const double* at = surface.surface()->GetPoint(first + static_cast<vtkIdType>(i));
    worst = std::max(worst, (Eigen::Vector3d(at[0], at[1], at[2]) - moved(fine->points[i])).norm());
  }
  EXPECT_LT(worst, 1e-4) << "mm: what single precision leaves";
  EXPECT_EQ(surface.surface()->GetNumberOfCells(), static_cast<vtkIdType>(fine->triangles.size()));
  surface.set_coarser(1);
  EXPECT_LT(surface.surface()->GetNumberOfCells(), static_cast<vtkIdType>(fine->triangles.size()) / 4);
}

TEST(FineTongue, EveryPointIsTiedWhereItLies) {
  const auto mesh = ellipsoid_package(2.5).tongue;
  const std::vector<Point> points{{0.3, 0.1, -0.2}, {11.9, 0.0, 0.0}, {0.0, -16.3, 0.0}, {4.1, 7.7, 5.0}};
  const auto ties = tie_to_tets(mesh, points);
  ASSERT_EQ(ties.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point at{0, 0, 0};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t a = 0; a < 3; ++a)
        at[a] += ties[i].shares[k] * mesh.points[static_cast<std::size_t>(ties[i].nodes[k])][a];
    for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(at[a], points[i][a], 1e-4) << i;
  }
  for (const float share : ties[0].shares) EXPECT_GE(share, -1e-6f) << "inside";
}

TEST(FineTongue, LabelsThatLieElsewhereAreNotTaken) {
  auto package = ellipsoid_package(2.5);
  for (Point& p : package.tongue.points) p[1] += 6.0;  // the mouth was opened after the scan
  EXPECT_FALSE(segmented_tongue(package, ellipsoid_labels()));
  pipeline::Labels none = ellipsoid_labels();
  for (auto& v : none.voxels) v = pipeline::kSkin;
  EXPECT_FALSE(segmented_tongue(ellipsoid_package(2.5), none));
}

}  // namespace
}  // namespace vallecula::gui

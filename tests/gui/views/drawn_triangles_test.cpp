// Fewer triangles, against a sphere whose shape and colour are known everywhere.
#include "gui/views/drawn_triangles.h"

#include <gtest/gtest.h>
#include <vtkFloatArray.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "gui/views/patient_look.h"
#include "tests/gui/window_patient.h"

namespace vallecula::gui {
namespace {

constexpr double kRadius = 40.0;
constexpr int kAsked = 4000;

vtkSmartPointer<vtkPolyData> sphere() {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(kRadius);
  source->SetThetaResolution(180);
  source->SetPhiResolution(120);
  source->Update();
  vtkSmartPointer<vtkPolyData> ball = source->GetOutput();
  vtkNew<vtkFloatArray> height;
  height->SetName("height");
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i) height->InsertNextValue(static_cast<float>(ball->GetPoint(i)[2]));
  ball->GetPointData()->AddArray(height);
  return ball;
}

TEST(DrawnTriangles, AreAsFewAsAskedForAndLieOnTheSphere) {
  const auto fewer = with_fewer_triangles(sphere(), kAsked);
  EXPECT_LE(fewer->GetNumberOfPolys(), kAsked + 2);
  EXPECT_GT(fewer->GetNumberOfPolys(), kAsked / 2);
  // Triangles of equal area on a sphere stand off by edge^2 / (6 R) at most; the corners are free to share that.
  const double edge2 = 4.0 * M_PI * kRadius * kRadius / kAsked * 4.0 / std::sqrt(3.0);
  double worst = 0.0;
  for (vtkIdType i = 0; i < fewer->GetNumberOfPoints(); ++i) {
    double p[3];
    fewer->GetPoint(i, p);
    worst = std::max(worst, std::abs(std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - kRadius));
  }
  EXPECT_LT(worst, edge2 / (6.0 * kRadius)) << "mm";
}

TEST(DrawnTriangles, KeepTheArraysOfTheirPlace) {
  const auto fewer = with_fewer_triangles_and_its_arrays(sphere(), kAsked);
  auto* height = fewer->GetPointData()->GetArray("height");
  auto* normals = fewer->GetPointData()->GetNormals();
  ASSERT_NE(height, nullptr);
  ASSERT_NE(normals, nullptr);
  for (vtkIdType i = 0; i < fewer->GetNumberOfPoints(); ++i) {
    double p[3], n[3];
    fewer->GetPoint(i, p);
    normals->GetTuple(i, n);
    EXPECT_NEAR(height->GetTuple1(i), p[2], 0.1);
    EXPECT_GT((n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) / kRadius, 0.999) << "outward, and of its length";
  }
}

TEST(DrawnTriangles, ASurfaceWithoutTooManyStaysAsItIs) {
  const auto ball = sphere();
  const auto same = with_fewer_triangles(ball, static_cast<int>(ball->GetNumberOfPolys()));
  ASSERT_EQ(same->GetNumberOfPoints(), ball->GetNumberOfPoints());
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); i += 97)
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(same->GetPoint(i)[axis], ball->GetPoint(i)[axis]);
}

TEST(DrawnTriangles, TheFaceIsDrawnWithinATenthOfAMillimetre) {
  const auto package = window_test::coarse_patient();
  const auto look = make_patient_look(package, {}, Seen::all_round);
  const auto& face = package.surfaces.at("face");
  vtkNew<vtkImplicitPolyDataDistance> drawn;
  drawn->SetInput(look->face);
  double worst = 0.0, mean = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < face.points.size(); i += 11) {
    pipeline::Point p = face.points[i];
    const double off = std::abs(drawn->EvaluateFunction(p.data()));
    worst = std::max(worst, off);
    mean += off;
    ++count;
  }
  std::cout << face.triangles.size() << " triangles, drawn " << look->face->GetNumberOfPolys() << ": mean " << mean / count
            << " mm, worst " << worst << " mm\n";
  EXPECT_LT(look->face->GetNumberOfPolys(), static_cast<vtkIdType>(face.triangles.size()));
  EXPECT_LT(worst, 0.15);
  EXPECT_LT(mean / count, 0.03);
}

}  // namespace
}  // namespace vallecula::gui

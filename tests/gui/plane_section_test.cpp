// Cuts of solids whose sections are known.
#include "gui/session/plane_section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vallecula::gui::test {
namespace {

using engine::Vec3;

/// A closed box; outward triangles.
void add_box(engine::TriangleMesh& mesh, const Vec3& low, const Vec3& high) {
  const int first = static_cast<int>(mesh.points.size());
  for (int corner = 0; corner < 8; ++corner)
    mesh.points.emplace_back(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                             corner & 4 ? high.z() : low.z());
  constexpr int kFaces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& face : kFaces) mesh.triangles.push_back({first + face[0], first + face[1], first + face[2]});
}

engine::TriangleMesh box(const Vec3& low, const Vec3& high) {
  engine::TriangleMesh mesh;
  add_box(mesh, low, high);
  return mesh;
}

TEST(PlaneSection, ACubeCutAcrossIsASquare) {
  const auto outlines = plane_section(box({0, 0, 0}, {2, 2, 2}), {1, 1, 0.7}, Vec3::UnitZ());
  ASSERT_EQ(outlines.size(), 1u);
  const Outline square = measured(outlines[0], Vec3::UnitX(), Vec3::UnitY());
  EXPECT_NEAR(square.area, 4.0, 1e-12);
  EXPECT_NEAR((square.centre - Vec3(1, 1, 0.7)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(square.half_left, std::sqrt(4.0 / M_PI), 1e-12);
  EXPECT_NEAR(square.half_front, std::sqrt(4.0 / M_PI), 1e-12);
}

TEST(PlaneSection, ACubeCutAcrossItsDiagonalIsTheRegularHexagon) {
  const Vec3 normal = Vec3(1, 1, 1).normalized(), left = Vec3(1, -1, 0).normalized();
  const auto outlines = plane_section(box({-1, -1, -1}, {1, 1, 1}), Vec3::Zero(), normal);
  ASSERT_EQ(outlines.size(), 1u);
  const Outline hexagon = measured(outlines[0], left, normal.cross(left));
  EXPECT_NEAR(hexagon.area, 3 * std::sqrt(3.0), 1e-12);  // side sqrt 2
  EXPECT_NEAR(hexagon.centre.norm(), 0.0, 1e-12);
  EXPECT_NEAR(hexagon.half_left, hexagon.half_front, 1e-12) << "six equal sides spread the same way all about";
}

TEST(PlaneSection, AVertexOnThePlaneOpensNothing) {
  // Through two opposite edges of the cube: four vertices lie on the plane.
  const Vec3 normal = Vec3(1, -1, 0).normalized(), left = Vec3(1, 1, 0).normalized();
  const auto outlines = plane_section(box({-1, -1, -1}, {1, 1, 1}), Vec3::Zero(), normal);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(measured(outlines[0], left, normal.cross(left)).area, 4 * std::sqrt(2.0), 1e-12);
}

TEST(PlaneSection, BodiesApartAreOutlinesApartAndAPlaneBesideThemCutsNothing) {
  engine::TriangleMesh mesh = box({-3, -1, -1}, {-1, 1, 1});
  add_box(mesh, {1, -2, -1}, {3, 2, 1});
  const auto outlines = plane_section(mesh, {0, 0, 0.3}, Vec3::UnitZ());
  ASSERT_EQ(outlines.size(), 2u);
  double areas = 0.0;
  for (const auto& outline : outlines) {
    const Outline one = measured(outline, Vec3::UnitX(), Vec3::UnitY());
    areas += one.area;
    EXPECT_NE(holds(outline, Vec3(-2, 0, 0.3), Vec3::UnitX(), Vec3::UnitY()),
              holds(outline, Vec3(2, 0, 0.3), Vec3::UnitX(), Vec3::UnitY()));
    EXPECT_FALSE(holds(outline, Vec3(0, 0, 0.3), Vec3::UnitX(), Vec3::UnitY()));
  }
  EXPECT_NEAR(areas, 4.0 + 8.0, 1e-12);
  EXPECT_TRUE(plane_section(mesh, {0, 0, 2}, Vec3::UnitZ()).empty());
}

TEST(PlaneSection, AnOpenSurfaceGivesNoOutlineWhereItIsOpen) {
  engine::TriangleMesh mesh = box({-1, -1, -1}, {1, 1, 1});
  mesh.triangles.resize(10);  // without the side x = 1
  EXPECT_TRUE(plane_section(mesh, Vec3::Zero(), Vec3::UnitZ()).empty());
}

TEST(PlaneSection, TheEllipseOfAnEllipseIsItself) {
  std::vector<Vec3> outline;
  constexpr int kCorners = 720;
  for (int i = 0; i < kCorners; ++i) {
    const double a = -2 * M_PI * i / kCorners;  // either way round
    outline.emplace_back(5 + 2.25 * std::cos(a), 1 + 2.73 * std::sin(a), 4);
  }
  const Outline ellipse = measured(outline, Vec3::UnitX(), Vec3::UnitY());
  EXPECT_NEAR(ellipse.half_left, 2.25, 1e-4);
  EXPECT_NEAR(ellipse.half_front, 2.73, 1e-4);
  EXPECT_NEAR((ellipse.centre - Vec3(5, 1, 4)).norm(), 0.0, 1e-12);
  EXPECT_EQ(measured({}, Vec3::UnitX(), Vec3::UnitY()).area, 0.0);
}

}  // namespace
}  // namespace vallecula::gui::test

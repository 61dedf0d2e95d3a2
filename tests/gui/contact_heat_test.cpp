// Where the blade pressed, and how hard: against areas known by geometry.
#include "gui/session/contact_heat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "gui/views/heat_look.h"

namespace vallecula::gui {
namespace {

constexpr int kAcross = 20;        // cells of 2 mm
constexpr double kCell_mm = 2.0;

/// A slab 40 x 40 x 2 mm with its top at z = 0, Kuhn's six tetrahedra a cell; tongue for x < 0, epiglottis beyond.
pipeline::TetMesh slab() {
  pipeline::TetMesh mesh;
  const auto node = [](int x, int y, int z) { return (z * (kAcross + 1) + y) * (kAcross + 1) + x; };
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y <= kAcross; ++y)
      for (int x = 0; x <= kAcross; ++x)
        mesh.points.push_back({kCell_mm * (x - kAcross / 2), kCell_mm * (y - kAcross / 2), kCell_mm * (z - 1)});
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  for (int y = 0; y < kAcross; ++y)
    for (int x = 0; x < kAcross; ++x)
      for (int order = 0; order < 6; ++order) {
        int at[3] = {x, y, 0};
        std::array<int, 4> tet{};
        tet[0] = node(at[0], at[1], at[2]);
        for (int step = 0; step < 3; ++step) {
          ++at[kOrders[order][step]];
          tet[step + 1] = node(at[0], at[1], at[2]);
        }
        if (order >= 3) std::swap(tet[1], tet[2]);
        mesh.tets.push_back(tet);
        mesh.tissue.push_back(x < kAcross / 2 ? 0 : 1);
      }
  return mesh;
}

/// A box with its underside on z = 0 of the tool frame, m.
engine::ToolDescription box(double wide_mm, double long_mm) {
  engine::ToolDescription tool;
  for (int i = 0; i < 8; ++i)
    tool.surface.points.push_back(1e-3 * engine::Vec3((i & 1 ? 0.5 : -0.5) * wide_mm, (i & 2 ? 0.5 : -0.5) * long_mm,
                                                      i & 4 ? 4.0 : 0.0));
  tool.surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return tool;
}

engine::Snapshot at_rest(const pipeline::TetMesh& mesh, const engine::Vec3& tool_mm) {
  engine::Snapshot snapshot;
  snapshot.step = 1;
  for (const auto& p : mesh.points)
    for (const double c : p) snapshot.soft_points.push_back(static_cast<float>(1e-3 * c));
  snapshot.proxy_pose.position = 1e-3 * tool_mm;
  return snapshot;
}

engine::StructureLoad& load(engine::Snapshot& snapshot, engine::Structure structure) {
  return snapshot.loads[static_cast<std::size_t>(structure)];
}

TEST(ContactPressure, IsTheForceOverTheSurfaceUnderTheBlade) {
  const pipeline::TetMesh mesh = slab();
  // Over the tongue's half: 4 by 9 of its points lie under 7 x 17 mm, each standing for one cell of surface.
  const ContactPressure pressure(mesh, box(7.0, 17.0));
  engine::Snapshot snapshot = at_rest(mesh, {-11.0, 0.0, 0.0});
  load(snapshot, engine::Structure::tongue).force_n = {0.0, 1.2, 1.6};  // 2 N
  const auto found = pressure.in(snapshot);
  ASSERT_EQ(found.size(), 4u * 9u);
  const double expected_kpa = 1e-3 * 2.0 / (4 * 9 * 1e-6 * kCell_mm * kCell_mm);
  double sum_n = 0.0;
  for (const auto& at : found) {
    EXPECT_NEAR(at.kpa, expected_kpa, 0.02 * expected_kpa) << "a cell's diagonals share its corners out a little unevenly";
    const auto& p = mesh.points[static_cast<std::size_t>(pressure.boundary().node[static_cast<std::size_t>(at.point)])];
    EXPECT_LT(std::abs(p[0] + 11.0), 3.5 + 1e3 * ContactPressure::kTouch_m);
    EXPECT_LT(std::abs(p[1]), 8.5 + 1e3 * ContactPressure::kTouch_m);
    EXPECT_DOUBLE_EQ(p[2], 0.0) << "the underside of the slab is not touched";
    sum_n += 1e3 * at.kpa * pressure.area_m2(at.point);
  }
  EXPECT_NEAR(sum_n, 2.0, 1e-5) << "all of the force is borne";
}

TEST(ContactPressure, KeepsTongueAndEpiglottisApart) {
  const pipeline::TetMesh mesh = slab();
  const ContactPressure pressure(mesh, box(16.0, 6.0));
  engine::Snapshot snapshot = at_rest(mesh, {0.0, 0.0, 0.0});  // half on each
  load(snapshot, engine::Structure::epiglottis).force_n = {0.0, 0.0, 0.5};
  for (const auto& at : pressure.in(snapshot)) {
    const auto& p = mesh.points[static_cast<std::size_t>(pressure.boundary().node[static_cast<std::size_t>(at.point)])];
    EXPECT_GT(p[0], 0.0) << "nothing on the tongue, which bears no force";
  }
  EXPECT_FALSE(pressure.in(snapshot).empty());
  load(snapshot, engine::Structure::epiglottis).force_n.setZero();
  EXPECT_TRUE(pressure.in(snapshot).empty()) << "lying against it without force is no pressing";
}

TEST(ContactPressure, GivesAForceWithoutANeighbourToTheNearestPoint) {
  const pipeline::TetMesh mesh = slab();
  const ContactPressure pressure(mesh, box(7.0, 17.0));
  engine::Snapshot snapshot = at_rest(mesh, {-10.0, 0.0, 3.0});  // 3 mm above
  auto& its = load(snapshot, engine::Structure::tongue);
  its.force_n = {0.0, 0.0, 0.1};
  its.centre_m = 1e-3 * engine::Vec3(-5.9, 4.2, 0.3);
  const auto found = pressure.in(snapshot);
  ASSERT_EQ(found.size(), 1u);
  const auto& p = mesh.points[static_cast<std::size_t>(pressure.boundary().node[static_cast<std::size_t>(found[0].point)])];
  EXPECT_DOUBLE_EQ(p[0], -6.0);
  EXPECT_DOUBLE_EQ(p[1], 4.0);
}

TEST(HeatColour, GetsDarkerAndDenserWithPressure) {
  EXPECT_EQ(heat_colour(0.0)[3], 0);
  EXPECT_EQ(heat_colour(std::nan(""))[3], 0);
  const auto lightness = [](double share) {  // Rec. 709, of the colour alone
    const auto c = heat_colour(share);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  };
  for (double share = 0.1; share <= 0.95; share += 0.05) {
    EXPECT_GT(lightness(share), lightness(share + 0.05) + 1.0) << share;
    EXPECT_LE(heat_colour(share)[3], heat_colour(share + 0.05)[3]);
  }
  EXPECT_EQ(heat_colour(7.0), heat_colour(1.0));
}

}  // namespace
}  // namespace vallecula::gui

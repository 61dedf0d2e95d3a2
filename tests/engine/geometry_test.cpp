// Distance fields, spheres and lines of sight against geometry known in closed form.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "engine/aist/sphere_tree.h"
#include "engine/contact/signed_distance_grid.h"
#include "engine/contact/tool_field.h"
#include "engine/mesh/triangle_bvh.h"
#include "engine/sight/line_of_sight.h"
#include "engine/tool/miller_blade.h"
#include "engine/tool/shapes.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

double box_distance(const Vec3& p, const Vec3& half) {
  const Vec3 q = p.cwiseAbs() - half;
  return q.cwiseMax(0.0).norm() + std::min(0.0, q.maxCoeff());
}

TEST(TriangleBvh, SignedDistanceOfABoxIsExact) {
  const Vec3 half(0.03, 0.005, 0.0015);
  const TriangleBvh bvh(testing::box_surface(Vec3::Zero(), 2 * half));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p(0.04 * u(random), 0.01 * u(random), 0.006 * u(random));
    EXPECT_NEAR(bvh.signed_distance(p, 1.0), box_distance(p, half), 1e-12);
  }
}

TEST(SignedDistanceGrid, ThinBladeWithinATwentiethOfAMillimetreOffItsEdges) {
  const Vec3 half(0.03, 0.005, 0.0007);
  const SignedDistanceGrid grid(testing::box_surface(Vec3::Zero(), 2 * half), -half - Vec3::Constant(0.003),
                                half + Vec3::Constant(0.003), 0.0004, 0.002);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p(0.028 * u(random), 0.004 * u(random), 0.0025 * u(random));  // over the flat sides
    if (std::abs(p.z()) < 0.0004) continue;  // about the medial plane of a plate the field has a crease
    const double exact = box_distance(p, half);
    if (std::abs(exact) < 0.0018) {
      EXPECT_NEAR(grid.distance(p), exact, 5e-5);
    }
  }
  EXPECT_LT(grid.distance(Vec3::Zero()), 0);
  EXPECT_GT(grid.distance(Vec3(0.05, 0.05, 0.05)), 0);
}

TEST(SignedDistanceGrid, DeepInsideAndFarOutsideThereIsNoClass) {
  const TriangleMesh box = testing::box_surface(Vec3::Zero(), Vec3::Constant(0.04));
  const std::vector<std::uint8_t> classes(box.triangles.size(), 3);
  const SignedDistanceGrid grid(box, Vec3::Constant(-0.03), Vec3::Constant(0.03), 0.001, 0.005, classes);
  EXPECT_EQ(grid.class_at(Vec3(0.019, 0, 0)), 3);
  EXPECT_EQ(grid.class_at(Vec3::Zero()), SignedDistanceGrid::kNoClass);
  EXPECT_EQ(grid.class_at(Vec3(0.1, 0, 0)), SignedDistanceGrid::kNoClass);
}

TEST(MillerBlade, EveryBladeIsClosedAndAsLongAsItSays) {
  for (const auto& [name, length] : {std::pair{"miller-00", 0.065}, {"miller-0", 0.075}, {"miller-1", 0.102},
                                      {"miller-2", 0.155}, {"miller-3", 0.195}}) {
    const TriangleMesh mesh = blade_surface(miller_blade(name));
    EXPECT_EQ(count_open_edges(mesh), 0) << name;
    double low = 1, high = -1;
    for (const Vec3& p : mesh.points) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
    EXPECT_NEAR(low, 0.0, 1e-9);
    EXPECT_NEAR(high, length, 1e-9);
    EXPECT_LT(TriangleBvh(mesh).signed_distance(Vec3(0.03, 0.001, -0.002), 1.0), 0) << "inside the spatula, " << name;
  }
  EXPECT_THROW(miller_blade("macintosh"), std::invalid_argument);
}

/// Distance to a paddle: to the flat plate with round ends in its middle plane, less half the thickness.
double paddle_distance(const Vec3& p, const Vec3& size) {
  const double r = size.z() / 2, end = size.y() / 2 - r, straight = (size.x() - size.y()) / 2;
  const double beyond = std::max(0.0, std::abs(p.x()) - straight);
  const double aside = std::max(0.0, std::hypot(beyond, p.y()) - end);
  return std::hypot(aside, p.z()) - r;
}

TEST(Paddle, IsAPlateWithRoundEndsAndEdges) {
  const Vec3 size(0.06, 0.012, 0.002);
  const TriangleMesh mesh = paddle_surface(size);
  EXPECT_EQ(count_open_edges(mesh), 0);
  Vec3 high = Vec3::Zero(), low = Vec3::Zero();
  double volume = 0.0;
  for (const Vec3& p : mesh.points) {
    high = high.cwiseMax(p);
    low = low.cwiseMin(p);
    EXPECT_NEAR(paddle_distance(p, size), 0.0, 1e-12);
  }
  for (const auto& t : mesh.triangles) volume += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  EXPECT_LT((high - size / 2).norm() + (low + size / 2).norm(), 1e-12);
  // Steiner's formula for the flat plate of area A and perimeter P, r about it: 2 A r + pi r^2 P / 2 + 4 pi r^3 / 3.
  const double pi = 3.14159265358979323846, r = size.z() / 2, end = size.y() / 2 - r, straight = size.x() - size.y();
  const double area = pi * end * end + 2 * end * straight, perimeter = 2 * pi * end + 2 * straight;
  const double exact = 2 * area * r + pi * r * r * perimeter / 2 + 4 * pi * r * r * r / 3;
  EXPECT_NEAR(volume / exact, 1.0, 0.003) << "of a surface inscribed in 12 and 24 parts of half a turn";
  const TriangleBvh bvh(mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p(0.035 * u(random), 0.01 * u(random), 0.004 * u(random));
    // The sag of a 24th of half a turn in the ends (6 mm) and of a 12th in the edges (1 mm): 13 + 9 um.
    EXPECT_NEAR(bvh.signed_distance(p, 1.0), paddle_distance(p, size), 2.2e-5);
  }
  EXPECT_EQ(count_open_edges(paddle_surface(Vec3(0.012, 0.012, 0.002))), 0) << "as long as wide: a disc";
  EXPECT_THROW(paddle_surface(Vec3(0.01, 0.012, 0.002)), std::invalid_argument);
  EXPECT_THROW(paddle_surface(Vec3(0.06, 0.002, 0.002)), std::invalid_argument);
  EXPECT_THROW(paddle_surface(Vec3(0.06, 0.012, 0.0)), std::invalid_argument);
}

TEST(ToolField, AHandleIsLeftOutOfTheFineFieldWhereTissueCannotMeetIt) {
  const Vec3 size(0.15, 0.03, 0.13), half = size / 2;  // as large as a laryngoscope with its handle
  const TriangleMesh box = testing::box_surface(Vec3::Zero(), size);
  const Vec3 everywhere = Vec3::Constant(std::numeric_limits<double>::infinity());
  EXPECT_THROW(ToolField(box, -everywhere, everywhere), std::invalid_argument) << "39 million samples";
  const Vec3 low(-0.1, -0.025, -0.1), high(0.02, 0.025, -0.04);
  const ToolField field(box, low, high);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(0, 1);
  int near = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec3 p(-0.078 + 0.097 * u(random), -0.017 + 0.034 * u(random), -0.067 + 0.026 * u(random));
    const double exact = box_distance(p, half);
    if (std::abs(exact) > 0.001) {
      if (std::abs(exact) > 0.0015) {
        EXPECT_EQ(field.fine.distance(p) < 0, exact < 0);
      }
      continue;
    }
    ++near;
    EXPECT_NEAR(field.fine.distance(p), exact, 1e-4);
  }
  EXPECT_GT(near, 1000);
  EXPECT_EQ(field.fine.distance(Vec3(0, 0, half.z())), field.fine.band()) << "left out";
  EXPECT_NEAR(field.coarse.distance(Vec3(0, 0, half.z() + 0.01)), 0.01, 1e-5) << "but known to the coarse field";
}

TEST(SphereTree, SpheresStayInsideAndTheSurfaceIsCovered) {
  const auto soft = testing::box_body(Vec3(0.03, 0.02, 0.015), {8, 6, 4}, {6000.0, 0.45, 1040.0});
  const SoftSurface surface = extract_surface(soft.tets);
  for (Coverage coverage : {Coverage::paper, Coverage::full}) {
    FillSettings settings;
    settings.coverage = coverage;
    const SphereTree tree = fill_spheres(soft, surface, settings);
    const double cube = std::cbrt(3 * 10 * tree.mean_tet_volume / (4 * M_PI));
    EXPECT_NEAR(tree.coarse_radius, cube, 1e-12);
    EXPECT_GT(tree.spheres_per_level[0], 0);
    for (const InnerSphere& s : tree.spheres) {
      const Vec3 half(0.015, 0.01, 0.0075);
      EXPECT_LE(box_distance(s.centre - half, half) + s.radius, 1e-4) << "a sphere sticks out";
      Vec3 tied = Vec3::Zero();
      for (int k = 0; k < 4; ++k) tied += s.weight[k] * soft.nodes[soft.tets[s.tet][k]];
      EXPECT_LT((tied - s.centre).norm(), 1e-9);
    }
    const CoverageReport report = measure_coverage(tree, soft, surface, 4000);
    if (coverage == Coverage::full) {
      EXPECT_LE(report.uncovered_depth_m, 0.00045);  // the box's sharp corners are the worst a sphere can meet
      EXPECT_GT(report.covered_fraction, 0.97);
    } else {
      EXPECT_GT(report.uncovered_depth_m, 0.0005);   // the paper's own limit
    }
  }
}

TEST(LineOfSight, AnEdgeHidesTheShareOfTheOpeningBehindIt) {
  SightDescription sight;
  sight.eye = Vec3(0, 0, 0.3);
  sight.glottis_outline = {Vec3(-0.002, -0.003, 0), Vec3(0.002, -0.003, 0), Vec3(0.002, 0.003, 0), Vec3(-0.002, 0.003, 0)};
  const LineOfSight open(sight, {}, 400);
  EXPECT_EQ(open.unobstructed(), 1.0);
  auto scratch = open.make_scratch(8);
  // A wall half way up whose edge stands, seen from the eye, over y = cut in the glottis' plane.
  for (double cut : {-0.0015, 0.0, 0.0012}) {
    const TriangleMesh wall = testing::box_surface(Vec3(0, cut / 2 + 0.05, 0.15), Vec3(0.1, 0.1, 1e-6));
    open.begin(scratch, {});
    open.add(scratch, 8, wall.triangles, [&](int i) -> Vec3 { return wall.points[i]; });
    EXPECT_NEAR(open.visible(scratch), (cut + 0.003) / 0.006, 0.06) << cut;
  }
  const TriangleMesh behind = testing::box_surface(Vec3(0, 0, -0.05), Vec3(0.1, 0.1, 0.01));
  open.begin(scratch, {});
  open.add(scratch, 8, behind.triangles, [&](int i) -> Vec3 { return behind.points[i]; });
  EXPECT_EQ(open.visible(scratch), 1.0);
}

// A square glottis of 6 mm half behind a fixed edge near it: shifted by a millimetre towards the edge a sixth more is hidden,
// and as much the other way when the edge itself is shifted.
TEST(LineOfSight, GlottisAndAnatomyFollowTheBodiesByTheirShares) {
  SightDescription sight;
  sight.eye = Vec3(0, 0, 0.3);
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) sight.glottis_outline.emplace_back(0.003 * x, 0.003 * y, 0);
  TriangleMesh edge;
  edge.points = {Vec3(0, -0.05, 0.001), Vec3(0.05, -0.05, 0.001), Vec3(0.05, 0.05, 0.001), Vec3(0, 0.05, 0.001)};
  edge.triangles = {{0, 1, 2}, {0, 2, 3}};
  sight.occluders = {edge};
  SprungBody body;
  body.motion = SprungBody::Motion::translation;
  sight.followers = {{0, 0.5, {}}, {1, 0.0, std::vector<float>(4, 0.25f)}};
  const LineOfSight line(sight, {body, body}, 2000);
  auto scratch = line.make_scratch(4);
  const auto seen = [&](double glottis, double anatomy) {
    line.begin(scratch, {Vec3(glottis, 0, 0), Vec3(anatomy, 0, 0)});
    return line.visible(scratch);
  };
  EXPECT_NEAR(seen(0, 0), 0.5, 0.02);
  EXPECT_NEAR(seen(0.002, 0), 0.5 - 1.0 / 6, 0.02);
  EXPECT_NEAR(seen(0, 0.004), 0.5 + 1.0 / 6, 0.02);
  EXPECT_NEAR(seen(0.002, 0.004), 0.5, 0.02);
  sight.followers[1].point_share.pop_back();
  EXPECT_THROW(LineOfSight(sight, {body, body}), std::invalid_argument);
  sight.followers = {{7, 0.5, {}}};
  EXPECT_THROW(LineOfSight(sight, {body}), std::invalid_argument);
}

}  // namespace
}  // namespace vallecula::engine

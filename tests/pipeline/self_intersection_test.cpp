// Surfaces that cross themselves are found, and those that do not are left in peace: against shapes whose answer is
// known, against another arithmetic on random triangles, and against the mesh generator's own judgement.
#include "pipeline/mesh/self_intersection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/mesh/inflate.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/mesh/mend.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

template <class Field>
Surface surface_of(double half, double spacing, const Field& field) {
  Grid g;
  g.spacing = {spacing, spacing, spacing};
  for (int a = 0; a < 3; ++a) {
    g.size[a] = 2 * static_cast<int>(std::ceil(half / spacing)) + 1;
    g.origin[a] = -0.5 * (g.size[a] - 1) * spacing;
  }
  Volume<float> v(g);
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = static_cast<float>(field(g.position(i)));
  return isosurface(v);
}

Surface sphere(double radius, double spacing = 0.8) {
  return surface_of(radius + 2.0, spacing, [radius](const Point& p) { return radius - norm(p); });
}

Surface together(const Surface& a, Surface b, const Vector3& moved) {
  Surface out = a;
  const int first = static_cast<int>(a.points.size());
  for (auto& p : b.points) out.points.push_back(p + moved);
  for (const auto& t : b.triangles) out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return out;
}

TEST(SelfIntersection, CleanShapesHaveNone) {
  EXPECT_TRUE(self_intersections({}).empty());
  EXPECT_TRUE(self_intersections(sphere(7.0)).empty());
  const auto torus =
      surface_of(14.0, 0.7, [](const Point& p) { return 3.0 - std::hypot(std::hypot(p[0], p[1]) - 9.0, p[2]); });
  EXPECT_TRUE(self_intersections(torus).empty());
  // One inside the other, and two beside each other a nanometre apart: nothing is common.
  EXPECT_TRUE(self_intersections(together(sphere(7.0), sphere(4.0), {})).empty());
  const Surface square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}};
  EXPECT_TRUE(self_intersections(square).empty());
  EXPECT_TRUE(self_intersections(together(square, square, {0, 0, 1e-6})).empty());
}

TEST(SelfIntersection, CrossingSpheresAreFoundOnTheirCircleOnly) {
  const double r = 7.0;
  const double apart = 6.0;
  const auto both = together(sphere(r), sphere(r), {apart, 0.13, 0.07});
  const auto pairs = self_intersections(both);
  ASSERT_GT(pairs.size(), 50u);
  const double circle = std::sqrt(r * r - 0.25 * apart * apart);
  for (const auto& pair : pairs) {
    for (const int t : pair) {
      Vector3 c{};
      for (const int v : both.triangles[t]) c = c + (1.0 / 3.0) * both.points[v];
      EXPECT_NEAR(c[0], 0.5 * apart, 1.0);
      EXPECT_NEAR(std::hypot(c[1], c[2]), circle, 1.0);
    }
  }
  EXPECT_THROW(tetrahedralized(both, {}), TetrahedralizeError) << "the mesh generator agrees";
  EXPECT_NO_THROW(tetrahedralized(sphere(r), {})) << "and on the clean one too";
}

TEST(SelfIntersection, TouchingAndFoldsCount) {
  // A sheet folded flat onto itself about its edge, lying open, and standing up.
  const auto folded = [](const Point& fourth) {
    return self_intersections({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, fourth}, {{0, 1, 2}, {1, 0, 3}}, {}}).size();
  };
  EXPECT_EQ(folded({0.3, 1.0, 0.0}), 1u);
  EXPECT_EQ(folded({0.3, -1.0, 0.0}), 0u);
  EXPECT_EQ(folded({0.3, 1.0, 1e-6}), 0u);
  // Two triangles of one corner: the second lies in the first's angle, beside it, or pierces it.
  const auto at_corner = [](const Point& d, const Point& e) {
    return self_intersections({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, d, e}, {{0, 1, 2}, {0, 3, 4}}, {}}).size();
  };
  EXPECT_EQ(at_corner({-1, 0, 0}, {0, -1, 0}), 0u);
  EXPECT_EQ(at_corner({0.5, 0.5, 0}, {3, 3, 1}), 1u);
  EXPECT_EQ(at_corner({0.5, 0.5, 1}, {0.5, 0.6, -1}), 1u);
  EXPECT_EQ(at_corner({0.5, 0.5, 1}, {0.5, 0.6, 0.5}), 0u);
  // A tip that stands exactly on another triangle, a hair above it, and a hair through it.
  const auto tip_at = [](double z) {
    return self_intersections(
               {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, z}, {1, 2, 3}, {2, 1, 3}}, {{0, 1, 2}, {3, 4, 5}}, {}})
        .size();
  };
  EXPECT_EQ(tip_at(0.0), 1u);
  EXPECT_EQ(tip_at(1e-9), 0u);
  EXPECT_EQ(tip_at(-1e-9), 1u);
  // In one plane: overlapping, one within the other, apart; the same triangle twice; one without area.
  const Surface t{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}, {}};
  EXPECT_EQ(self_intersections(together(t, t, {1.0, 1.0, 0.0})).size(), 1u);
  Surface small = t;
  for (auto& p : small.points) p = 0.1 * p;
  EXPECT_EQ(self_intersections(together(t, small, {0.5, 0.5, 0.0})).size(), 1u);
  EXPECT_EQ(self_intersections(together(t, t, {5.0, 5.0, 0.0})).size(), 0u);
  EXPECT_EQ(self_intersections({t.points, {{0, 1, 2}, {0, 1, 2}}, {}}).size(), 1u);
  EXPECT_EQ(self_intersections({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}, {}}).size(), 1u);
}

/// Does the segment pierce the triangle? By solving for the point, in long double.
bool pierces(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  using L = long double;
  const auto sub = [](const Point& u, const Point& v) {
    return std::array<L, 3>{L(u[0]) - v[0], L(u[1]) - v[1], L(u[2]) - v[2]};
  };
  const auto crossed = [](const std::array<L, 3>& u, const std::array<L, 3>& v) {
    return std::array<L, 3>{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const auto times = [](const std::array<L, 3>& u, const std::array<L, 3>& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto d = sub(q, p), e1 = sub(b, a), e2 = sub(c, a), s = sub(p, a);
  const auto h = crossed(d, e2);
  const L det = times(e1, h);
  if (det == 0) return false;
  const L u = times(s, h) / det;
  const auto k = crossed(s, e1);
  const L v = times(d, k) / det;
  const L w = times(e2, k) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && w >= 0 && w <= 1;
}

TEST(SelfIntersection, AgreesWithAnotherArithmeticOnRandomTriangles) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> size(-2.0, 2.0);
  Surface soup;
  for (int t = 0; t < 600; ++t) {
    const Point at{place(random), place(random), place(random)};
    for (int k = 0; k < 3; ++k) soup.points.push_back(at + Vector3{size(random), size(random), size(random)});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  std::vector<std::array<int, 2>> expected;
  for (int i = 0; i < 600; ++i) {
    for (int j = i + 1; j < 600; ++j) {
      bool hit = false;
      for (int k = 0; k < 3 && !hit; ++k) {
        const auto* a = &soup.points[3 * i];
        const auto* b = &soup.points[3 * j];
        hit = pierces(a[k], a[(k + 1) % 3], b[0], b[1], b[2]) || pierces(b[k], b[(k + 1) % 3], a[0], a[1], a[2]);
      }
      if (hit) expected.push_back({i, j});
    }
  }
  ASSERT_GT(expected.size(), 100u);
  EXPECT_EQ(self_intersections(soup), expected);
}

TEST(Mend, TakesFoldsOutAndLeavesTheRest) {
  const auto clean = sphere(8.0);
  auto folded = clean;
  const auto& t = folded.triangles[40];
  folded.points[t[0]] = folded.points[t[1]] + 0.4 * (folded.points[t[1]] - folded.points[t[0]]);  // over its neighbour
  ASSERT_FALSE(self_intersections(folded).empty());
  const auto out = mended(folded);
  EXPECT_TRUE(self_intersections(out).empty());
  EXPECT_EQ(facts_of(out).fault, "");
  EXPECT_EQ(out.triangles, folded.triangles);
  EXPECT_NEAR(facts_of(out).volume_mm3 / facts_of(clean).volume_mm3, 1.0, 0.002);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < out.points.size(); ++i) moved += out.points[i] != folded.points[i] ? 1 : 0;
  EXPECT_LT(moved, 40u);
  EXPECT_EQ(mended(clean).points, clean.points);
}

TEST(Mend, PartsTwoSidesOfAThinSheetThatHavePassedEachOther) {
  auto clean = sphere(8.0);
  for (auto& p : clean.points) p[2] *= 0.05;
  ASSERT_TRUE(self_intersections(clean).empty());
  auto crossed = clean;
  for (auto& p : crossed.points) {
    if (p[2] > 0.0 && std::hypot(p[0], p[1]) < 2.5) p[2] -= 1.1;  // the sheet is 0.8 mm thick
  }
  ASSERT_GT(self_intersections(crossed).size(), 10u);
  const auto out = mended(crossed);
  EXPECT_TRUE(self_intersections(out).empty());
  EXPECT_EQ(facts_of(out).fault, "");
  EXPECT_NEAR(facts_of(out).volume_mm3 / facts_of(clean).volume_mm3, 1.0, 0.05);
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    if (std::hypot(clean.points[i][0], clean.points[i][1]) > 7.0) {
      EXPECT_EQ(out.points[i], crossed.points[i]);
    }
  }
}

TEST(TriangleTree, NearestPointAndSideAreThoseOfTheSphere) {
  const double r = 8.0;
  const auto s = sphere(r, 0.5);
  const TriangleTree tree(s);
  const SurfaceDistance side(s);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-12.0, 12.0);
  for (int i = 0; i < 2000; ++i) {
    const Point p{place(random), place(random), place(random)};
    EXPECT_NEAR(side.at(p), norm(p) - r, 0.03);
    double least = 1e30;
    const auto found = tree.nearest(p);
    for (const auto& q : s.points) least = std::min(least, distance(p, q));
    EXPECT_LE(std::sqrt(found.distance2), least + 1e-12);
    EXPECT_NEAR(distance(p, found.point), std::sqrt(found.distance2), 1e-9);
  }
}

TEST(Inflate, GivesBackWhatTheTrianglesCutOff) {
  const double r = 8.0;
  const double volume = 4.0 / 3.0 * M_PI * r * r * r;
  const auto coarse = sphere(r, 3.0);
  ASSERT_LT(facts_of(coarse).volume_mm3, 0.97 * volume);
  const auto out = inflated(coarse, inflation_to(coarse, volume));
  EXPECT_NEAR(facts_of(out).volume_mm3 / volume, 1.0, 1e-4);
}

}  // namespace
}  // namespace vallecula::pipeline

// The tool's distance field, as contacts read it, against exact distances to triangles: by another formula than the engine's,
// over all triangles, with the side from the winding number.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "engine/contact/tool_field.h"
#include "engine/tool/miller_blade.h"
#include "engine/tool/shapes.h"

namespace vallecula::engine {
namespace {

/// Distance of p to the triangle: to its plane where the foot lies inside, else to the nearest of its edges.
double triangle_distance(const Vec3& p, const Vec3 corner[3]) {
  const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  bool inside = true;
  double nearest = 1e30;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = corner[i], edge = corner[(i + 1) % 3] - a;
    inside = inside && n.cross(edge).dot(p - a) >= 0;
    const double along = std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * edge).norm());
  }
  return inside ? std::abs(n.dot(p - corner[0])) / n.norm() : nearest;
}

/// Signed by the winding number: the sum of the solid angles of all triangles (Van Oosterom and Strackee 1983).
double exact_distance(const TriangleMesh& mesh, const Vec3& p) {
  double nearest = 1e30, angle = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 corner[3] = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    nearest = std::min(nearest, triangle_distance(p, corner));
    const Vec3 a = corner[0] - p, b = corner[1] - p, c = corner[2] - p;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return angle > 2 * M_PI ? -nearest : nearest;
}

TriangleMesh torus(double ring, double tube) {
  constexpr int kAround = 48, kAcross = 20;
  TriangleMesh mesh;
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const double u = 2 * M_PI * i / kAround, v = 2 * M_PI * j / kAcross, r = ring + tube * std::cos(v);
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
      const auto at = [](int a, int b) { return (a % kAround) * kAcross + b % kAcross; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// An L of two bars: a sharp edge that turns inwards.
TriangleMesh angle_iron() {
  const double outline[6][2] = {{0, 0}, {0.012, 0}, {0.012, 0.003}, {0.003, 0.003}, {0.003, 0.012}, {0, 0.012}};
  const int face[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  TriangleMesh mesh;
  for (double z : {0.0, 0.02})
    for (const auto& p : outline) mesh.points.emplace_back(p[0], p[1], z);
  for (const auto& f : face) {
    mesh.triangles.push_back({f[0], f[2], f[1]});
    mesh.triangles.push_back({f[0] + 6, f[1] + 6, f[2] + 6});
  }
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

struct Shape {
  std::string name;
  TriangleMesh mesh;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all = {{"sphere of 5 mm", sphere_surface(0.005, 4)},
                            {"box 60 x 10 x 3 mm", box_surface(Vec3::Zero(), Vec3(0.06, 0.01, 0.003))},
                            {"plate of 0.8 mm", box_surface(Vec3::Zero(), Vec3(0.02, 0.01, 0.0008))},
                            {"torus", torus(0.01, 0.003)},
                            {"angle iron", angle_iron()}};
  for (const char* blade : {"miller-00", "miller-0", "miller-1"}) all.push_back({blade, blade_surface(miller_blade(blade))});
  return all;
}

// Within 0.3 mm of the surface on both sides, edges and corners included, whatever way the shape lies in the grid.
TEST(DistanceTruth, WithinATwentiethOfAMillimetreNearEverySurface) {
  constexpr double kNear = 0.0003, kMost = 0.00005;
  constexpr int kPoints = 800;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(0, 1);
  std::normal_distribution<double> normal;
  for (const Shape& shape : shapes())
    for (int turn = 0; turn < 2; ++turn) {
      TriangleMesh mesh = shape.mesh;
      const Quat way = turn == 0 ? Quat::Identity() : Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
      const Vec3 off = turn == 0 ? Vec3::Zero().eval() : Vec3(0.0123 * u(random), -0.0071 * u(random), 0.0049 * u(random));
      for (Vec3& p : mesh.points) p = way * p + off;
      const ToolField field(mesh, Vec3::Constant(-1.0), Vec3::Constant(1.0));
      std::vector<double> areas;
      double area = 0.0;
      for (const auto& t : mesh.triangles)
        areas.push_back(area += (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm());
      double most = 0.0, sum = 0.0;
      int inside = 0, outside = 0, wrong_side = 0;
      Vec3 worst = Vec3::Zero();
      while (inside + outside < kPoints) {
        // Half of the points about the edges, where the field bends; half about the faces.
        const std::size_t t = std::lower_bound(areas.begin(), areas.end(), area * u(random)) - areas.begin();
        const auto& k = mesh.triangles[t];
        double a = u(random), b = u(random);
        if (a + b > 1) a = 1 - a, b = 1 - b;
        if (u(random) < 0.5) b = 0;
        Vec3 p = mesh.points[k[0]] * (1 - a - b) + mesh.points[k[1]] * a + mesh.points[k[2]] * b;
        p += kNear * u(random) * Vec3(normal(random), normal(random), normal(random)).normalized();
        const double exact = exact_distance(mesh, p);
        ++(exact < 0 ? inside : outside);
        const double read = field.fine.distance(p);
        sum += std::abs(read - exact);
        wrong_side += read * exact < 0 && std::abs(exact) > kMost ? 1 : 0;
        if (std::abs(read - exact) > most) {
          most = std::abs(read - exact);
          worst = p;
        }
      }
      std::printf("%-20s %s  largest error %.4f mm, mean %.4f mm, %d points inside\n", shape.name.c_str(),
                  turn == 0 ? "as is " : "turned", 1e3 * most, 1e3 * sum / kPoints, inside);
      EXPECT_LT(most, kMost) << shape.name << ", turn " << turn << ", at " << worst.transpose();
      EXPECT_EQ(wrong_side, 0) << shape.name << ", turn " << turn;
      EXPECT_GT(std::min(inside, outside), kPoints / 5) << shape.name << ": the points do not lie on both sides";
    }
}

}  // namespace
}  // namespace vallecula::engine

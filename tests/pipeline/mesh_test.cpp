// Surfaces and tetrahedra on shapes whose volume and topology are known, and the mesh generator's death kept away from
// us.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "pipeline/mesh/isosurface.h"
#include "pipeline/mesh/remesh.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_optimize.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/tetrahedralize.h"

namespace vallecula::pipeline {
namespace {

template <class Field>
Volume<float> sampled(double half_extent, std::array<double, 3> spacing, const Field& field) {
  Grid g;
  g.spacing = spacing;
  for (int a = 0; a < 3; ++a) {
    g.size[a] = 2 * static_cast<int>(std::ceil(half_extent / spacing[a])) + 1;
    g.origin[a] = -0.5 * (g.size[a] - 1) * spacing[a];
  }
  Volume<float> v(g);
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = static_cast<float>(field(g.position(i)));
  return v;
}

double sphere(const Point& p, double r) { return r - std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

double torus(const Point& p, double big, double small) {
  const double q = std::hypot(p[0], p[1]) - big;
  return small - std::hypot(q, p[2]);
}

void expect_solid(const Surface& s, const char* what) {
  const auto f = facts_of(s);
  EXPECT_TRUE(f.finite && f.closed && f.manifold) << what << ": " << f.fault;
  EXPECT_EQ(f.parts, 1) << what;
  EXPECT_GT(f.volume_mm3, 0.0) << what << " looks outwards";
}

int euler_characteristic(const Surface& s) {
  return static_cast<int>(s.points.size()) - static_cast<int>(s.triangles.size()) / 2;  // closed: E = 3 F / 2
}

TEST(Isosurface, IsClosedOutwardsAndOfTheRightVolume) {
  const double r = 10.0;
  const auto s = isosurface(sampled(12.0, {0.5, 0.5, 0.8}, [&](const Point& p) { return sphere(p, r); }));
  expect_solid(s, "sphere");
  EXPECT_NEAR(facts_of(s).volume_mm3 / (4.0 / 3.0 * M_PI * r * r * r), 1.0, 0.005);
}

TEST(Isosurface, ClosesAtTheBorderOfTheGrid) {
  const auto s = isosurface(sampled(8.0, {0.5, 0.5, 0.8}, [](const Point& p) { return 5.0 - std::hypot(p[0], p[1]); }));
  expect_solid(s, "cylinder through the whole grid");
}

TEST(Remesh, KeepsVolumeTopologyAndSize) {
  for (const double spacing : {0.4, 0.8}) {
    const auto rough =
        isosurface(sampled(14.0, {spacing, spacing, 0.9}, [](const Point& p) { return torus(p, 9.0, 3.5); }));
    expect_solid(rough, "rough torus");
    for (const double edge : {0.7, 1.2, 2.0}) {
      RemeshOptions options;
      options.edge_mm = [edge](const Point&) { return edge; };
      const auto s = remeshed(rough, options);
      expect_solid(s, "remeshed torus");
      EXPECT_EQ(euler_characteristic(s), 0) << "still one hole";
      // Chord error of an edge l on the tube's radius r takes about (l / r)^2 / 8 of the section's radius: twice that
      // of the volume.
      const double chord = edge * edge / (8.0 * 3.5 * 3.5);
      EXPECT_NEAR(facts_of(s).volume_mm3 / (2.0 * M_PI * M_PI * 9.0 * 3.5 * 3.5), 1.0, 0.01 + 3.0 * chord) << edge;
      EXPECT_GT(facts_of(s).smallest_angle_deg, 12.0) << edge;
      double sum = 0.0;
      for (const auto& t : s.triangles) {
        for (int k = 0; k < 3; ++k) {
          double d2 = 0.0;
          for (int a = 0; a < 3; ++a) d2 += std::pow(s.points[t[k]][a] - s.points[t[(k + 1) % 3]][a], 2);
          sum += std::sqrt(d2);
        }
      }
      EXPECT_NEAR(sum / (3.0 * s.triangles.size()) / edge, 1.0, 0.15) << edge;
    }
  }
}

Surface rough_sphere() {
  return isosurface(sampled(10.0, {0.7, 0.7, 0.7}, [](const Point& p) { return sphere(p, 8.0); }));
}

Surface fine_sphere() {
  RemeshOptions options;
  options.edge_mm = [](const Point&) { return 2.0; };
  return remeshed(rough_sphere(), options);
}

TEST(Tetrahedralize, FillsASurfaceAndKeepsItsPoints) {
  const auto s = fine_sphere();
  TetrahedralizeOptions options;
  options.edge_mm = [](const Point&) { return 2.0; };
  auto mesh = tetrahedralized(s, options);
  const auto q = quality_of(mesh);
  EXPECT_NEAR(q.volume_mm3, facts_of(s).volume_mm3, 1e-6 * q.volume_mm3);
  EXPECT_GT(q.smallest_volume_mm3, 0.0);
  ASSERT_GE(mesh.points.size(), s.points.size());
  for (std::size_t i = 0; i < s.points.size(); ++i) EXPECT_EQ(mesh.points[i], s.points[i]);
  EXPECT_EQ(mesh.tissue.size(), mesh.tets.size());
  EXPECT_EQ(mesh.anchor.size(), mesh.points.size());

  optimize_points(mesh, s.points.size(), rough_sphere(), 15);
  const auto better = quality_of(mesh);
  EXPECT_GT(better.smallest_dihedral_deg, 8.0);
  EXPECT_GT(better.smallest_dihedral_deg, q.smallest_dihedral_deg);
  EXPECT_NEAR(better.volume_mm3 / q.volume_mm3, 1.0, 0.01) << "surface points slide along the surface";
}

void expect_refused(const Surface& s, const char* words) {
  try {
    tetrahedralized(s, {});
    FAIL() << "accepted: " << words;
  } catch (const TetrahedralizeError& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

TEST(Tetrahedralize, BadInputIsAnErrorAndNotADeath) {
  const auto good = fine_sphere();
  expect_refused(Surface{}, "no triangles");
  auto open = good;
  open.triangles.pop_back();
  expect_refused(open, "open");
  auto nan = good;
  nan.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(nan, "not finite");
  auto inside_out = good;
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  expect_refused(inside_out, "inwards");
  auto crossing = good;  // a point pulled through to the far side: closed and manifold, but it crosses itself
  for (double& v : crossing.points[0]) v *= -1.6;
  expect_refused(crossing, "crosses itself");
}

TEST(Tetrahedralize, AHelperThatDiesOrHangsIsReported) {
  namespace fs = std::filesystem;
  const auto script = fs::temp_directory_path() / ("vallecula-helper-test-" + std::to_string(::getpid()));
  const auto refused_with = [&](const std::string& body, const char* words, TetrahedralizeOptions options) {
    std::ofstream(script) << "#!/bin/sh\n" << body << "\n";
    fs::permissions(script, fs::perms::owner_all);
    options.helper = script;
    try {
      tetrahedralized(fine_sphere(), options);
      ADD_FAILURE() << "accepted: " << body;
    } catch (const TetrahedralizeError& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  };
  TetrahedralizeOptions options;
  refused_with("kill -SEGV $$", "signal 11", options);
  refused_with("kill -ABRT $$", "signal 6", options);
  refused_with("exit 9", "code 9", options);
  refused_with("exit 0", "result cannot be read", options);
  refused_with("head -c 100 \"$1\" > \"$2\"", "result cannot be read", options);
  options.time_limit_s = 1;
  refused_with("sleep 20", "not done within 1 s", options);
  fs::remove(script);
  options.helper = "/nonexistent/vallecula-tetgen";
  EXPECT_THROW(tetrahedralized(fine_sphere(), options), TetrahedralizeError);
  options.helper.clear();
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  options.memory_limit_bytes = 1 << 20;  // too little to be loaded; sanitized helpers have no such limit
  EXPECT_THROW(tetrahedralized(fine_sphere(), options), TetrahedralizeError);
#endif
}

}  // namespace
}  // namespace vallecula::pipeline

// A structure given as a label map wins over the grey values, down to its surface, its mesh and its landmarks. Truth is
// the manikin's own labels and shapes known by construction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "pipeline/mesh/anatomy_fields.h"
#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/mesh/soft_surface.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "tests/pipeline/edited_manikin.h"

namespace vallecula::pipeline {
namespace {

using test::EditedManikin;

TEST_F(EditedManikin, AGivenTongueWinsOverTheGreyValuesDownToItsMesh) {
  // An ellipsoid about the true tongue's middle, a quarter of it in air.
  const auto c = centroid(truth(kTongue)) + Vector3{0.0, 0.0, 3.0};
  const Vector3 half{9.0, 12.0, 8.0};
  Mask ellipsoid(grid());
  std::size_t in_air = 0;
  for (std::size_t i = 0; i < grid().count(); ++i) {
    const auto p = grid().position(i);
    const double r = std::hypot((p[0] - c[0]) / half[0], (p[1] - c[1]) / half[1], (p[2] - c[2]) / half[2]);
    ellipsoid.voxels[i] = r <= 1.0 ? 1 : 0;
    in_air += r <= 1.0 && scan_->ct.voxels[i] < -700 ? 1 : 0;
  }
  ASSERT_GT(in_air, count(ellipsoid) / 20) << "else nothing is shown";
  const auto s = with(replacing(kTongue, ellipsoid));
  EXPECT_EQ(of(on_series_grid(s, grid()), kTongue).voxels, ellipsoid.voxels);
  EXPECT_EQ(count(all_of(s.airway.lumen, cropped(ellipsoid, s.box))), 0u);
  const auto fields = fields_of(s);
  // The mesh is tongue and epiglottis together: their volumes, by construction and by count.
  double leaf = static_cast<double>(count(s.epiglottis.mask));
  const double expected = 4.0 / 3.0 * 3.14159265 * half[0] * half[1] * half[2] + leaf * grid().voxel_mm3();
  EXPECT_NEAR(facts_of(soft_surface(s, soft_field(s, fields), 1.0).fine).volume_mm3 / expected, 1.0, 0.03);
  EXPECT_EQ(s.findings.at("tongue").origin, Origin::given);
  EXPECT_EQ(s.findings.at("airway").origin, Origin::measured);
}

/// With the six neighbours of each of its voxels.
Mask with_neighbours(const Mask& mask) {
  Mask out = mask;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    if (mask.voxels[i] == 0) continue;
    const auto c = mask.grid.cell(i);
    for (const auto& d : {std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{0, 0, 1}}) {
      for (const int side : {-1, 1}) {
        if (mask.grid.contains(c[0] + side * d[0], c[1] + side * d[1], c[2] + side * d[2]))
          out.at(c[0] + side * d[0], c[1] + side * d[1], c[2] + side * d[2]) = 1;
      }
    }
  }
  return out;
}

/// `inner`, and of `outer` what lies in every other of random cubes of so many voxels; 0: all of it.
Mask in_steps(const Mask& inner, const Mask& outer, int cube) {
  std::mt19937 random(static_cast<unsigned>(cube));
  std::map<std::array<int, 3>, bool> wide;
  Mask drawn = inner;
  for (std::size_t i = 0; i < drawn.voxels.size(); ++i) {
    if (outer.voxels[i] == 0) continue;
    if (cube > 0) {
      const auto c = drawn.grid.cell(i);
      const auto [it, fresh] = wide.try_emplace({c[0] / cube, c[1] / cube, c[2] / cube}, false);
      if (fresh) it->second = random() % 2 == 0;
      if (!it->second) continue;
    }
    drawn.voxels[i] = 1;
  }
  return drawn;
}

Mask soft_of(const Segmentation& s) {
  return where(cropped(s.labels, s.throat), [](std::uint8_t v) { return v == kTongue || v == kEpiglottis; });
}

TEST_F(EditedManikin, ATongueDrawnInRoughStepsIsMeshedAsDrawn) {
  const auto tongue = truth(kTongue);
  const auto once = with_neighbours(tongue);
  const auto twice = with_neighbours(once);
  int rough = 0;
  // Against palate and leaf too.
  for (const auto& [outer, cube] : {std::pair{&once, 0}, {&twice, 0}, {&twice, 7}, {&twice, 3}}) {
    const auto drawn = in_steps(tongue, *outer, cube);
    const auto s = with(replacing(kTongue, drawn));
    ASSERT_EQ(of(on_series_grid(s, grid()), kTongue).voxels, drawn.voxels);
    const auto fields = fields_of(s);
    rough += crossings(soft_surface(s, soft_field(s, fields), 0.93)).empty() ? 0 : 1;
    const auto mesh = soft_mesh(s, fields, 5000);
    const auto soft = soft_of(s);
    const double drawn_mm3 = static_cast<double>(count(soft)) * grid().voxel_mm3();
    EXPECT_NEAR(quality_of(mesh).volume_mm3 / drawn_mm3, 1.0, 0.02) << cube;
    const auto from_border = signed_distance(soft);
    double off = 0.0;
    int points = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (mesh.contact[v] == static_cast<std::uint8_t>(Contact::inside)) continue;
      off += std::abs(value_at(from_border, mesh.points[v]));
      ++points;
    }
    EXPECT_LT(off / points, 0.5 * grid().spacing[0]) << cube;
  }
  EXPECT_GT(rough, 0) << "else nothing is shown";
}

TEST_F(EditedManikin, ABorderThatCannotBeHelpedIsNamedWithItsPlace) {
  const auto tongue = truth(kTongue);
  auto s = with(replacing(kTongue, in_steps(tongue, with_neighbours(with_neighbours(tongue)), 2)));
  const auto fields = fields_of(s);
  s.replaced.clear();  // so that nothing is smoothed
  // As if the package's frame lay 100 mm further left than the scan's.
  s.pose.scan_to_package[3] += 100.0;
  std::string message;
  try {
    soft_mesh(s, fields, 1500);  // eight sizes are tried before it is given up: few triangles are soonest done
  } catch (const TetrahedralizeError& e) {
    message = e.what();
  }
  Point place{};
  ASSERT_EQ(
      std::sscanf(message.c_str(), "tongue: its border crosses itself near %lf, %lf, %lf mm (LPS, the scan's frame)",
                  &place[0], &place[1], &place[2]),
      3)
      << message;
  EXPECT_NE(message.find("--labels"), std::string::npos);
  place[0] += 100.0;
  EXPECT_LT(std::abs(value_at(signed_distance(soft_of(s)), place)), 1.5) << message;
}

TEST_F(EditedManikin, AGivenAirwayIsTheSurfaceAndTheGlottis) {
  // A ball of lumen in the cheek's tissue, joined to the mouth by a channel, and the nose shut off.
  auto lumen = truth(kAirway);
  const auto tongue = centroid(truth(kTongue));
  for (std::size_t i = 0; i < grid().count(); ++i) {
    const auto p = grid().position(i);
    const Vector3 ball{tongue[0] + 14.0, tongue[1], tongue[2] + 9.0};
    const bool channel =
        std::abs(p[1] - ball[1]) < 2.0 && std::abs(p[2] - ball[2]) < 2.0 && p[0] > tongue[0] && p[0] < ball[0];
    if (distance(p, ball) < 6.0 || channel) lumen.voxels[i] = 1;
  }
  const double mm3 = static_cast<double>(count(lumen)) * grid().voxel_mm3();
  ASSERT_GT(mm3, static_cast<double>(count(truth(kAirway))) * grid().voxel_mm3() + 200.0);
  const auto s = with(replacing(kAirway, lumen));
  EXPECT_EQ(of(on_series_grid(s, grid()), kAirway).voxels, lumen.voxels);
  const auto fields = fields_of(s);
  auto both = fields.airway_side;  // on the airway's box
  for (std::size_t i = 0; i < both.voxels.size(); ++i)
    both.voxels[i] = std::min<float>(-value_at(fields.solid, both.grid.position(i)), both.voxels[i]);
  const auto f = facts_of(isosurface(both));
  EXPECT_NEAR(f.volume_mm3 / mm3, 1.0, 0.03);
  EXPECT_LT(distance(s.airway.glottis.centre, Vector3(Manikin(1.2, 4).landmarks().at("glottis_centre"))), 1.5);
}

TEST_F(EditedManikin, AGivenMandibleCarriesItsLandmarks) {
  const auto jaw = of(*found_, kMandible);
  const int down = static_cast<int>(std::lround(4.0 / grid().spacing[2]));
  Mask lower(grid());
  for (int z = down; z < grid().size[2]; ++z) {
    for (int y = 0; y < grid().size[1]; ++y) {
      for (int x = 0; x < grid().size[0]; ++x) lower.at(x, y, z - down) = jaw.at(x, y, z);
    }
  }
  const auto s = with(replacing(kMandible, lower));
  EXPECT_EQ(of(on_series_grid(s, grid()), kMandible).voxels, lower.voxels);
  EXPECT_NEAR(s.landmarks.at("condyle_axis")[2], plain_->landmarks.at("condyle_axis")[2] - down * grid().spacing[2],
              1e-9);
  const auto field = bone_field(s, kMandible, s.bones.mandible, s.bones.skull);
  // Smoothed by a third of a millimetre, thin bone loses some.
  EXPECT_NEAR(facts_of(isosurface(field)).volume_mm3 / (static_cast<double>(count(lower)) * grid().voxel_mm3()), 1.0,
              0.1);
}

TEST_F(EditedManikin, AGivenLeafIsMeasured) {
  // A slab of 1.6 mm across the true leaf's place, 8 mm wide.
  const auto tip = Manikin(1.2, 4).landmarks().at("epiglottis_tip");
  Mask slab(grid());
  double top = -1e9;
  for (std::size_t i = 0; i < grid().count(); ++i) {
    const auto p = grid().position(i);
    if (std::abs(p[0] - tip[0]) > 3.0 || std::abs(p[1] - tip[1]) > 0.8 || p[2] > tip[2] || p[2] < tip[2] - 8.0)
      continue;
    slab.voxels[i] = 1;
    top = std::max(top, p[2]);
  }
  const auto s = with(replacing(kEpiglottis, slab));
  EXPECT_EQ(of(on_series_grid(s, grid()), kEpiglottis).voxels, slab.voxels);
  EXPECT_NEAR(s.landmarks.at("epiglottis_tip")[2], top, 1e-9);
  EXPECT_NEAR(s.landmarks.at("epiglottis_tip")[1], tip[1], 0.5 * grid().spacing[1]);
  EXPECT_TRUE(s.epiglottis.seen);
}

}  // namespace
}  // namespace vallecula::pipeline

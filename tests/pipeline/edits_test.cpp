// What a person says about a segmentation is followed: structures given, seeded, thresholded, landmarks moved. Truth is
// the manikin's own labels and shapes known by construction.
#include "pipeline/segment/edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <random>

#include "pipeline/manikin/manikin.h"
#include "pipeline/mesh/anatomy_fields.h"
#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/mesh/soft_surface.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "pipeline/segment/segment.h"
#include "pipeline/segment/upright.h"

namespace vallecula::pipeline {
namespace {

void expect_refused(const Edits& edits, const std::string& naming) {
  try {
    check_edits(edits);
    FAIL() << "accepted: " << naming;
  } catch (const EditError& e) {
    EXPECT_NE(std::string(e.what()).find(naming), std::string::npos) << e.what();
  }
}

TEST(Edits, WithBadNamesOrNumbersAreRefusedByName) {
  Edits good;
  good.seeds["tongue"] = {0, -40, 12};
  good.thresholds["airway"] = {-1024, -400};
  good.landmarks["carina"] = {0, 0, 0};
  EXPECT_NO_THROW(check_edits(good));
  const double nan = std::nan("");
  const auto with = [&](const auto& change) {
    Edits edits = good;
    change(edits);
    return edits;
  };
  expect_refused(with([](Edits& e) { e.seeds["toe"] = {0, 0, 0}; }), "toe");
  expect_refused(with([](Edits& e) { e.seeds["skin"] = {0, 0, 0}; }), "skin");
  expect_refused(with([nan](Edits& e) { e.seeds["airway"] = {0, nan, 0}; }), "airway");
  expect_refused(with([](Edits& e) { e.thresholds["bone"] = {0, 1}; }), "bone");
  expect_refused(with([](Edits& e) { e.thresholds["tongue"] = {80, 20}; }), "tongue");
  expect_refused(with([nan](Edits& e) { e.thresholds["tongue"] = {nan, 20}; }), "tongue");
  expect_refused(with([](Edits& e) { e.thresholds["airway"] = {-1024, 300}; }), "airway");
  expect_refused(with([](Edits& e) { e.thresholds["skin"] = {-400, 3000}; }), "skin: it has no highest");
  expect_refused(with([](Edits& e) { e.thresholds["skin"] = {-300, kNoHighest}; }), "airway and skin");
  expect_refused(with([](Edits& e) { e.thresholds["tongue"] = {20, kNoHighest}; }), "tongue");
  EXPECT_NO_THROW(check_edits(with([](Edits& e) { e.thresholds["skin"] = {-400, kNoHighest}; })));
  expect_refused(with([](Edits& e) { e.landmarks["nose"] = {0, 0, 0}; }), "nose");
  expect_refused(with([](Edits& e) { e.landmarks["glottis_normal"] = {0, 0, 0}; }), "glottis_normal");
  expect_refused(with([](Edits& e) { e.replaced = {kTongue}; }), "label map");
  Grid grid;
  grid.size = {10, 10, 10};
  grid.origin = {-5, -5, -5};
  EXPECT_THROW(check_edits_in(good, grid), EditError) << "the seed lies outside";
  good.seeds["tongue"] = {4.4, -5.4, 0};
  EXPECT_NO_THROW(check_edits_in(good, grid));
}

TEST(Edits, AreMovedWithTheHead) {
  // A quarter turn about z (x to y, y to -x) and a shift.
  PoseChange turn;
  turn.scan_to_package = {0, -1, 0, 10, 1, 0, 0, -20, 0, 0, 1, 5, 0, 0, 0, 1};
  Edits edits;
  edits.seeds["tongue"] = {3, 4, 5};
  edits.landmarks["glottis_centre"] = {1, 0, 0};
  edits.landmarks["glottis_normal"] = {1, 0, 0};
  Grid scan;
  scan.size = {8, 9, 10};
  edits.labels = Labels(scan);
  edits.replaced = {kTongue};
  edits.labels->at(3, 4, 5) = kTongue;
  Grid onto;
  onto.size = {20, 20, 20};
  onto.origin = {0, -25, 0};
  const auto out = put_upright(edits, turn, onto);
  EXPECT_EQ(out.seeds.at("tongue"), (Point{6, -17, 10}));
  EXPECT_EQ(out.landmarks.at("glottis_centre"), (Point{10, -19, 5}));
  EXPECT_EQ(out.landmarks.at("glottis_normal"), (Point{0, 1, 0})) << "a direction is turned, not shifted";
  EXPECT_EQ(out.labels->at(6, 8, 10), kTongue);
  EXPECT_EQ(std::count(out.labels->voxels.begin(), out.labels->voxels.end(), kTongue), 1);
}

/// A preterm's scan, segmented once without edits.
class EditedManikin : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    ManikinOptions options;
    options.weight_kg = 1.2;
    options.seed = 4;
    scan_ = std::make_unique<ManikinScan>(scan_manikin(options));
    plain_ = std::make_unique<Segmentation>(segment(scan_->ct, {}));
    found_ = std::make_unique<Labels>(on_series_grid(*plain_, scan_->ct.grid));
  }
  static void TearDownTestSuite() {
    scan_.reset();
    plain_.reset();
    found_.reset();
  }

  static const Grid& grid() { return scan_->ct.grid; }
  static Mask truth(std::uint8_t label) {
    return where(scan_->labels, [label](std::uint8_t v) { return v == label; });
  }
  static Mask of(const Labels& labels, std::uint8_t label) {
    return where(labels, [label](std::uint8_t v) { return v == label; });
  }
  static Edits replacing(std::uint8_t label, const Mask& mask) {
    Edits edits;
    edits.labels = Labels(grid());
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) edits.labels->voxels[i] = mask.voxels[i] != 0 ? label : 0;
    edits.replaced = {label};
    return edits;
  }
  static Vector3 centroid(const Mask& mask) {
    Vector3 sum{};
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
      if (mask.voxels[i] != 0) sum = sum + mask.grid.position(i);
    }
    return (1.0 / static_cast<double>(count(mask))) * sum;
  }
  /// The voxel of the mask furthest from its border: surely inside.
  static Vector3 heart(const Mask& mask) {
    const auto depth = distance_to(inverted(mask));
    return mask.grid.position(
        static_cast<std::size_t>(std::max_element(depth.voxels.begin(), depth.voxels.end()) - depth.voxels.begin()));
  }
  static double dice(const Mask& a, const Mask& b) {
    return 2.0 * static_cast<double>(count(all_of(a, b))) / static_cast<double>(count(a) + count(b));
  }
  static Segmentation with(const Edits& edits) { return segment(scan_->ct, edits); }
  static void expect_refused(const Edits& edits, const std::string& naming) {
    try {
      with(edits);
      FAIL() << "followed: " << naming;
    } catch (const std::runtime_error& e) {
      EXPECT_NE(std::string(e.what()).find(naming), std::string::npos) << e.what();
    }
  }

  static std::unique_ptr<ManikinScan> scan_;
  static std::unique_ptr<Segmentation> plain_;
  static std::unique_ptr<Labels> found_;
};
std::unique_ptr<ManikinScan> EditedManikin::scan_;
std::unique_ptr<Segmentation> EditedManikin::plain_;
std::unique_ptr<Labels> EditedManikin::found_;

TEST_F(EditedManikin, AWholeLabelMapComesBackAsItWasGiven) {
  Edits edits;
  edits.labels = scan_->labels;
  for (const auto& label : kLabelNames) edits.replaced.insert(label.value);
  const auto s = with(edits);
  EXPECT_EQ(on_series_grid(s, grid()).voxels, scan_->labels.voxels) << "the true labels, not those that are found";
  for (const auto& label : kLabelNames) EXPECT_EQ(s.findings.at(label.name).origin, Origin::given) << label.name;
  const auto truth = Manikin(1.2, 4).landmarks();
  for (const auto* name : {"vallecula", "epiglottis_tip", "glottis_centre", "carina", "condyle_axis"})
    EXPECT_LT(distance(s.landmarks.at(name), truth.at(name)), 2.0) << name << " is read off what was given";
}

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
    soft_mesh(s, fields, 5000);
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

TEST_F(EditedManikin, MovedLandmarksStandAndTheirDependentsFollow) {
  Edits edits;
  const auto gum = Vector3(plain_->landmarks.at("upper_gum_midline")) + Vector3{0.5, -1.0, 1.5};
  edits.landmarks["upper_gum_midline"] = gum;
  edits.landmarks["glottis_centre"] = Vector3(plain_->landmarks.at("glottis_centre")) + Vector3{0.2, 0.1, 0.4};
  edits.landmarks["hyoid"] = Vector3(plain_->landmarks.at("hyoid")) + Vector3{1, 2, 3};
  const auto s = with(edits);
  for (const auto& [name, point] : edits.landmarks) {
    EXPECT_EQ(s.landmarks.at(name), point) << name;
    EXPECT_EQ(s.findings.at(name).origin, Origin::given);
  }
  EXPECT_NEAR(distance(s.landmarks.at("operator_eye"), gum), 320.0, 1e-6) << "the eye goes with the gum";
  EXPECT_NE(s.landmarks.at("operator_eye"), plain_->landmarks.at("operator_eye"));
  EXPECT_EQ(s.findings.at("operator_eye").origin, Origin::measured);
  edits.landmarks["operator_eye"] = {0, -250, 200};
  edits.landmarks["glottis_centre"] = centroid(truth(kTongue));
  expect_refused(edits, "glottis");
  edits.landmarks.erase("glottis_centre");
  EXPECT_EQ(with(edits).landmarks.at("operator_eye"), (Point{0, -250, 200}));
}

TEST_F(EditedManikin, SeedsWhereTheStructureIsFindTheSame) {
  Edits edits;
  for (const auto& [name, label] :
       {std::pair{"airway", kAirway}, std::pair{"bone_mandible", kMandible}, std::pair{"bone_skull", kSkull},
        std::pair{"spine", kSpine}, std::pair{"epiglottis", kEpiglottis}, std::pair{"soft_palate", kSoftPalate}})
    edits.seeds[name] = heart(of(*found_, label));
  const auto truth = Manikin(1.2, 4).landmarks();
  edits.seeds["larynx"] = truth.at("glottis_centre");
  edits.seeds["hyoid"] = truth.at("hyoid");
  const auto s = with(edits);
  const auto labels = on_series_grid(s, grid());
  for (const auto& label : kLabelNames)
    EXPECT_GT(dice(of(labels, label.value), of(*found_, label.value)), 0.99) << label.name;
  EXPECT_LT(distance(s.landmarks.at("hyoid"), truth.at("hyoid")), 2.0);
  EXPECT_EQ(s.findings.at("bone_mandible").origin, Origin::given);
  EXPECT_NE(s.findings.at("bone_mandible").how, "");
}

TEST_F(EditedManikin, SeedsWhereItIsNotAreRefused) {
  const auto tongue = centroid(truth(kTongue));
  for (const auto* name : {"airway", "bone_mandible", "bone_skull", "spine", "epiglottis", "larynx", "soft_palate"}) {
    Edits edits;
    edits.seeds[name] = tongue;
    std::string word = name;
    std::replace(word.begin(), word.end(), '_', word.find("bone") == 0 ? '_' : ' ');
    expect_refused(edits, word);
  }
  Edits outside;
  outside.seeds["tongue"] = {0, 0, 900};
  expect_refused(outside, "tongue");
  outside.seeds.clear();
  outside.landmarks["upper_gum_midline"] = {0, 0, 900};
  expect_refused(outside, "upper_gum_midline");
}

TEST_F(EditedManikin, ThresholdsBoundTheStructure) {
  Edits edits;
  edits.thresholds["bone_mandible"] = {500, 3000};
  edits.thresholds["tongue"] = {20, 90};
  edits.thresholds["airway"] = {-1100, -650};
  const auto s = with(edits);
  const auto labels = on_series_grid(s, grid());
  std::size_t mandible = 0;
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    const auto hu = scan_->ct.voxels[i];
    if (labels.voxels[i] == kMandible) {
      ++mandible;
      ASSERT_GE(hu, 500);
    }
    ASSERT_FALSE(labels.voxels[i] == kAirway && hu > -650);
  }
  EXPECT_GT(mandible, 100u);
  EXPECT_LT(mandible, count(of(*found_, kMandible)));
  EXPECT_LT(count(of(labels, kAirway)), count(of(*found_, kAirway)));
  EXPECT_GT(dice(of(labels, kSkull), of(*found_, kSkull)), 0.99) << "the skull keeps its own";
  EXPECT_NE(s.findings.at("airway").how.find("-650"), std::string::npos);

  Edits none;
  none.thresholds["tongue"] = {900, 1200};
  expect_refused(none, "tongue");
}

}  // namespace
}  // namespace vallecula::pipeline

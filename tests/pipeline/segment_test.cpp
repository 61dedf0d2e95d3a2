// The segmentation against the manikin's true labels and landmarks, which the code under test did not make.
#include "pipeline/segment/segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "pipeline/segment/upright.h"
#include "pipeline/segment/volume_ops.h"
#include "tests/pipeline/agreement.h"
#include "tests/pipeline/turned_manikin.h"

namespace vallecula::pipeline {
namespace {

using test::agreement_of;

struct Infant {
  double weight_kg;
  std::uint64_t seed;
  double noise_hu = 12.0;
  Askew pose = {};
};

class SegmentManikin : public ::testing::TestWithParam<Infant> {};

TEST_P(SegmentManikin, FindsEveryStructureWithoutAHumanSeed) {
  const auto& in = GetParam();
  ManikinOptions options;
  options.weight_kg = in.weight_kg;
  options.seed = in.seed;
  options.noise_hu = in.noise_hu;
  const bool askew = in.pose.tilt_deg != 0.0 || in.pose.turn_deg != 0.0 || in.pose.nod_deg != 0.0;
  const bool small = in.weight_kg < 2.0;
  const auto scan = askew ? scan_askew(options, in.pose, small ? 0.4 : 0.5, small ? 0.6 : 0.8) : scan_manikin(options);
  const auto s = segment(scan.ct, {});
  EXPECT_EQ(s.pose.moved(), askew);
  const auto found = on_series_grid(s, scan.ct.grid);

  auto agreement = agreement_of(scan.labels, found);
  // What a model needs to be practised on: Dice, and on average half a voxel (its shortest side) from the truth.
  const auto& spacing = scan.ct.grid.spacing;
  const double half_voxel = 0.5 * std::min({spacing[0], spacing[1], spacing[2]});
  const auto goal = [&](const LabelAgreement& a, const char* name, double dice) {
    EXPECT_GE(a.dice, dice) << name;
    EXPECT_LE(a.mean_surface_mm, half_voxel) << name;
  };
  goal(agreement[kTongue], "tongue", 0.95);
  goal(agreement[kAirway], "airway", 0.97);
  goal(agreement[kMandible], "mandible", 0.955);
  // Three voxels of skull, each off by so much grain: short of the goal (pipeline/README.md, Limits).
  const double bone = in.weight_kg < 0.7 && in.noise_hu >= 40.0 ? 0.94 : 0.95;
  goal(agreement[kSkull], "skull", bone);
  goal(agreement_of(scan.labels, found, {{kMandible, kSkull}})[kSkull], "bone", bone);
  goal(agreement[kSkin], "skin", 0.99);
  std::map<std::uint8_t, std::uint8_t> all;
  for (const auto& label : kLabelNames) all[label.value] = kSkin;
  goal(agreement_of(scan.labels, found, all)[kSkin], "the whole head", 0.995);
  goal(agreement[kEpiglottis], "epiglottis", 0.8);
  // Coarse by design: enough to name what the blade touches.
  EXPECT_GE(agreement[kSoftPalate].dice, 0.65);
  EXPECT_GE(agreement[kLarynx].dice, 0.65);
  EXPECT_GE(agreement[kOesophagus].dice, 0.5);
  EXPECT_GE(agreement[kSpine].dice, 0.7);

  std::printf("[ figures  ] %.1f kg seed %llu noise %.0f%s:", in.weight_kg, static_cast<unsigned long long>(in.seed),
              in.noise_hu, askew ? " askew" : "");
  for (const auto& label : kLabelNames)
    std::printf(" %s %.3f (%.2f mm)", label.name, agreement[label.value].dice, agreement[label.value].mean_surface_mm);

  double worst = 0.0;
  std::string worst_name;
  for (const auto& [name, truth] : Manikin(in.weight_kg, in.seed).landmarks()) {
    // A direction is turned with the head, not moved.
    const auto lies = name == "glottis_normal" ? Vector3(moved(s.pose.scan_to_package, in.pose.to_scan(truth))) -
                                                     Vector3(moved(s.pose.scan_to_package, in.pose.to_scan({0, 0, 0})))
                                               : Vector3(moved(s.pose.scan_to_package, in.pose.to_scan(truth)));
    const double off = distance(lies, s.landmarks.at(name));
    // The eye is 320 mm away: half a millimetre at the gum turns it by 3 mm, and so does a degree of nod the head. The
    // normal is a direction: 0.1 is 6 degrees.
    const double allowed = name == "operator_eye" ? 5.0 : name == "glottis_normal" ? 0.1 : 1.0;
    EXPECT_LE(off, allowed) << name;
    if (name == "operator_eye" || name == "glottis_normal" || off < worst) continue;
    worst = off;
    worst_name = name;
  }
  std::printf(" | worst landmark %.2f mm (%s)\n", worst, worst_name.c_str());
  for (const auto& [name, finding] : s.findings)
    EXPECT_EQ(finding.origin, Origin::measured) << name << ": " << finding.how;
}

std::vector<Infant> infants() {
  std::vector<Infant> list{{0.6, 2}, {3.2, 1}, {4.5, 5}, {1.2, 104, 40.0}};
  if (std::getenv("VALLECULA_SLOW") != nullptr) {
    for (const double weight : {0.6, 0.9, 1.5, 2.2, 3.2, 3.8, 4.5}) {
      for (const std::uint64_t seed : {0, 3, 8, 21}) list.push_back({weight, seed});
    }
    const double weights[] = {0.6, 0.8, 1.0, 1.3, 1.7, 2.1, 2.5, 2.9, 3.3, 3.7, 4.1, 4.5};
    const double noises[] = {40.0, 0.0, 30.0, 20.0, 12.0, 40.0};
    const Askew poses[] = {{}, {20.0, -25.0, 10.0, {}}, {}, {}, {-10.0, 30.0, -20.0, {}}, {},
                           {}, {30.0, 5.0, 25.0, {}}};
    for (std::uint64_t i = 0; i < 12; ++i) list.push_back({weights[i], 201 + i, noises[i % 6], poses[i % 8]});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(WeightsAndSeeds, SegmentManikin, ::testing::ValuesIn(infants()), [](const auto& info) {
  return "Grams" + std::to_string(static_cast<int>(std::lround(1000.0 * info.param.weight_kg))) + "Seed" +
         std::to_string(info.param.seed);
});

TEST(Segment, SaysWhatIsMissing) {
  Grid g;
  g.size = {60, 60, 40};
  Hounsfield air(g, -1000);
  EXPECT_THROW(segment(air, {}), std::runtime_error);
  Hounsfield ball(g, -1000);  // tissue without bone and airway
  for (std::size_t i = 0; i < ball.voxels.size(); ++i) {
    const auto p = g.position(i);
    if (std::hypot(p[0] - 30, p[1] - 30, p[2] - 20) < 18) ball.voxels[i] = 40;
  }
  try {
    segment(ball, {});
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("bone"), std::string::npos) << e.what();
  }
}

/// Part of the term manikin's scan, as a shorter or narrower series would show it.
Hounsfield part_of(const Hounsfield& ct, double front_y, double low_z, double high_z) {
  return cropped(ct, box_between(ct.grid, {-1e6, front_y, low_z}, {1e6, 1e6, high_z}));
}

std::string refusal_of(const Hounsfield& ct) {
  try {
    segment(ct, {});
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

TEST(Segment, NamesWhatTheFieldOfViewLacks) {
  const auto ct = scan_manikin({}).ct;
  const auto says = [&](const Hounsfield& part, const char* what) {
    const auto text = refusal_of(part);
    EXPECT_NE(text.find(what), std::string::npos) << "expected: " << what << "; said: " << text;
  };
  says(part_of(ct, -1e6, -44.0, 1e6), "ends above the glottis");
  says(part_of(ct, -1e6, -1e6, -40.0), "begins below the palate");
  says(part_of(ct, -1e6, 30.0, 1e6), "no airway was found");  // brain alone
  says(part_of(ct, 28.0, -1e6, 1e6), "no airway was found");  // the face cut off
}

TEST(Segment, ASkullCutAtTheTopAndATracheaCutAboveTheCarinaStillGiveThePatient) {
  const auto scan = scan_manikin({});
  const auto truth = Manikin().landmarks();
  const auto s = segment(part_of(scan.ct, -1e6, -60.0, 30.0), {});
  EXPECT_TRUE(s.bones.mandible_free);
  EXPECT_NEAR(s.frame.scale, 1.0, 0.05);
  EXPECT_EQ(s.findings.at("carina").origin, Origin::inferred);
  for (const auto* name : {"upper_gum_midline", "lower_gum_midline", "vallecula", "glottis_centre", "epiglottis_tip",
                           "hyoid", "condyle_axis"}) {
    const auto& a = s.landmarks.at(name);
    const auto& b = truth.at(name);
    EXPECT_LE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1.2) << name;
  }
  const auto& a = s.landmarks.at("carina");
  const auto& b = truth.at("carina");
  EXPECT_LE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 6.0) << "continued by a rule over 36 mm";
}

TEST(Segment, ACouchUnderTheHeadAndAMetalClipChangeLittle) {
  auto scan = scan_manikin({});
  const auto& g = scan.ct.grid;
  const auto body = bounds_of(where(scan.labels, [](std::uint8_t v) { return v != kBackground; }));
  const double back = g.origin[1] + body.high[1] * g.spacing[1];
  for (std::size_t i = 0; i < g.count(); ++i) {
    const auto p = g.position(i);
    // A shell of 3 mm that the head lies on, and a clip on the cheek.
    if (p[1] > back && p[1] < back + 3.0 && scan.labels.voxels[i] == kBackground) scan.ct.voxels[i] = 150;
    if (std::abs(p[0] - 25.0) < 1.0 && std::abs(p[1] - 25.0) < 3.0 && std::abs(p[2] + 25.0) < 1.0)
      scan.ct.voxels[i] = 3071;
  }
  const auto s = segment(scan.ct, {});
  const auto found = on_series_grid(s, g);
  EXPECT_FALSE(s.pose.moved());
  EXPECT_TRUE(s.bones.mandible_free);
  auto agreement = agreement_of(scan.labels, found);
  EXPECT_GE(agreement[kSkin].dice, 0.98);
  EXPECT_GE(agreement[kMandible].dice, 0.94);
  EXPECT_GE(agreement[kTongue].dice, 0.95);
}

}  // namespace
}  // namespace vallecula::pipeline

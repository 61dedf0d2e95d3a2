// What a person says about a segmentation is followed: structures given, seeded, thresholded, landmarks moved. Truth is
// the manikin's own labels.
#include "pipeline/segment/edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/segment/upright.h"
#include "tests/pipeline/edited_manikin.h"

namespace vallecula::pipeline {
namespace {

using test::EditedManikin;

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

// The tube's way against airways whose course is known: a tube of ellipses along an arc, and the manikin's shapes.
#include "gui/session/airway_course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "curricula/scenario.h"
#include "engine/tube/passage.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/intubation_of.h"
#include "pipeline/manikin/manikin.h"
#include "pipeline/manikin/manikin_data.h"
#include "pipeline/manikin/shapes.h"
#include "tests/gui/arc_patient.h"

namespace vallecula::gui::test {
namespace {

using engine::AirwayPart;
using engine::AirwayRing;
using engine::Vec3;

constexpr double kAreaOfCricoid = M_PI * 2.25 * 2.73;  // mm2 (ANATOMY: 19.3)

/// Everything that the engine may rely on.
void expect_sound(const engine::AirwayCourse& course, double size) {
  ASSERT_GE(course.airway.size(), 10u);
  EXPECT_NO_THROW(engine::Passage(course, {}, Vec3::Zero(), Vec3::UnitZ())) << "the engine takes it";
  EXPECT_EQ(course.airway.front().part, AirwayPart::vestibule);
  int cords = 0, cricoids = 0;
  for (const auto* chain : {&course.airway, &course.bronchi[0], &course.bronchi[1], &course.oesophagus}) {
    ASSERT_GE(chain->size(), 5u);
    for (std::size_t i = 0; i < chain->size(); ++i) {
      const AirwayRing& r = (*chain)[i];
      cords += r.part == AirwayPart::cords;
      cricoids += r.part == AirwayPart::cricoid;
      EXPECT_NEAR(r.along.norm(), 1.0, 1e-9);
      EXPECT_NEAR(r.left.norm(), 1.0, 1e-9);
      EXPECT_NEAR(r.along.dot(r.left), 0.0, 1e-9);
      EXPECT_GT(r.left.x(), 0.5) << "the patient's left";
      for (const double half : {r.to_left_m, r.to_right_m, r.to_front_m, r.to_back_m}) {
        EXPECT_GT(half, 0.2e-3);
        EXPECT_LT(half, 15e-3);
      }
      EXPECT_GE(r.larynx_share, 0.0);
      EXPECT_LE(r.larynx_share, kLarynxShare);
      if (i == 0) continue;
      const AirwayRing& before = (*chain)[i - 1];
      const Vec3 way = r.centre - before.centre;
      EXPECT_GE(way.norm(), 0.5e-3 * std::min(1.0, size)) << i;
      EXPECT_LE(way.norm(), 4.0e-3) << i;
      EXPECT_GT(way.dot(before.along), 0.0) << "the planes follow one another";
      EXPECT_GT(way.dot(r.along), 0.0);
    }
  }
  EXPECT_EQ(cords, 1);
  EXPECT_EQ(cricoids, 1);
  EXPECT_EQ(course.airway.back().larynx_share, 0.0);
  EXPECT_EQ(course.larynx_body, kHyoidBody);
}

const AirwayRing& ring_of(const engine::AirwayCourse& course, AirwayPart part) {
  for (const AirwayRing& r : course.airway)
    if (r.part == part) return r;
  throw std::logic_error("no such ring");
}

TEST(AirwayCourse, FollowsAnArcOfEllipsesToWithinATenthOfAMillimetre) {
  const ArcAirway truth;
  const PatientAirway found = airway_of(truth.patient(51, 50));
  expect_sound(found.course, 1.0);
  EXPECT_NEAR(1e3 * found.glottis_length_m, 7.0, 1e-9);
  EXPECT_NEAR(1e6 * found.cricoid_area_m2, M_PI * (2.25 + 0.066) * (2.73 + 0.066), 0.01 * kAreaOfCricoid);
  const AirwayRing& cricoid = ring_of(found.course, AirwayPart::cricoid);
  for (const AirwayRing& r : found.course.airway) {
    if (r.part == AirwayPart::vestibule || r.part == AirwayPart::cords) continue;
    const double s =
        ArcAirway::kRadius * std::atan2(-40 - 1e3 * r.centre.z(), 50 + ArcAirway::kRadius - 1e3 * r.centre.y());
    EXPECT_LT((1e3 * r.centre - truth.at(s)).norm(), 0.1) << s;
    EXPECT_GT(r.along.dot(truth.along(s)), std::cos(3 * M_PI / 180)) << s;
    EXPECT_EQ(r.to_left_m, r.to_right_m);
    if (r.part == AirwayPart::subglottis) {  // the cords' slit gives way: it is not what stops a tube
      EXPECT_GE(r.to_left_m, cricoid.to_left_m + 0.3e-3) << s;
      EXPECT_GE(r.to_front_m, cricoid.to_front_m + 0.3e-3) << s;
      continue;
    }
    // A surface that was not imaged and smoothed is where its wall is; the allowance for that is on top of it.
    EXPECT_NEAR(1e3 * r.to_left_m, truth.half_left(s) + 0.066, 0.05) << s;
    EXPECT_NEAR(1e3 * r.to_front_m, truth.half_front(s) + 0.066, 0.05) << s;
  }
  EXPECT_LT((1e3 * found.course.airway.back().centre - truth.at(50)).norm(), 0.15) << "ends at the carina";
  const double cricoid_s = (1e3 * ring_of(found.course, AirwayPart::cricoid).centre - truth.at(0)).norm();
  EXPECT_GT(cricoid_s, 4.0);
  EXPECT_LT(cricoid_s, 8.0);
}

TEST(AirwayCourse, WhatIsNotImagedIsAssumedAndSaid) {
  const ArcAirway truth;
  const PatientAirway found = airway_of(truth.patient(51, 50));
  ASSERT_EQ(found.assumed.size(), 3u) << "both bronchi and the oesophagus' mouth";
  const AirwayRing& last = found.course.airway.back();
  for (int side = 0; side < 2; ++side) {
    const auto& bronchus = found.course.bronchi[static_cast<std::size_t>(side)];
    const AirwayRing& first = bronchus.front();
    EXPECT_NEAR(std::acos(first.along.dot(last.along)) * 180 / M_PI, side == 0 ? 30 : 45, 0.5);
    EXPECT_EQ(first.along.x() < 0, side == 0) << "the first is the right one";
    EXPECT_NEAR((bronchus.back().centre - first.centre).norm(), 0.020, 1e-4);
    EXPECT_NEAR(1e3 * first.to_left_m, 0.75 * 2.666, 0.03);
    // Its inner wall goes through the carina.
    const Vec3 off = last.centre - first.centre;
    EXPECT_LT(off.dot(last.along), 0.0) << "it begins below";
    EXPECT_NEAR((off - off.dot(first.along) * first.along).norm(), first.to_left_m, 1e-5);
  }
  for (const AirwayRing& r : found.course.oesophagus) {
    const Vec3 front = r.along.cross(r.left);
    for (const AirwayRing& beside : found.course.airway) {
      if (beside.part != AirwayPart::trachea || std::abs(r.along.dot(beside.centre - r.centre)) > 1e-3) continue;
      EXPECT_GT(front.dot(beside.centre - r.centre), beside.to_back_m + 1e-3) << "behind the trachea";
    }
  }
  const auto& gullet = found.course.oesophagus;
  EXPECT_NEAR(1e3 * (gullet.back().centre - gullet.front().centre).norm(), 60, 3);
  EXPECT_NEAR(1e3 * gullet[5].to_front_m, 0.5, 1e-9);
  EXPECT_NEAR(1e3 * gullet[5].to_left_m, 3.0, 1e-9);
}

TEST(AirwayCourse, GoesStraightOnWhereTheSurfaceEndsAndSaysSo) {
  const ArcAirway truth;
  const PatientAirway found = airway_of(truth.patient(25, 50));
  expect_sound(found.course, 1.0);
  ASSERT_FALSE(found.assumed.empty());
  EXPECT_NE(found.assumed[0].find("below the cords"), std::string::npos) << found.assumed[0];
  EXPECT_LT((1e3 * found.course.airway.back().centre - truth.at(50)).norm(), 1e-6) << "the carina as given";
  EXPECT_NEAR(1e3 * found.course.airway.back().to_left_m, 2.666, 0.05);
}

TEST(AirwayCourse, RefusesAPatientWithoutAnAirwayBelowTheCords) {
  const ArcAirway truth;
  EXPECT_THROW(airway_of(truth.patient(5, 50)), std::runtime_error);
  pipeline::PatientPackage elsewhere = truth.patient(51, 50);
  elsewhere.landmarks["glottis_centre"] = {40, 50, -40};
  EXPECT_THROW(airway_of(elsewhere), std::runtime_error);
  pipeline::PatientPackage lacking = truth.patient(51, 50);
  lacking.landmarks.erase("carina");
  try {
    airway_of(lacking);
    FAIL() << "a carina is needed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("carina"), std::string::npos);
  }
}

/// The manikin's own CT, imported, against its shapes. 0.5 mm voxels: a wall is found to within a quarter of one.
class AirwayCourseManikin : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    package_ = new pipeline::PatientPackage(pipeline::read_package(builtin_patient({kWeightKg, kSeed})));
    found_ = new PatientAirway(airway_of(*package_));
  }
  static void TearDownTestSuite() {
    delete found_;
    delete package_;
  }
  static constexpr double kWeightKg = 3.2, kWall = 0.12;
  static constexpr unsigned kSeed = 1;
  static pipeline::PatientPackage* package_;
  static PatientAirway* found_;
  const pipeline::Manikin manikin_{kWeightKg, kSeed};
  const pipeline::manikin::Variation variation_ = manikin_.data().body.variation();
  const double scale_ = manikin_.scale();
};
pipeline::PatientPackage* AirwayCourseManikin::package_ = nullptr;
PatientAirway* AirwayCourseManikin::found_ = nullptr;

TEST_F(AirwayCourseManikin, TheCricoidAndTheTracheaAreTheShapesWithinTheImagingsError) {
  expect_sound(found_->course, scale_);
  const double wide = scale_ * variation_.lumen;
  const AirwayRing& cricoid = ring_of(found_->course, AirwayPart::cricoid);
  EXPECT_NEAR(1e3 * cricoid.to_left_m, 2.25 * wide, kWall);
  EXPECT_NEAR(1e3 * cricoid.to_front_m, 2.73 * wide, kWall);
  EXPECT_NEAR(1e6 * found_->cricoid_area_m2, kAreaOfCricoid * wide * wide, 2 * M_PI * 2.5 * kWall);
  EXPECT_NEAR(1e6 * M_PI * cricoid.to_left_m * cricoid.to_front_m, 1e6 * found_->cricoid_area_m2, 0.01);
  double sum = 0.0;
  int count = 0;
  for (const AirwayRing& r : found_->course.airway) {
    const double below = 1e3 * (r.centre - cricoid.centre).norm() / scale_;
    if (r.part != AirwayPart::trachea || below < 10 || below > 36) continue;
    sum += 0.5e3 * (r.to_left_m + r.to_front_m);
    ++count;
  }
  ASSERT_GT(count, 8);
  EXPECT_NEAR(sum / count, 2.6 * wide, kWall);
}

TEST_F(AirwayCourseManikin, ItsAxisIsTheTracheasAndItEndsAtTheCarina) {
  using pipeline::manikin::kSubglottis;
  using pipeline::manikin::kTracheaAxis;
  const Vec3 top(0, scale_ * kSubglottis.u, scale_ * kSubglottis.v), axis(0, kTracheaAxis.u, kTracheaAxis.v);
  for (const AirwayRing& r : found_->course.airway) {
    if (r.part != AirwayPart::trachea) continue;
    const Vec3 off = 1e3 * r.centre - top;
    EXPECT_LT((off - off.dot(axis) * axis).norm(), 1.0) << "the package's head lies within a millimetre of the scan's";
    EXPECT_GT(r.along.dot(axis), std::cos(4 * M_PI / 180));
  }
  const auto truth = manikin_.landmarks().at("carina");
  EXPECT_LT((1e3 * found_->course.airway.back().centre - Vec3(truth[0], truth[1], truth[2])).norm(), 2.5);
  double length = 0.0;
  bool below = false;
  for (std::size_t i = 0; i + 1 < found_->course.airway.size(); ++i) {
    below = below || found_->course.airway[i].part == AirwayPart::cords;
    if (below) length += 1e3 * (found_->course.airway[i + 1].centre - found_->course.airway[i].centre).norm();
  }
  using pipeline::manikin::kGlottisCentre;
  const double true_length = scale_ * (std::hypot(kSubglottis.u - kGlottisCentre.u, kSubglottis.v - kGlottisCentre.v) +
                                       pipeline::manikin::kTracheaLength * variation_.trachea_length);
  EXPECT_NEAR(length, true_length, 2.0) << "cords to carina";
  // The narrow front of the slit is thinner than a voxel.
  EXPECT_NEAR(1e3 * found_->glottis_length_m, 7.034 * scale_, 1.5);
}

TEST_F(AirwayCourseManikin, BronchiAreImagedAndTheOesophagusBeginsAtTheThroatsEnd) {
  EXPECT_TRUE(found_->assumed.empty()) << found_->assumed.front();
  // ANATOMY's bronchi part by (4.6 - 1.7) over 4.2 of the way down: 35 degrees, then more.
  for (int side = 0; side < 2; ++side) {
    const AirwayRing& r = found_->course.bronchi[static_cast<std::size_t>(side)][3];
    EXPECT_EQ(r.centre.x() < 0, side == 0);
    EXPECT_NEAR(1e3 * r.to_left_m, 0.75 * 2.6 * scale_ * variation_.lumen, kWall);
  }
  // The throat ends at (41.6, -50.5); its last cut is within a cut's spacing of that.
  const Vec3 mouth = 1e3 * found_->course.oesophagus.front().centre;
  EXPECT_NEAR(mouth.y(), 41.6 * scale_, 1.0);
  EXPECT_NEAR(mouth.z(), -50.0 * scale_, 2.0);
  EXPECT_NEAR(mouth.x(), 0.0, 0.3);
}

// ANATOMY.md gives the profile of a term infant in (y, z), mm: the gums' midlines and the upper lip's two foremost
// points.
TEST_F(AirwayCourseManikin, ATubesMarkIsReadAtTheUpperLipAndNotAtTheGums) {
  const curricula::Curriculum course = curricula::load_curriculum(std::filesystem::path(VALLECULA_SOURCE_DIR) /
                                                                  "curricula/courses/first-intubation.yaml");
  const engine::IntubationDescription d = intubation_of(*package_, *course.find("term-tube"));
  const auto sagittal = [](const Vec3& p) { return std::array<double, 2>{p.y(), p.z()}; };
  const auto inward = sagittal(d.mouth_inward);
  const std::array<double, 2> middle{1.6, -10.4};  // between (0, 0) and (3.2, -20.8)
  double before = 0.0;
  for (const auto& lip : {std::array<double, 2>{-5.3, 4.1}, std::array<double, 2>{-5.8, 7.7}})
    before = std::max(before, inward[0] * (middle[0] - lip[0]) + inward[1] * (middle[1] - lip[1]));
  EXPECT_NEAR(1e3 * d.lips_before_gums_m, scale_ * before, 1.5) << "the skin is rounded outwards over these points";
  EXPECT_GT(1e3 * d.lips_before_gums_m, 3.0);
}

// The shipped scenarios tell a hand to wait for the cords to open with a breath.
TEST_F(AirwayCourseManikin, AScenariosInfantBreathesAndItsCordsMoveWithIt) {
  const curricula::Curriculum course = curricula::load_curriculum(std::filesystem::path(VALLECULA_SOURCE_DIR) /
                                                                  "curricula/courses/first-intubation.yaml");
  for (const auto& [id, breathes] : {std::pair{"term-tube", true}, std::pair{"laryngospasm", true},
                                     std::pair{"preterm-premedicated", false}, std::pair{"delivery-room", false}}) {
    const engine::IntubationDescription d = intubation_of(*package_, *course.find(id));
    EXPECT_EQ(d.breathes, breathes) << id;
    const engine::Infant infant = engine::build_infant(d.infant);
    engine::InfantState life = engine::start(infant);
    engine::GlottisState cords = engine::start(d.glottis);
    double least = 1.0, most = 0.0;
    for (int n = 0; n < 4000; ++n) {
      engine::InfantInput to_infant;
      to_infant.breathing = d.breathes;
      engine::GlottisInput to_cords;
      to_cords.breathing = d.breathes;
      to_cords.breath_phase = engine::step(infant, life, to_infant, 0.001).breath_phase;
      engine::step(d.glottis, cords, to_cords, 0.001);
      if (n < 1000) continue;
      least = std::min(least, cords.opening);
      most = std::max(most, cords.opening);
    }
    EXPECT_EQ(most - least > 0.2, breathes) << id << ": cords from " << least << " to " << most;
  }
}

}  // namespace
}  // namespace vallecula::gui::test

// The check by playing: the shipped infant is content; anatomy that hides the view is named.
#include "gui/session/play_check.h"

#include <gtest/gtest.h>

#include "gui/session/builtin_patient.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui::test {
namespace {

pipeline::PatientPackage term_infant() { return pipeline::read_package(builtin_patient({3.2, 1})); }

const pipeline::QualityItem* item(const std::vector<pipeline::QualityItem>& items, const std::string& name) {
  for (const auto& i : items)
    if (i.name == name) return &i;
  return nullptr;
}

TEST(PlayCheck, TheShippedInfantsGlottisIsHiddenAndComesIntoSight) {
  double done = 0.0;
  auto package = term_infant();
  const auto items = check_by_playing(package, [&](double f) {
    EXPECT_GE(f, done);
    done = f;
  });
  ASSERT_EQ(items.size(), 2u);
  EXPECT_TRUE(item(items, "glottis in sight at rest")->ok);
  EXPECT_TRUE(item(items, "glottis in sight when lifted")->ok);
  EXPECT_GE(item(items, "glottis in sight when lifted")->value, 100.0 * kSeenEnough);
  EXPECT_GT(done, 0.5);
}

TEST(PlayCheck, AnEyeTooLowMeetsTheUpperLipAndANarrowMouthIsNamed) {
  auto package = term_infant();
  // The worked design: with the eye 20 mm lower, nearer the table, the upper lip blocks.
  package.landmarks.at("operator_eye")[1] += 20.0;
  auto items = check_by_playing(package);
  const auto* seen = item(items, "glottis in sight when lifted");
  ASSERT_NE(seen, nullptr);
  EXPECT_FALSE(seen->ok);
  EXPECT_NE(seen->note.find("a lip stands in the line of sight"), std::string::npos) << seen->note;
  EXPECT_NE(seen->note.find("mm (package frame, LPS)"), std::string::npos) << seen->note;
  EXPECT_EQ(seen->note.rfind("not ready for practice: ", 0), 0u) << seen->note;
  EXPECT_EQ(seen, &items.front()) << "the verdict is read first";

  package.landmarks.at("lower_gum_midline") = package.landmarks.at("upper_gum_midline");
  package.landmarks.at("lower_gum_midline")[2] -= 4.0;
  items = check_by_playing(package);
  seen = item(items, "glottis in sight when lifted");
  ASSERT_NE(seen, nullptr);
  EXPECT_FALSE(seen->ok);
  EXPECT_NE(seen->note.find("too narrow: 4.0 mm"), std::string::npos) << seen->note;
}

TEST(PlayCheck, APackageWithoutATongueIsAnItemAndNoCrash) {
  auto package = term_infant();
  package.tongue.points.clear();
  package.tongue.tets.clear();
  package.tongue.tissue.clear();
  package.tongue.anchor.clear();
  const auto items = check_by_playing(package);
  ASSERT_EQ(items.size(), 1u);
  EXPECT_FALSE(items[0].ok);
  EXPECT_NE(items[0].note.find("no scene can be built"), std::string::npos) << items[0].note;
}

}  // namespace
}  // namespace vallecula::gui::test

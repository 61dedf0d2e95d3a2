#include "curricula/score/mouth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vallecula::curricula {
namespace {

using Point = std::array<double, 3>;
using Landmarks = std::map<std::string, Point>;

Landmarks term(double scale = 1.0) {
  return {{"upper_gum_midline", {0, 0, 0}},
          {"lower_gum_midline", {0, 0.0032 * scale, -0.0208 * scale}},
          {"vallecula", {0, 0.0285 * scale, -0.0415 * scale}}};
}

// Points of ANATOMY's mid-sagittal design, m.
TEST(Mouth, HoldsWhatAnatomyPutsInIt) {
  const auto mouth = mouth_from_landmarks(term());
  ASSERT_TRUE(mouth);
  for (const Point& inside : {Point{0, 0.0285, -0.0415}, Point{0, 0.0168, -0.005}, Point{0, 0.017, -0.018},
                              Point{0, 0.033, -0.048}, Point{0.012, 0.01, -0.012}, Point{-0.013, 0.02, -0.02}}) {
    EXPECT_TRUE(mouth->holds(inside)) << inside[1] << " " << inside[2];
  }
}

TEST(Mouth, DoesNotHoldLipsFaceAndTheAirAroundTheHead) {
  const auto mouth = mouth_from_landmarks(term());
  ASSERT_TRUE(mouth);
  for (const Point& outside : {Point{0, -0.0053, 0.0041}, Point{0, -0.0028, -0.0215}, Point{0, -0.003, -0.033},
                               Point{0, -0.2, 0.25}, Point{0, -0.03, -0.01}, Point{0, -0.0063, 0.0173},
                               Point{0.06, 0.02, -0.02}, Point{0, 0.1, 0.0}, Point{0, 0.02, -0.1}}) {
    EXPECT_FALSE(mouth->holds(outside)) << outside[1] << " " << outside[2];
  }
  EXPECT_FALSE(mouth->holds({std::nan(""), 0.02, -0.02}));
}

TEST(Mouth, GrowsWithTheInfant) {
  for (const double scale : {0.6, 1.0, 1.3}) {
    const auto mouth = mouth_from_landmarks(term(scale));
    ASSERT_TRUE(mouth);
    EXPECT_TRUE(mouth->holds({0.012 * scale, 0.01 * scale, -0.012 * scale}));
    EXPECT_FALSE(mouth->holds({0.028 * scale, 0.01 * scale, -0.012 * scale}));
  }
}

TEST(Mouth, OfAClosedMouthFacesTheVallecula) {
  Landmarks closed = term();
  closed["lower_gum_midline"] = {0, 0.0001, -0.0002};
  const auto mouth = mouth_from_landmarks(closed);
  ASSERT_TRUE(mouth);
  EXPECT_TRUE(mouth->holds({0, 0.02, -0.03}));
  EXPECT_FALSE(mouth->holds({0, -0.005, 0.005}));
}

TEST(Mouth, NeedsItsLandmarks) {
  for (const char* name : {"upper_gum_midline", "lower_gum_midline", "vallecula"}) {
    Landmarks without = term();
    without.erase(name);
    EXPECT_FALSE(mouth_from_landmarks(without)) << name;
  }
  Landmarks flat = term();
  flat["vallecula"] = {0, 0.0016, -0.0104};  // between the gums
  EXPECT_FALSE(mouth_from_landmarks(flat));
  flat["vallecula"] = {0, std::nan(""), 0};
  EXPECT_FALSE(mouth_from_landmarks(flat));
  flat["vallecula"] = {0, 0.0064, -0.0416};  // on the gum line
  EXPECT_FALSE(mouth_from_landmarks(flat));
}

}  // namespace
}  // namespace vallecula::curricula

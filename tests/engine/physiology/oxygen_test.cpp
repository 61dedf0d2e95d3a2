// The dissociation curve against published points and the store against its balance.
#include "engine/physiology/oxygen.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/physiology/infants.h"

namespace vallecula::engine {
namespace {

constexpr double kAdultP50 = 26.86;

// Textbook points of adult blood (pH 7.4, 37 degrees), given in whole percent; the equation's own error is 0.0055.
TEST(Oxygen, TheCurvePassesThroughTheTextbooksPoints) {
  constexpr double kTolerance = 0.0055 + 0.005;
  EXPECT_NEAR(saturation(26.86, kAdultP50), 0.50, 0.001);
  EXPECT_NEAR(saturation(40.0, kAdultP50), 0.75, kTolerance);
  EXPECT_NEAR(saturation(60.0, kAdultP50), 0.90, kTolerance);
  EXPECT_NEAR(saturation(100.0, kAdultP50), 0.975, kTolerance);
  EXPECT_EQ(saturation(0.0, kAdultP50), 0.0);
  EXPECT_EQ(saturation(-5.0, kAdultP50), 0.0);
}

// Severinghaus' equation 2 was fitted by itself, for the pressure from the saturation.
TEST(Oxygen, TheCurveIsUndoneByThePublishedInverse) {
  for (double p = 15.0; p <= 100.0; p += 1.0) {
    const double s = saturation(p, kAdultP50);
    const double back =
        std::exp(0.385 * std::log(1.0 / (1.0 / s - 1.0)) + 3.32 - 1.0 / (72.0 * s) - 0.17 * std::pow(s, 6));
    EXPECT_NEAR(back, p, 0.03 * p) << p;
  }
}

TEST(Oxygen, FetalBloodHoldsMoreAtTheSamePressure) {
  EXPECT_NEAR(saturation(20.5, 20.5), 0.5, 0.001);
  for (double p = 5.0; p < 100.0; p += 5.0) EXPECT_GT(saturation(p, 20.5), saturation(p, kAdultP50)) << p;
}

// Without breaths the store falls by what is used, whatever moves between lungs, arteries and veins.
TEST(Oxygen, InApnoeaTheStoreFallsByTheConsumption) {
  for (const auto& d : {testing::preterm(3), testing::term(3), testing::term(3, Course::delivery_room)}) {
    const Oxygen o = build_infant(d).oxygen;
    OxygenState s = start(o);
    const double full = store_ml(o, s);
    for (int k = 0; k < 300; ++k) use(o, s, 1.0, 0.1);
    ASSERT_GT(s.venous, 0.16);  // enough for all that tissue wants
    EXPECT_NEAR(full - store_ml(o, s), 30.0 * o.consumption_ml_s, 1e-9);
  }
}

TEST(Oxygen, TissueTakesNoMoreThanThereIs) {
  const Oxygen o = build_infant(testing::preterm()).oxygen;
  OxygenState s = start(o);
  for (int k = 0; k < 36000; ++k) {
    use(o, s, 0.3, 0.1);
    ASSERT_GE(s.venous, 0.0);
    ASSERT_GE(s.arterial, 0.0);
    ASSERT_GE(s.alveolar_mmhg[0], 0.0);
    ASSERT_GE(s.alveolar_mmhg[1], 0.0);
  }
}

// The Fick principle at rest: what blood takes up in the lungs is what is used.
TEST(Oxygen, TheStartIsSteady) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Oxygen o = build_infant(testing::preterm(seed)).oxygen;
    const OxygenState s = start(o);
    EXPECT_NEAR(o.flow_ml_s * o.capacity * (s.arterial - s.venous), o.consumption_ml_s, 1e-12 + 1e-9 * o.flow_ml_s);
    double taken = 0.0;
    for (int i = 0; i < kLungUnits; ++i)
      taken += o.flow_ml_s * (1.0 - s.shunt) * o.flow_share[i] * o.capacity *
               (saturation(s.alveolar_mmhg[i], o.p50_mmhg) - s.venous);
    EXPECT_NEAR(taken, o.consumption_ml_s, 1e-9);
  }
}

}  // namespace
}  // namespace vallecula::engine

#include "gui/session/peaks_so_far.h"

#include <gtest/gtest.h>

namespace vallecula::gui::test {
namespace {

TEST(PeaksSoFarTest, NeitherAPauseNorTheWayOnWhichTheBladeIsLedIsTheHands) {
  curricula::LogHeader header;
  header.settings[curricula::kLeadInTicks] = 3;
  const auto tick = [](double tongue_n, bool valid) {
    curricula::LogTick t;
    t.device_valid = valid;
    t.loads[curricula::kTongue].force_n = {0.0, tongue_n, 0.0};
    return t;
  };
  const auto highest = [&](PeaksSoFar peaks) {
    // A pause on the way makes it no shorter.
    for (const auto& [tongue_n, valid] : {std::pair{9.0, true},
                                          {9.0, false},
                                          {8.0, true},
                                          {7.0, true},
                                          {2.0, true},
                                          {6.0, false},
                                          {3.0, true},
                                          {1.0, true}})
      peaks.take(tick(tongue_n, valid));
    return peaks.tongue_n;
  };
  EXPECT_FLOAT_EQ(highest(PeaksSoFar(header)), 3.0f);
  EXPECT_FLOAT_EQ(highest(PeaksSoFar(curricula::LogHeader{})), 9.0f);
}

}  // namespace
}  // namespace vallecula::gui::test

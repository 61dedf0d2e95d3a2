#include "gui/pages/picture_flow.h"

#include <gtest/gtest.h>

namespace vallecula::gui {
namespace {

double pictures(PictureFlow& flow, double from_s, double until_s, double per_second) {
  double at_s = from_s;
  for (int i = 1; at_s < until_s - 1e-9; ++i) flow.came(at_s = from_s + i / per_second);
  return at_s;
}

TEST(PictureFlow, TellsTheRateOfTheLastSecondAndNotOfTheWholeTrial) {
  PictureFlow flow;
  flow.begin(100.0);
  EXPECT_EQ(flow.per_second(), 0.0);
  double now_s = pictures(flow, 100.0, 100.5, 30.0);
  EXPECT_NEAR(flow.per_second(), 30.0, 1e-6) << "before a whole second is over";
  now_s = pictures(flow, now_s, 160.5, 30.0);
  EXPECT_NEAR(flow.per_second(), 30.0, 1e-6);
  now_s = pictures(flow, now_s, now_s + 2.1, 10.0);
  EXPECT_NEAR(flow.per_second(), 10.0, 1.0);
  flow.came(now_s += 60.0);
  EXPECT_LT(flow.per_second(), 0.25) << "one picture in a minute is no 20 a second";
  pictures(flow, now_s, now_s + 1.1, 25.0);
  EXPECT_NEAR(flow.per_second(), 25.0, 1e-6);
}

TEST(PictureFlow, FlowsAgainAfterASecondAndSomePicturesWithoutAGap) {
  PictureFlow flow;
  flow.begin(0.0);
  double now_s = pictures(flow, 0.0, 5.0, 20.0);
  EXPECT_TRUE(flow.flows(now_s));
  EXPECT_EQ(flow.last_gap_s(), 0.0);
  EXPECT_FALSE(flow.flows(now_s + 2.1)) << "none has come since";
  flow.came(now_s += 14.0);
  EXPECT_FALSE(flow.flows(now_s)) << "one picture is no flow";
  EXPECT_NEAR(flow.last_gap_s(), 14.0, 1e-9);
  now_s = pictures(flow, now_s, now_s + 0.8, 20.0);
  EXPECT_FALSE(flow.flows(now_s)) << "one has not looked yet";
  flow.came(now_s += 0.9);
  EXPECT_TRUE(flow.flows(now_s));
  EXPECT_NEAR(flow.last_gap_s(), 14.0, 1e-9) << "a stutter is no gap";
  flow.begin(now_s);
  EXPECT_EQ(flow.last_gap_s(), 0.0);
}

TEST(PictureFlow, OfASlowMachineItFlowsToo) {
  PictureFlow flow;
  flow.begin(0.0);
  flow.came(3.0);
  double now_s = pictures(flow, 3.0, 4.9, 1.5);
  EXPECT_FALSE(flow.flows(now_s));
  now_s = pictures(flow, now_s, now_s + 2.0, 1.5);
  EXPECT_TRUE(flow.flows(now_s)) << "the trial would not be held at this rate, so it is let go at it";
}

}  // namespace
}  // namespace vallecula::gui

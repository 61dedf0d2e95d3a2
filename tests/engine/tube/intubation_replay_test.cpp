// The second half ticked twice, late, live and replayed: the same bits, no allocation, both hands served.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "engine/haptics/runner.h"
#include "tests/engine/allocations.h"
#include "tests/engine/tube/intubation_scene.h"

namespace vallecula::engine {
namespace {

using testing::jamming_scene;
using testing::kBeforeMouth;
using testing::kJammed;
using testing::LateLoop;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

void assert_same(const IntubationRecord& a, const IntubationRecord& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  ASSERT_TRUE(same(a.hand_valid, b.hand_valid) && same(a.in_hand, b.in_hand));
  ASSERT_TRUE(same(a.hand_pose.position, b.hand_pose.position) && same(a.hand_pose.rotation, b.hand_pose.rotation));
  ASSERT_TRUE(same(a.tip_m, b.tip_m) && same(a.tip_direction, b.tip_direction) && same(a.place, b.place));
  ASSERT_TRUE(same(a.past_cords_m, b.past_cords_m) && same(a.at_mouth_m, b.at_mouth_m));
  ASSERT_TRUE(same(a.buckled_m, b.buckled_m) && same(a.model_force_n, b.model_force_n));
  ASSERT_TRUE(same(a.displayed_force_n, b.displayed_force_n) && same(a.loads_n, b.loads_n));
  ASSERT_TRUE(same(a.tip_load_n, b.tip_load_n) && same(a.tip_against, b.tip_against));
  ASSERT_TRUE(same(a.glottis_opening, b.glottis_opening) && same(a.spasm, b.spasm));
  ASSERT_TRUE(same(a.secretions_ml, b.secretions_ml) && same(a.sao2, b.sao2) && same(a.spo2, b.spo2));
  ASSERT_TRUE(same(a.heart_per_min, b.heart_per_min) && same(a.detector_yellow, b.detector_yellow));
  ASSERT_TRUE(same(a.breaths_given, b.breaths_given) && same(a.given_per_min, b.given_per_min));
  ASSERT_TRUE(same(a.faults, b.faults));
}

/// 3.5 s of two hands: the blade's tour, the tube to the cords, which close before it, lost and back, a catheter,
/// breaths, a press, a pose that is none.
SceneDescription toured_scene() {
  SceneDescription d = jamming_scene();
  d.intubation->secretions.volume_m3 = 1e-6;
  d.intubation->press_n = 0.5;
  d.intubation->infant = testing::term();
  d.intubation->glottis.relaxed = false;
  d.intubation->breathes = true;
  return d;
}
constexpr std::int64_t kTourTicks = 3500;
PortInput tour(const Scene& scene, std::int64_t n) {
  const double t = static_cast<double>(n) * 0.001;
  PortInput in;
  in.pose = testing::tour(std::min(t, testing::kTourTime - 0.001));
  in.pose.position.z() += 0.05 * std::max(0.0, 1 - t / 0.2);  // out of the mouth at first
  const auto tip_at = [](double s) -> Vec3 {
    return kBeforeMouth + std::clamp(s, 0.0, 1.0) * (kJammed - kBeforeMouth);
  };
  const double way = t < 2.2 ? (t - 0.3) / 1.5 : 1 - (t - 2.2) / 1.0;
  const bool catheter = n >= 100 && n < 200;
  const InHand what = catheter ? InHand::catheter : n < 2500 ? InHand::tube_with_stylet : InHand::tube;
  in.second_pose = testing::hand_of_tip(scene.intubation->rod(what), tip_at(way));
  if (catheter) in.buttons |= kActionCatheter | kActionSuction;
  if (n < 60) in.buttons |= kActionBreath;
  if (n > 1200 && n < 1800) in.buttons |= kActionPress;
  if (n >= 2500) in.buttons |= kActionStyletOut;
  if (n > 700 && n < 900) in.buttons |= kInstructorSaturationDown | kInstructorHeartUp;
  if (n > 3200) in.buttons |= kInstructorSpasm | kActionEyeRight;
  if (n > 1900 && n < 2000) in.second_valid = false;
  if (n == 2100) in.second_pose.position.y() = kNoNumber;
  if (n == 2110) in.second_pose.rotation.coeffs() *= 3;
  if (n > 2300 && n < 2320) in.valid = false;
  return in;
}

/// What a run of it met: so that none passes by touching nothing.
struct Met {
  double cords_n = 0.0, hand_n = 0.0, opening_low = 1.0, opening_high = 0.0, least_spo2 = 1.0;
  std::uint32_t faults = 0;
  std::int64_t late = 0;
  std::int32_t breaths = 0;
  std::array<bool, 3> held{};
  void add(const TickRecord& record) {
    const IntubationRecord& r = record.intubation;
    cords_n = std::max(cords_n, r.loads_n[static_cast<std::size_t>(AirwayPart::cords)]);
    hand_n = std::max(hand_n, r.displayed_force_n.norm());
    opening_low = std::min(opening_low, r.glottis_opening);
    opening_high = std::max(opening_high, r.glottis_opening);
    least_spo2 = std::min(least_spo2, r.spo2);
    faults |= r.faults;
    late += (record.faults & kFaultOverrun) != 0;
    breaths = std::max(breaths, r.breaths_given);
    held[static_cast<std::size_t>(r.in_hand)] = true;
  }
  void expect_all() const {
    EXPECT_GT(cords_n, 0.1);
    EXPECT_GT(hand_n, 0.1);
    EXPECT_LT(opening_low, 0.3);
    EXPECT_GT(opening_high, 0.5);
    EXPECT_GT(least_spo2, 0.85);  // before the first step has finished as well
    EXPECT_EQ(faults, static_cast<std::uint32_t>(kIntubationFaultHand | kIntubationFaultHandPose));
    EXPECT_EQ(breaths, 1);
    EXPECT_TRUE(held[0] && held[1] && held[2]);
  }
};

TEST(IntubationGuard, TheSameHandsGiveTheSameBitsAndSoDoesReplay) {
  const auto scene = build_scene(toured_scene()), again = build_scene(toured_scene());
  for (const int late : {0, 1, 3}) {
    LateLoop first(*scene, late), second(*again, late);
    Replayer replayer(scene);
    Met met;
    for (std::int64_t n = 0; n < kTourTicks; ++n) {
      const PortInput in = tour(*scene, n);
      const TickRecord r = first.tick(n, in);
      ASSERT_NO_FATAL_FAILURE(assert_same(r.intubation, second.tick(n, in).intubation)) << n << " late by " << late;
      const TickRecord replayed = replayer.replay(r);
      ASSERT_NO_FATAL_FAILURE(assert_same(r.intubation, replayed.intubation)) << n << " replay, late by " << late;
      ASSERT_EQ(std::memcmp(r.displayed_force_n.data(), replayed.displayed_force_n.data(), 24), 0) << n;
      ASSERT_EQ(std::memcmp(r.model_force_n.data(), replayed.model_force_n.data(), 24), 0) << n;
      met.add(r);
    }
    met.expect_all();
    EXPECT_EQ(met.late > 0, late > 1);
    EXPECT_EQ(first.state.tissue.displacement, second.state.tissue.displacement);
    const Snapshot& s = replayer.snapshot();
    EXPECT_TRUE(s.has_intubation);
    EXPECT_EQ(s.tube_axis.back(), first.state.intubation->rod.position.back());
  }
}

TEST(IntubationGuard, ATickAllocatesNothing) {
  const auto scene = build_scene(toured_scene());
  LateLoop loop(*scene);
  Met met;
  const long before = testing::allocations;
  ASSERT_GT(before, 0);
  for (std::int64_t n = 0; n < kTourTicks; ++n) {
    static constexpr int kLate[] = {0, 1, 3};
    loop.late = kLate[n / 40 % 3];
    met.add(loop.tick(n, tour(*scene, n)));
  }
  EXPECT_EQ(testing::allocations - before, 0);
  met.expect_all();
}

/// Records what is written to either hand.
class TwoHandPort final : public HapticPort {
 public:
  explicit TwoHandPort(const Scene& scene) : scene_(scene) {}
  PortInput read(double) noexcept override { return tour(scene_, std::min(n_++, kTourTicks - 1)); }
  void write(const Vec3&) noexcept override { ++written; }
  void write_second(const Vec3& force) noexcept override {
    ++second_written;
    strongest = std::max(strongest, force.norm());
    last = force;
  }
  std::int64_t written = 0, second_written = 0;
  double strongest = 0.0;
  Vec3 last = Vec3::Zero();

 private:
  const Scene& scene_;
  std::int64_t n_ = 0;
};

TEST(IntubationGuard, TheRunnerServesBothHandsAndItsRecordsReplay) {
  const auto scene = build_scene(toured_scene());
  TwoHandPort port(*scene);
  Runner runner(scene, port);
  Replayer replayer(scene);
  Met met;
  runner.run(kTourTicks, [&](const TickRecord& r) {
    met.add(r);
    ASSERT_NO_FATAL_FAILURE(assert_same(r.intubation, replayer.replay(r).intubation)) << r.tick;
  });
  met.expect_all();
  EXPECT_EQ(port.written, kTourTicks);
  EXPECT_EQ(port.second_written, kTourTicks);
  EXPECT_EQ(port.strongest, met.hand_n);
  EXPECT_FALSE(runner.ticks_before_fault().empty());  // the pose that is none
}

TEST(IntubationRealTime, LiveRecordsReplayAndBothHandsEndWithoutForce) {
  const auto scene = build_scene(toured_scene());
  TwoHandPort port(*scene);
  Runner runner(scene, port);
  Replayer replayer(scene);
  runner.start();
  Met met;
  TickRecord r;
  for (std::int64_t seen = 0; seen < 2400;) {
    if (!runner.pop(r)) continue;
    ++seen;
    met.add(r);
    ASSERT_NO_FATAL_FAILURE(assert_same(r.intubation, replayer.replay(r).intubation)) << r.tick;
  }
  runner.stop();
  EXPECT_GT(met.hand_n, 0.1);
  EXPECT_TRUE(port.last.isZero(0));
  EXPECT_GT(port.second_written, 2400);
  EXPECT_TRUE(runner.latest().has_intubation);
}

}  // namespace
}  // namespace vallecula::engine

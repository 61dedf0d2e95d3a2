// What every tick must keep, whatever the scene has: no allocation, the same bits from the same inputs, and a tissue
// that went wrong is named, felt by nobody, and whole again.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "engine/haptics/runner.h"
#include "tests/engine/allocations.h"
#include "tests/engine/mouth_scene.h"

namespace vallecula::engine {
namespace {

using testing::LateLoop;

constexpr std::int64_t kTourTicks = static_cast<std::int64_t>(1000 * testing::kTourTime);

PortInput hand_at(const Pose& pose) {
  PortInput in;
  in.pose = pose;
  return in;
}

/// What a run of the tour met: so that none of it passes by touching nothing.
struct Met {
  double tongue_n = 0.0, gum_n = 0.0, lip_n = 0.0, jaw_rad = 0.0, held_pa = 0.0, least_seen = 1.0, most_seen = 0.0;
  std::int64_t late = 0;

  void add(const TickRecord& r, const SceneState& state) {
    tongue_n = std::max(tongue_n, r.loads[static_cast<int>(Structure::tongue)].force_n.norm());
    gum_n = std::max(gum_n, r.loads[static_cast<int>(Structure::gum)].force_n.norm());
    lip_n = std::max(lip_n, state.lips.wrench.force.norm());
    jaw_rad = std::max(jaw_rad, std::abs(state.tissue.body_displacement[testing::kMouthJaw].x()));
    held_pa = std::max(held_pa, std::abs(state.tissue.held_pressure));
    late += (r.faults & kFaultOverrun) != 0;
    if (r.loads[static_cast<int>(Structure::tongue)].contacts > 0 || !r.has_sight) return;
    least_seen = std::min(least_seen, r.glottis_visible);  // the blade is far from the line of sight
    most_seen = std::max(most_seen, r.glottis_visible);
  }
  void expect_all() const {
    EXPECT_GT(tongue_n, 0.5);
    EXPECT_GT(gum_n, 0.5);
    EXPECT_GT(lip_n, 0.3);
    EXPECT_GT(jaw_rad, 0.021);  // past its stop
    EXPECT_GT(held_pa, 10.0);
    EXPECT_GT(most_seen - least_seen, 0.05);
  }
};

// Servo ticks whose step is late predict it, and that path too must make none.
TEST(Scene, ATickAllocatesNothing) {
  const auto scene = build_scene(testing::mouth_scene());
  LateLoop loop(*scene);
  Met met;
  const long before = testing::allocations;
  ASSERT_GT(before, 0);  // it counts: the scene was built
  for (std::int64_t n = 0; n < kTourTicks; ++n) {
    static constexpr int kLate[] = {0, 1, 3};
    loop.late = kLate[n / 40 % 3];
    met.add(loop.tick(n, hand_at(testing::tour(static_cast<double>(n) * 0.001))), loop.state);
  }
  EXPECT_EQ(testing::allocations - before, 0);
  met.expect_all();
  EXPECT_GT(met.late, kTourTicks / 6);
}

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof(T) * a.size()), 0);
}

void assert_same_bits(const TickRecord& a, const TickRecord& b) {
  ASSERT_EQ(std::memcmp(a.proxy_pose.position.data(), b.proxy_pose.position.data(), 24), 0) << a.tick;
  ASSERT_EQ(std::memcmp(a.proxy_pose.rotation.coeffs().data(), b.proxy_pose.rotation.coeffs().data(), 32), 0) << a.tick;
  ASSERT_EQ(std::memcmp(a.model_force_n.data(), b.model_force_n.data(), 24), 0) << a.tick;
  ASSERT_EQ(std::memcmp(a.model_torque_nm.data(), b.model_torque_nm.data(), 24), 0) << a.tick;
  ASSERT_EQ(std::memcmp(a.displayed_force_n.data(), b.displayed_force_n.data(), 24), 0) << a.tick;
  for (int s = 0; s < kLoadedStructures; ++s)
    ASSERT_EQ(std::memcmp(a.loads[s].force_n.data(), b.loads[s].force_n.data(), 24), 0) << a.tick;
  ASSERT_EQ(a.state, b.state) << a.tick;
  ASSERT_EQ(a.glottis_visible, b.glottis_visible) << a.tick;
  ASSERT_EQ(a.has_sight, b.has_sight) << a.tick;
  ASSERT_EQ(a.faults, b.faults) << a.tick;
}

TEST(Scene, TheSameHandGivesTheSameBitsAndSoDoesReplay) {
  const auto scene = build_scene(testing::mouth_scene()), again = build_scene(testing::mouth_scene());
  for (const int late : {0, 1, 3}) {
    LateLoop first(*scene, late), second(*again, late);
    Replayer replayer(scene);
    Met met;
    for (std::int64_t n = 0; n < kTourTicks; ++n) {
      const PortInput in = hand_at(testing::tour(static_cast<double>(n) * 0.001));
      const TickRecord r = first.tick(n, in);
      ASSERT_NO_FATAL_FAILURE(assert_same_bits(r, second.tick(n, in))) << "late by " << late;
      ASSERT_NO_FATAL_FAILURE(assert_same_bits(r, replayer.replay(r))) << "replay, late by " << late;
      met.add(r, first.state);
    }
    expect_same_bits(first.state.tissue.displacement, second.state.tissue.displacement);
    expect_same_bits(first.state.tissue.body_displacement, second.state.tissue.body_displacement);
    expect_same_bits(first.state.lips.displacement, second.state.lips.displacement);
    met.expect_all();
    EXPECT_EQ(met.late > 0, late > 1);
  }
}

TEST(Scene, ReplayIsBitIdentical) {
  class TourPort final : public HapticPort {
   public:
    PortInput read(double t) noexcept override { return hand_at(testing::tour(t)); }
    void write(const Vec3&) noexcept override {}
  } port;
  const auto scene = build_scene(testing::mouth_scene());
  Runner runner(scene, port);
  Replayer replayer(scene);
  double gum = 0.0;
  runner.run(kTourTicks, [&](const TickRecord& r) {
    ASSERT_NO_FATAL_FAILURE(assert_same_bits(r, replayer.replay(r)));
    gum = std::max(gum, r.loads[static_cast<int>(Structure::gum)].force_n.norm());
  });
  EXPECT_GT(gum, 0.5);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Poison {
  const char* what;
  Vec3 top;
  double depth;
  std::function<void(TissueState&)> add;
};

/// Brings the hand down and holds it; the last record.
TickRecord press(LateLoop& loop, std::int64_t& n, const Poison& where) {
  TickRecord last;
  for (int i = 0; i < 400; ++i, ++n) last = loop.tick(n, hand_at(testing::press_on(where.top, where.depth, i * 0.001)));
  return last;
}

// Tissue that became non-finite under load, with the limit near and the volume held: the step says so, nothing of it is
// felt, and the scene goes on as if new.
TEST(Scene, TissueThatIsNotFiniteIsNamedNotFeltAndWholeAgain) {
  const auto displacement = [](TissueState& t) { t.displacement[t.displacement.size() / 2].z() = kNan; };
  const Poison poisons[] = {
      {"a displacement, tongue", testing::kTongueTop, 0.006, displacement},
      {"all displacements, tongue", testing::kTongueTop, 0.006,
       [](TissueState& t) { std::fill(t.displacement.begin(), t.displacement.end(), Vec3::Constant(kNan)); }},
      {"the jaw's angle, gum", testing::kGumTop, 0.003,
       [](TissueState& t) { t.body_displacement[testing::kMouthJaw].x() = kNan; }},
      {"a displacement, lip", testing::kLipTop, 0.003, displacement},
  };
  for (const Poison& poison : poisons) {
    SCOPED_TRACE(poison.what);
    SceneDescription d = testing::mouth_scene();
    if (poison.top == testing::kTongueTop) d.haptics.device_limit_n = 1.5;
    const auto scene = build_scene(d);
    LateLoop loop(*scene);
    std::int64_t n = 0;
    const TickRecord pressed = press(loop, n, poison);
    std::printf("%s: %.3f N, held by %.0f Pa\n", poison.what, pressed.model_force_n.norm(),
                loop.state.tissue.held_pressure);
    ASSERT_EQ(pressed.faults, kFaultNone);
    ASSERT_EQ(pressed.state, HapticState::tracking);
    ASSERT_GT(pressed.displayed_force_n.norm(), 0.3);
    if (poison.top == testing::kTongueTop) {
      ASSERT_GT(pressed.model_force_n.norm(), 0.6 * d.haptics.device_limit_n);
      ASSERT_GT(std::abs(loop.state.tissue.held_pressure), 10.0);
    }
    poison.add(loop.state.tissue);
    const TickRecord faulty = loop.tick(n++, hand_at(testing::press_on(poison.top, poison.depth, 0.4)));
    EXPECT_NE(faulty.faults & kFaultTissue, 0u);
    EXPECT_EQ(faulty.displayed_force_n.norm(), 0.0);
    EXPECT_EQ(faulty.model_force_n.norm(), 0.0);
    for (int i = 0; i < 1500; ++i) {  // still pressed for 0.1 s, then drawn out and kept away
      const TickRecord r = loop.tick(n++, hand_at(testing::press_on(poison.top, poison.depth, 0.3 + i * 0.001)));
      ASSERT_EQ(r.faults, kFaultNone) << "step " << i << " after the fault";
      ASSERT_TRUE(r.model_force_n.allFinite() && r.displayed_force_n.allFinite());
      ASSERT_LE(r.displayed_force_n.norm(), d.haptics.device_limit_n * (1 + 1e-9));
    }
    double farthest = 0.0, fastest = 0.0;
    for (const Vec3& u : loop.state.tissue.displacement) farthest = std::max(farthest, u.norm());
    for (const Vec3& v : loop.state.tissue.velocity) fastest = std::max(fastest, v.norm());
    std::printf("  after: %.2g m, %.2g m/s\n", farthest, fastest);
    EXPECT_LT(farthest, 1e-5);
    EXPECT_LT(fastest, 1e-4);
    double drawn = 0.0;
    for (const Vec3& u : loop.state.lips.displacement) drawn = std::max(drawn, u.norm());
    EXPECT_LT(drawn, 1e-4);
    LateLoop fresh(*scene);
    std::int64_t first = 0;
    const TickRecord anew = press(loop, n, poison), never = press(fresh, first, poison);
    std::printf("  pressed anew %.4f N, never faulty %.4f N\n", anew.model_force_n.norm(), never.model_force_n.norm());
    EXPECT_EQ(anew.faults, kFaultNone);
    EXPECT_NEAR(anew.model_force_n.norm(), never.model_force_n.norm(), 0.01 * never.model_force_n.norm());
    EXPECT_NEAR(anew.displayed_force_n.norm(), never.displayed_force_n.norm(), 0.01 * never.displayed_force_n.norm());
  }
}

}  // namespace
}  // namespace vallecula::engine

// What every tick must keep, whatever the scene has: no allocation, and the same bits from the same inputs.
#include <gtest/gtest.h>

#include <cstring>

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

}  // namespace
}  // namespace vallecula::engine

// The Falcon as a trial drives it, through the guard: what reaches the motors while servo and device fail.
#include <atomic>
#include <random>

#include "device/guarded_device.h"
#include "tests/device/drivers/falcon_bed_umockdev.h"

namespace vallecula::device {
namespace {

class FalconGuardUmockdev : public FalconUmockdev {
 protected:
  /// A command as it came, and how many ticks of the servo were over then.
  struct Heard {
    std::array<int, 3> motors{};
    long ticks = 0;
  };

  /// The force that motors give, by the motors of three unit forces (Cramer).
  struct Motors {
    explicit Motors(const Vector& at)
        : x(motors_for(at, {1, 0, 0})), y(motors_for(at, {0, 1, 0})), z(motors_for(at, {0, 0, 1})) {}
    Vector force(const std::array<int, 3>& motors) const {
      const Vector m{static_cast<double>(motors[0]), static_cast<double>(motors[1]), static_cast<double>(motors[2])};
      const auto inner = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
      const double whole = inner(x, cross(y, z));
      return {inner(m, cross(y, z)) / whole, inner(x, cross(m, z)) / whole, inner(x, cross(y, m)) / whole};
    }
    Vector x, y, z;
  };

  void servo_tick(GuardedDevice& guard, const Vector& wanted) {
    guard.read(since(begin_));
    guard.see_tool({0, 0, 0}, {1, 0, 0, 0});
    sent_n_.push_back(length(guard.write(wanted)));
    ticks_ = static_cast<long>(sent_n_.size());
    if (guard.state() == GuardState::confirming) guard.confirm();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  bool servo_until(GuardedDevice& guard, const Vector& wanted, const std::function<bool()>& condition) {
    return wait_for([&] {
      servo_tick(guard, wanted);
      return condition();
    });
  }

  std::vector<double> sent_n_;  ///< by tick
  std::atomic<long> ticks_{0};
};

/// However servo and device fail, no command shows more than the guard sent about that time (nothing, while it
/// pauses), and force rises no faster than chain and ramp let it. Both are counted in ticks: no clock is asked.
TEST_F(FalconGuardUmockdev, ForceRisesSoftlyAfterWhateverWithheldIt) {
  open_homed();
  const Motors scale_of(device_->read(0.0).position_m);
  const GuardSettings settings = guard_for(device_->info());
  GuardedDevice guard(*device_, settings);
  std::vector<Heard> heard;
  mock_->listen([&](const std::array<int, 3>& motors) { heard.push_back({motors, ticks_.load()}); });
  std::mt19937 random(23);
  const auto component = [&] { return (static_cast<double>(random() % 2001) - 1000.0) / 250.0; };
  int late = 0, lost = 0, not_calibrated = 0;
  for (int round = 0; round < 15; ++round) {
    Vector wanted{0, 0, 0};
    while (length(wanted) < 3.0) wanted = {component(), component(), component()};
    ASSERT_TRUE(servo_until(guard, wanted, [&] { return guard.state() == GuardState::working; }));
    // The soft start lasts half a second.
    const long before = ticks_;
    ASSERT_TRUE(servo_until(guard, wanted, [&] { return ticks_ > before + 300 && !motors_zero(); }));
    switch (round % 5) {
      case 0:  // the servo stands still
        std::this_thread::sleep_for(std::chrono::milliseconds(120));
        servo_tick(guard, wanted);
        EXPECT_EQ(guard.state(), GuardState::paused);
        late += guard.fault() == DeviceFault::servo_late;
        break;
      case 1:
        mock_->set([](FalconFaults& f) { f.silent = true; });
        ASSERT_TRUE(servo_until(guard, wanted, [&] { return guard.state() == GuardState::paused; }));
        lost += guard.fault() == DeviceFault::communication_lost;
        break;
      case 2:  // held back as no hand's: no fault
        mock_->set([](FalconFaults& f) { f.flipped_packets = 2; });
        for (int i = 0; i < 20; ++i) servo_tick(guard, wanted);
        break;
      case 3:  // beyond what one exchange waits, but no fault yet
        mock_->set([](FalconFaults& f) { f.late_ms = 15; });
        for (int i = 0; i < 20; ++i) servo_tick(guard, wanted);
        break;
      default:
        mock_->home(false);
        ASSERT_TRUE(servo_until(guard, wanted, [&] { return guard.state() == GuardState::paused; }));
        not_calibrated += guard.fault() == DeviceFault::not_calibrated;
        mock_->home();
    }
    mock_->set([](FalconFaults& f) { f = {}; });
  }
  guard.let_go();
  device_.reset();
  mock_->listen({});
  EXPECT_GT(late, 0);
  EXPECT_GT(lost, 0);
  EXPECT_GT(not_calibrated, 0);

  const double step_n = settings.limits.rate_n_s * settings.limits.period_s, ramp_n = falcon::kPeakForce / 100.0;
  constexpr double kRounding = 0.03;  // of the motors to whole units and the grip's place to counts
  long with_force = 0;
  double largest_n = 0.0;
  for (std::size_t k = 2; k < heard.size(); ++k) {
    // It was read after the command before had come, and before it came itself.
    double most_n = 0.0;
    for (long n = std::max(1L, heard[k - 1].ticks); n <= heard[k].ticks + 1 && n <= static_cast<long>(sent_n_.size());
         ++n)
      most_n = std::max(most_n, sent_n_[static_cast<std::size_t>(n - 1)]);
    const Vector now = scale_of.force(heard[k].motors), before = scale_of.force(heard[k - 1].motors);
    ASSERT_LE(length(now), most_n + kRounding) << k;
    // It may have fallen in between, so that it rises from nothing.
    const double rise_n = std::min(length(now), length(subtract(now, before)));
    const double ticks = static_cast<double>(heard[k].ticks + 1 - heard[k - 2].ticks);
    ASSERT_LE(rise_n, step_n * ticks + ramp_n + kRounding) << k << " of " << heard.size();
    largest_n = std::max(largest_n, length(now));
    with_force += length(now) > 1.0;
  }
  EXPECT_GT(with_force, 1000);
  EXPECT_GT(largest_n, 2.5);
}

}  // namespace
}  // namespace vallecula::device

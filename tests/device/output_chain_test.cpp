#include "device/output_chain.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "device/rotation.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Keeps what it was told.
class Ear final : public HapticDevice {
 public:
  DeviceInfo info() const override { return {}; }
  DeviceReading read(double) noexcept override { return {}; }
  void write(const std::array<double, 3>& force_n) noexcept override { heard = force_n, ++writes; }
  DeviceFault fault() const noexcept override { return DeviceFault::none; }
  Vector heard{0, 0, 0};
  int writes = 0;
};

TEST(OutputChain, LimitsHoldUnderRandomInput) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), exponent(-3.0, 300.0), choice(0.0, 1.0);
  for (const OutputLimits limits :
       {OutputLimits{}, OutputLimits{3.3, 50.0, 30.0, 0.001}, OutputLimits{7.9, 1e6, 400.0, 0.001},
        OutputLimits{7.9, 400.0, 200.0, 0.001, 1.75, 0.05, 0.01}}) {
    OutputChain chain(limits);
    Ear ear;
    for (int i = 0; i < 20000; ++i) {
      const double size = choice(random) < 0.5 ? 10.0 : std::pow(10.0, exponent(random));
      Vector force{size * unit(random), size * unit(random), size * unit(random)};
      const bool broken = choice(random) < 0.02;
      if (broken) force[static_cast<std::size_t>(i % 3)] = i % 2 == 0 ? kNoNumber : kInfinity;
      const Vector before = chain.last_sent_n();
      const Vector sent = chain.send(ear, force);
      ASSERT_EQ(sent, ear.heard);
      ASSERT_TRUE(finite(sent));
      ASSERT_LE(length(sent), limits.peak_force_n);
      // Rounding of the difference of two forces of a few newtons: 1e-12 N is a thousand times that.
      const double step = length(subtract(sent, before));
      const bool zeroed = sent == Vector{0, 0, 0};
      ASSERT_TRUE(zeroed || step <= limits.rate_n_s * limits.period_s + 1e-12) << step;
      if (broken) {
        ASSERT_EQ(sent, (Vector{0, 0, 0}));
      }
    }
    EXPECT_EQ(ear.writes, 20000);
  }
}

TEST(OutputChain, NotANumberIsZeroForceAndAFaultThatStays) {
  for (const double bad : {kNoNumber, kInfinity, -kInfinity}) {
    OutputChain chain(OutputLimits{});
    Ear ear;
    for (int i = 0; i < 300; ++i) chain.send(ear, {2, 0, 0});
    ASSERT_NEAR(ear.heard[0], 2.0, 1e-6);
    EXPECT_EQ(chain.fault(), DeviceFault::none);
    chain.send(ear, {2, bad, 0});
    EXPECT_EQ(ear.heard, (Vector{0, 0, 0}));
    EXPECT_EQ(chain.fault(), DeviceFault::non_finite_command);
    chain.send(ear, {2, 0, 0});
    EXPECT_GT(ear.heard[0], 0.0);
    EXPECT_LE(ear.heard[0], 0.4 + 1e-12);  // 400 N/s for a millisecond, from zero
    EXPECT_EQ(chain.fault(), DeviceFault::non_finite_command);
    chain.reset();
    EXPECT_EQ(chain.fault(), DeviceFault::none);
    EXPECT_EQ(chain.last_sent_n(), (Vector{0, 0, 0}));
  }
}

TEST(OutputChain, ReachesAConstantForceAndLeavesTheLimitAtOnce) {
  OutputChain chain(OutputLimits{});
  Ear ear;
  for (int i = 0; i < 1000; ++i) chain.send(ear, {0, 1000, 0});
  EXPECT_NEAR(ear.heard[1], 7.9, 1e-12);
  chain.send(ear, {0, 0, 0});  // nothing has built up behind the clamp
  EXPECT_NEAR(ear.heard[1], 7.9 - 0.4, 1e-9);
}

TEST(OutputChain, LowPassHasItsCutoff) {
  // Gain of y += a (x - y) at f: a / |1 - (1-a) e^{-i w T}|; the property is measured, not computed the same way.
  const OutputLimits limits{100.0, 1e9, 50.0, 0.001};
  OutputChain chain(limits);
  Ear ear;
  double largest = 0.0;
  for (int i = 0; i < 4000; ++i) {
    chain.send(ear, {std::sin(2.0 * M_PI * 50.0 * i * 0.001), 0, 0});
    if (i > 2000) largest = std::max(largest, std::abs(ear.heard[0]));
  }
  EXPECT_NEAR(largest, std::sqrt(0.5), 0.03);  // -3 dB; sampling at 20 points a period shifts it by up to 3 %
}

TEST(OutputChain, NoLimitCanBeSwitchedOff) {
  for (const OutputLimits bad :
       {OutputLimits{kInfinity, 400, 200, 0.001}, OutputLimits{kNoNumber, 400, 200, 0.001},
        OutputLimits{-1, 400, 200, 0.001}, OutputLimits{7.9, kInfinity, 200, 0.001}, OutputLimits{7.9, 0, 200, 0.001},
        OutputLimits{7.9, 400, 0, 0.001}, OutputLimits{7.9, 400, 500, 0.001}, OutputLimits{7.9, 400, kNoNumber, 0.001},
        OutputLimits{7.9, 400, 200, 0}, OutputLimits{7.9, 400, 200, -0.001}, OutputLimits{7.9, 400, 200, 0.001, -1},
        OutputLimits{7.9, 400, 200, 0.001, kInfinity}, OutputLimits{7.9, 400, 200, 0.001, 1.75, 0},
        OutputLimits{7.9, 400, 200, 0.001, 1.75, kInfinity}, OutputLimits{7.9, 400, 200, 0.001, 1.75, 60, 0},
        OutputLimits{7.9, 400, 200, 0.001, 1.75, 60, kNoNumber}, OutputLimits{7.9, 400, 200, 0.001, 1.75, 60, 0.5, 0},
        OutputLimits{7.9, 400, 200, 0.001, 1.75, 60, 0.5, 1.01}}) {
    EXPECT_THROW(OutputChain{bad}, std::invalid_argument);
  }
}

/// h' = (F(h)^2 - h) / tau with F falling from the peak to the continuous force between 0.8 and 1 of its square: by
/// Runge and Kutta in steps of a fifth of a tick.
double warmth_of_pressing(const OutputLimits& limits, double seconds) {
  const double full = limits.continuous_force_n * limits.continuous_force_n;
  const auto slope = [&](double h) {
    const double left = std::min(1.0, (1.0 - h / full) / 0.2);
    const double force = limits.continuous_force_n + (limits.peak_force_n - limits.continuous_force_n) * left;
    return (force * force - h) / limits.thermal_time_s;
  };
  double h = 0.0;
  const double dt = 0.0002;
  for (int i = 0; i < static_cast<int>(seconds / dt + 0.5); ++i) {
    const double a = slope(h), b = slope(h + 0.5 * dt * a), c = slope(h + 0.5 * dt * b), d = slope(h + dt * c);
    h += dt / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return h / full;
}

TEST(OutputChain, PeakForShortContinuousForLong) {
  OutputLimits limits;
  limits.continuous_force_n = 1.75;
  limits.soft_start_s = 0.001;  // the ramp is not what is looked at
  limits.rate_n_s = 1e5;
  OutputChain chain(limits);
  Ear ear;
  double t_peak_s = 0.0, largest_step = 0.0, before = 0.0;
  for (int i = 1; i <= 400000; ++i) {
    chain.send(ear, {0, 1000, 0});
    const double sent = ear.heard[1];
    if (sent > 7.9 - 1e-9) t_peak_s = i * 0.001;
    if (i > 10) largest_step = std::max(largest_step, std::abs(sent - before));
    before = sent;
    ASSERT_LE(chain.warmth(), 1.0 + 1e-12);
    if (i % 1000 == 0 && i <= 20000) {
      // A tick of 1 ms against the exact curve: 1e-3 of the warmth is a tick's worth at the peak (20.4 / 60 / 1000)
      // thrice over.
      ASSERT_NEAR(chain.warmth(), warmth_of_pressing(limits, i * 0.001), 1e-3) << i;
    }
    if (i == 2000) {  // still at the peak: 1 - exp(-t / tau)
      ASSERT_NEAR(chain.warmth(), 7.9 * 7.9 / (1.75 * 1.75) * (1.0 - std::exp(-2.0 / 60.0)), 1e-3);
    }
  }
  EXPECT_NEAR(t_peak_s, -60.0 * std::log(1.0 - 0.8 * 1.75 * 1.75 / (7.9 * 7.9)), 0.005);
  EXPECT_LT(largest_step, 0.02) << "it falls smoothly";
  EXPECT_NEAR(ear.heard[1], 1.75, 0.01);

  const double warm = chain.warmth();
  for (int i = 0; i < 60000; ++i) chain.stop(ear);
  EXPECT_NEAR(chain.warmth(), warm * std::exp(-1.0), 1e-3);
  EXPECT_EQ(ear.heard, (Vector{0, 0, 0}));
}

TEST(OutputChain, AContinuousForceOfTheDevicesOwnWarmthIsHeeded) {
  class Warm final : public HapticDevice {
   public:
    DeviceInfo info() const override { return {}; }
    DeviceReading read(double) noexcept override { return {}; }
    void write(const std::array<double, 3>& force_n) noexcept override { heard = force_n; }
    DeviceFault fault() const noexcept override { return DeviceFault::none; }
    double motor_warmth() const noexcept override { return warmth; }
    Vector heard{0, 0, 0};
    double warmth = 0.0;
  } warm;
  OutputLimits limits;
  limits.continuous_force_n = 2.0;
  OutputChain chain(limits);
  for (int i = 0; i < 1000; ++i) chain.send(warm, {0, 0, 7.9});
  EXPECT_NEAR(warm.heard[2], 7.9, 1e-9);
  warm.warmth = 1.0;  // at once: the force falls, but within the rate limit
  double before = warm.heard[2];
  for (int i = 0; i < 100; ++i) {
    chain.send(warm, {0, 0, 7.9});
    ASSERT_LE(std::abs(warm.heard[2] - before), 0.4 + 1e-12);
    before = warm.heard[2];
  }
  EXPECT_NEAR(warm.heard[2], 2.0, 1e-9);
}

TEST(OutputChain, SoftStartRampsAtTheFirstContactNotBefore) {
  OutputChain chain(OutputLimits{});
  Ear ear;
  for (int i = 0; i < 3000; ++i) chain.send(ear, {0, 0, 0});  // three seconds in the air do not use it up
  for (int i = 1; i <= 600; ++i) {
    chain.send(ear, {0, 5, 0});
    ASSERT_LE(ear.heard[1], 7.9 * i / 500.0 + 1e-12);
  }
  EXPECT_NEAR(ear.heard[1], 5.0, 1e-6);
  chain.soften();  // no step: it falls and grows again
  double before = 5.0, least = 5.0;
  for (int i = 1; i <= 600; ++i) {
    chain.send(ear, {0, 5, 0});
    ASSERT_LE(std::abs(ear.heard[1] - before), 0.4 + 1e-12);
    before = ear.heard[1];
    least = std::min(least, before);
  }
  EXPECT_LT(least, 1.0);
  EXPECT_NEAR(ear.heard[1], 5.0, 1e-6);
}

TEST(OutputChain, ScalesTheForceAsStated) {
  OutputLimits limits;
  limits.peak_force_n = 3.3;
  limits.force_scale = 0.4;
  OutputChain chain(limits);
  Ear ear;
  for (int i = 0; i < 1000; ++i) chain.send(ear, {5, 0, 0});
  EXPECT_NEAR(ear.heard[0], 2.0, 1e-9);
}

TEST(OutputChain, ADeviceWithoutForceGetsNone) {
  OutputChain chain(OutputLimits{0.0, 400, 200, 0.001});
  Ear ear;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(chain.send(ear, {1, 2, 3}), (Vector{0, 0, 0}));
}

TEST(OutputChain, AllocatesNothing) {
  OutputChain chain(OutputLimits{});
  Ear ear;
  const long long before = testing::allocations();
  for (int i = 0; i < 1000; ++i) chain.send(ear, {i * 0.01, i % 7 == 0 ? kNoNumber : 0.0, 1});
  EXPECT_EQ(testing::allocations(), before);
}

}  // namespace
}  // namespace vallecula::device

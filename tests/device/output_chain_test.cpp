#include "device/output_chain.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "device/rotation.h"
#include "tests/device/allocation_guard.h"

namespace vallecula::device {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
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
       {OutputLimits{}, OutputLimits{3.3, 50.0, 30.0, 0.001}, OutputLimits{7.9, 1e6, 400.0, 0.001}}) {
    OutputChain chain(limits);
    Ear ear;
    for (int i = 0; i < 20000; ++i) {
      const double size = choice(random) < 0.5 ? 10.0 : std::pow(10.0, exponent(random));
      Vector force{size * unit(random), size * unit(random), size * unit(random)};
      const bool broken = choice(random) < 0.02;
      if (broken) force[static_cast<std::size_t>(i % 3)] = i % 2 == 0 ? kNan : kInfinity;
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
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    OutputChain chain(OutputLimits{});
    Ear ear;
    for (int i = 0; i < 100; ++i) chain.send(ear, {2, 0, 0});
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
       {OutputLimits{kInfinity, 400, 200, 0.001}, OutputLimits{kNan, 400, 200, 0.001},
        OutputLimits{-1, 400, 200, 0.001}, OutputLimits{7.9, kInfinity, 200, 0.001}, OutputLimits{7.9, 0, 200, 0.001},
        OutputLimits{7.9, 400, 0, 0.001}, OutputLimits{7.9, 400, 500, 0.001}, OutputLimits{7.9, 400, kNan, 0.001},
        OutputLimits{7.9, 400, 200, 0}, OutputLimits{7.9, 400, 200, -0.001}}) {
    EXPECT_THROW(OutputChain{bad}, std::invalid_argument);
  }
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
  for (int i = 0; i < 1000; ++i) chain.send(ear, {i * 0.01, i % 7 == 0 ? kNan : 0.0, 1});
  EXPECT_EQ(testing::allocations(), before);
}

}  // namespace
}  // namespace vallecula::device

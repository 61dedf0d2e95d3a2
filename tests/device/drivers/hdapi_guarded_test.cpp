// The whole way of a force to a Touch, guard and driver: no stall of either loop, and no error, jerks the hand.
#include <random>

#include "device/guarded_device.h"
#include "device/rotation.h"
#include "tests/device/drivers/hdapi_fixture.h"

namespace vallecula::device::hdapi {
namespace {

using namespace std::chrono_literals;

using HdapiGuarded = HdapiTest;

/// Either loop stalls, the trial's catches up in a burst, the library reports errors, the scene asks for anything.
TEST_F(HdapiGuarded, AMillionTurnsWithStallsAndFaultsNeverJerkTheHand) {
  const auto device = open_by_hand();
  const GuardSettings settings = guard_for(device->info());
  GuardedDevice guard(*device, settings);
  const double step_n = settings.limits.rate_n_s * settings.limits.period_s;
  const unsigned int codes[] = {0x200, 0x201, 0x202, 0x203, 0x204, 0x300, 0x302, 0x304, 0x501, 0x600};
  std::mt19937_64 random(13);
  const auto chance = [&](double p) { return static_cast<double>(random() >> 11) * 0x1.0p-53 < p; };
  const auto number = [&](double size) { return size * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0); };
  Vector force{0, 0, 0}, before{0, 0, 0}, sent{0, 0, 0};
  long long ticks = 0;
  int turned = 0, stalled = 0, pauses = 0, late = 0, with_force = 0, spread = 0, cut = 0;
  bool was_quiet = false;
  while (turned < 1000000) {
    int due = 1;
    if (stalled > 0) {
      due = --stalled == 0 ? 5 : 0;  // it catches up
    } else if (chance(0.001)) {
      stalled = 1 + static_cast<int>(random() % 80);
    } else if (chance(0.001)) {
      due = 1 + static_cast<int>(random() % 60);  // the library's loop stalls
    }
    if (chance(0.0003)) hd.error(0, codes[random() % std::size(codes)]);
    if (chance(0.005)) force = chance(0.2) ? Vector{0, 0, 0} : Vector{number(6), number(6), number(6)};
    for (int i = 0; i < due; ++i) {
      if (chance(0.01)) guard.confirm();
      guard.read(1e-3 * static_cast<double>(ticks++));
      guard.see_tool({0, 0, 0}, {1, 0, 0, 0});
      sent = guard.write(force);
    }
    if (hd.turn(1) == 0) {  // the driver is reopening the device
      std::this_thread::sleep_for(1ms);
      continue;
    }
    ++turned;
    const Vector given = hd.given(0);
    const double change = length(subtract(given, before));
    const bool zeroed = given == Vector{0, 0, 0};
    const bool quiet = guard.state() == GuardState::paused || guard.state() == GuardState::confirming;
    const DeviceFault fault = device->fault();
    ASSERT_LE(length(given), settings.limits.peak_force_n);
    ASSERT_TRUE(zeroed || change <= step_n + 1e-12) << turned << ": " << change << " N";
    ASSERT_TRUE(zeroed || !quiet) << turned;
    // Only a fault cuts the force off.
    ASSERT_TRUE(change <= step_n + 1e-12 || quiet || fault != DeviceFault::none) << turned << ": " << change << " N";
    pauses += quiet && !was_quiet ? 1 : 0;
    late += quiet && !was_quiet && guard.fault() == DeviceFault::servo_late ? 1 : 0;
    with_force += length(given) > 0.5 ? 1 : 0;
    spread += !zeroed && length(subtract(sent, given)) > step_n ? 1 : 0;
    cut += change > step_n + 1e-12 ? 1 : 0;
    was_quiet = quiet;
    before = given;
  }
  // All of it happened.
  EXPECT_GT(pauses, 200);
  EXPECT_GT(late, 100);
  EXPECT_GT(cut, 100);
  EXPECT_GT(spread, 100);
  EXPECT_GT(with_force, 100000);
}

}  // namespace
}  // namespace vallecula::device::hdapi

// vallecula_falcon_bench [TICKS]: what one tick of the Falcon's driver costs the servo thread (read and write), what
// its kinematics cost the driver's own thread, and how often a mocked Falcon is asked. Run it under umockdev-wrapper.
#include <algorithm>
#include <cstdlib>

#include "device/drivers/falcon/falcon_device.h"
#include "tests/bench/tick_cost.h"
#include "tests/device/drivers/mock_falcon_umockdev.h"

namespace {

using namespace vallecula::device;

/// Encoders to position from a millimetre away, force to motors: what the driver's thread adds to the bus.
void measure_kinematics(int ticks) {
  std::vector<double> cost;
  falcon::Angles angles = *falcon::leg_angles({0.02, 0.01, -0.02});
  for (int i = 0; i < ticks; ++i) {
    angles[i % 3] += i % 2 == 0 ? 0.01 : -0.01;
    const auto begin = Clock::now();
    const auto position = falcon::position_of(angles, {0.021, 0.01, -0.02});
    const auto torques = falcon::leg_torques(*position, {1.0, -2.0, 0.5});
    const auto motors = falcon::motor_commands(*torques);
    cost.push_back(microseconds(Clock::now() - begin));
    if (motors[0] == motors[1] && motors[1] == motors[2]) std::puts("");  // keeps the work
  }
  tell("falcon: kinematics both ways", cost);
}

/// False where the program was not started under umockdev-wrapper.
bool measure_device(int ticks) {
  UMockdevTestbed* bed = umockdev_testbed_new();
  const bool mocked = umockdev_in_mock_environment();
  if (mocked) {
    MockFalcon mock(bed, {});
    mock.plug();
    mock.home();
    FalconDevice falcon;
    const long asked = mock.seen().commands;
    const auto first = Clock::now();
    measure("falcon: read and write", falcon, ticks);
    const double seconds = 1e-6 * microseconds(Clock::now() - first);
    std::printf("falcon: asked %.0f times a second (mocked bus)\n",
                static_cast<double>(mock.seen().commands - asked) / seconds);
  }
  g_object_unref(bed);
  return mocked;
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(10, std::atoi(argv[1])) : 10000;
  measure_kinematics(ticks);
  if (measure_device(ticks)) return 0;
  std::fprintf(stderr, "falcon_bench: no mocked bus here; run it as: umockdev-wrapper vallecula_falcon_bench\n");
  return 2;
}

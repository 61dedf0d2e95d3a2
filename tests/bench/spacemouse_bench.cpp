// vallecula_spacemouse_bench [TICKS]: what one tick of the SpaceMouse's driver (read and write) costs the servo thread
// while the cap reports at its own rate, and how long a report takes from the mocked node to the reading. Run it under
// umockdev-wrapper.
#include <algorithm>
#include <cstdlib>

#include "device/drivers/spacemouse/spacemouse_device.h"
#include "tests/bench/tick_cost.h"
#include "tests/device/drivers/hid_umockdev.h"

namespace {

using namespace vallecula::device;

constexpr int kReportEvery = 8;  // ticks: 125 a second

/// The mocked device is a fixture's; here without a test around it.
class Bench : public HidUmockdev {
 public:
  void run(int ticks) {
    SetUp();
    plug_in({});
    {
      SpaceMouseDevice device;
      measure("spacemouse: read and write", device, ticks, [this](int i) {
        if (i % kReportEvery == 0) report(0, {1, static_cast<std::uint8_t>(i), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
      });
      measure_delay(device, std::max(10, ticks / kReportEvery), 0.001 * ticks);
    }
    TearDown();
  }

 private:
  void TestBody() override {}

  /// By the buttons, which are read as they are reported.
  void measure_delay(SpaceMouseDevice& device, int times, double time_s) {
    constexpr double kLostS = 1.0;
    std::vector<double> delay;
    int lost = 0;
    for (int i = 0; i < times; ++i) {
      const std::uint8_t buttons = i % 2 == 0 ? 1 : 2;
      const auto begin = Clock::now();
      report(0, {3, buttons});
      while (device.read(time_s).buttons != buttons && microseconds(Clock::now() - begin) < 1e6 * kLostS)
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      const double us = microseconds(Clock::now() - begin);
      if (us < 1e6 * kLostS) delay.push_back(us);
      lost += us >= 1e6 * kLostS;
      std::this_thread::sleep_for(std::chrono::milliseconds(kReportEvery));
    }
    if (!delay.empty()) tell("spacemouse: report to reading", delay);
    if (lost > 0) std::printf("spacemouse: %d of %d reports did not arrive within %.0f s\n", lost, times, kLostS);
  }
};

/// False where the program was not started under umockdev-wrapper; known once there is a testbed.
bool mocked() {
  UMockdevTestbed* bed = umockdev_testbed_new();
  const bool so = umockdev_in_mock_environment();
  g_object_unref(bed);
  return so;
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(10, std::atoi(argv[1])) : 10000;
  if (mocked()) {
    Bench().run(ticks);
    return 0;
  }
  std::fprintf(stderr,
               "spacemouse_bench: no mocked bus here; run it as: umockdev-wrapper vallecula_spacemouse_bench\n");
  return 2;
}

// vallecula_device_bench [TICKS]: what one tick of a driver (read and write, as the servo thread calls them) costs.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "device/drivers/hdapi/hd_device.h"
#include "device/drivers/mouse_device.h"
#include "device/drivers/scripted_device.h"

namespace {

using namespace vallecula::device;
using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration d) { return std::chrono::duration<double, std::micro>(d).count(); }

/// `ticks` ticks at 1 kHz, for a driver with a thread of its own must have something new to say.
void measure(const char* what, HapticDevice& device, int ticks) {
  std::vector<double> cost(static_cast<std::size_t>(ticks));
  auto next = Clock::now();
  for (int i = 0; i < ticks; ++i) {
    const auto begin = Clock::now();
    const DeviceReading reading = device.read(0.001 * i);
    device.write({0.1 * reading.position_m[0], 0.0, 0.5});
    cost[static_cast<std::size_t>(i)] = microseconds(Clock::now() - begin);
    next += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(next);
  }
  std::sort(cost.begin(), cost.end());
  const auto at = [&](double share) { return cost[static_cast<std::size_t>(share * (ticks - 1))]; };
  std::printf("%-34s median %6.2f us   p99 %6.2f us   p99.9 %6.2f us   max %7.2f us\n", what, at(0.5), at(0.99),
              at(0.999), cost.back());
}

}  // namespace

int main(int argc, char** argv) {
  const int ticks = argc > 1 ? std::max(10, std::atoi(argv[1])) : 10000;
  {
    ScriptedDevice scripted(Trajectory({{0.0, {0, 0, 0}, {1, 0, 0, 0}}, {0.001 * ticks, {0.1, 0, 0}, {1, 0, 0, 0}}}),
                            firm_hand());
    measure("scripted", scripted, ticks);
  }
  {
    MouseDevice mouse;
    measure("mouse", mouse, ticks);
  }
  {
    setenv("VALLECULA_LIBHD", VALLECULA_STAND_IN_HD, 1);
    hdapi::HdDevice touch("");
    measure("touch (stand-in libHD.so)", touch, ticks);
  }
  return 0;
}

// vallecula_device_bench [TICKS]: what one tick of a driver (read and write, as the servo thread calls them) costs.
#include <algorithm>
#include <cstdlib>

#include "device/drivers/hdapi/hd_device.h"
#include "device/drivers/mouse_device.h"
#include "device/drivers/scripted_device.h"
#include "tests/bench/tick_cost.h"

using namespace vallecula::device;

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

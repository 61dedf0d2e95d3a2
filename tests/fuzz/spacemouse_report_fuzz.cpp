// Any bytes as a series of reports of a SpaceMouse: nothing is read beyond a report, a report that is refused changes
// nothing, and whatever the cap seems to say the blade stays within its speed and its cube.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "device/drivers/spacemouse/rate_control.h"
#include "device/rotation.h"

using namespace vallecula::device;

namespace {

void must(bool condition) {
  if (!condition) std::abort();
}

bool same(const SpaceMouseState& a, const SpaceMouseState& b) {
  return a.translation == b.translation && a.rotation == b.rotation && a.buttons == b.buttons &&
         a.translation_reports == b.translation_reports && a.rotation_reports == b.rotation_reports;
}

}  // namespace

/// Every report is preceded by its length and by the ticks until the next one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const RateSettings settings;
  RateControl rate(settings);
  SpaceMouseState cap;
  DeviceReading last = rate.step(cap, 0.0);
  double time_s = 0.0;
  for (std::size_t at = 0; at + 2 <= size;) {
    const std::size_t length_told = std::min<std::size_t>(data[at] % (kLongestReport + 1), size - at - 2);
    const int ticks = data[at + 1] % 32;
    const std::vector<std::uint8_t> report(data + at + 2, data + at + 2 + length_told);  // ends where it ends
    at += 2 + length_told;
    const SpaceMouseState before = cap;
    if (!apply_report(report.data(), report.size(), cap)) must(same(cap, before));
    for (int i = 0; i < ticks; ++i) {
      const DeviceReading now = rate.step(cap, time_s += 0.001);
      must(length(subtract(now.position_m, last.position_m)) <= 0.001001 * settings.max_speed_m_s);
      must(angle_between(now.rotation_wxyz, last.rotation_wxyz) <= 0.001001 * settings.max_turn_rad_s + 1e-7);
      for (const double x : now.position_m) must(std::abs(x) <= 0.5 * settings.workspace_m);
      last = now;
    }
  }
  return 0;
}

#include "gui/views/grey_window.h"

#include <algorithm>
#include <cmath>

namespace vallecula::gui {

std::uint8_t grey_of(double hu, const GreyWindow& window) {
  const double width = std::max(1.0, window.width);
  const double from_centre = hu - (window.centre - 0.5);
  if (from_centre <= -0.5 * (width - 1.0)) return 0;
  if (from_centre > 0.5 * (width - 1.0)) return 255;
  return static_cast<std::uint8_t>(std::lround(255.0 * (from_centre / (width - 1.0) + 0.5)));
}

GreyTable::GreyTable(const GreyWindow& window) : grey_(65536) {
  for (int hu = -32768; hu <= 32767; ++hu)
    grey_[static_cast<std::uint16_t>(static_cast<std::int16_t>(hu))] = grey_of(hu, window);
}

}  // namespace vallecula::gui

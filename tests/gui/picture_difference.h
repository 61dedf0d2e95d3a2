// How far two pictures of one scene are apart, as an eye would have it: not pixel by pixel, for edges fall half a pixel
// elsewhere on another driver, but on the pictures blurred by three pixels.
#pragma once

#include <QImage>

namespace vallecula::gui::window_test {

struct PictureDifference {
  double mean_grey = 0.0;  ///< mean over pixels and colours of the absolute difference, grey levels (0..255)
  double share_off = 0.0;  ///< of the pixels, of which a colour is off by more than kOffBy
  static constexpr int kOffBy = 24;
};

/// Of pictures of one size; of two sizes everything differs. `picture`: what differs, white for kOffBy and more.
PictureDifference picture_difference(const QImage& a, const QImage& b, QImage* picture = nullptr);

}  // namespace vallecula::gui::window_test

#include "tests/gui/picture_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vallecula::gui::window_test {
namespace {

using Pixels = std::vector<std::array<float, 3>>;

/// A box of three pixels, twice: nearly a Gaussian of 1.2 pixels.
Pixels blurred(const QImage& image) {
  const int w = image.width(), h = image.height();
  Pixels pixels(static_cast<std::size_t>(w * h)), next(pixels.size());
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const QRgb c = image.pixel(x, y);
      pixels[static_cast<std::size_t>(y * w + x)] = {static_cast<float>(qRed(c)), static_cast<float>(qGreen(c)),
                                                     static_cast<float>(qBlue(c))};
    }
  for (int pass = 0; pass < 2; ++pass) {
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        auto& out = next[static_cast<std::size_t>(y * w + x)];
        out = {0, 0, 0};
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            for (std::size_t c = 0; c < 3; ++c)
              out[c] += pixels[static_cast<std::size_t>(std::clamp(y + dy, 0, h - 1) * w +
                                                        std::clamp(x + dx, 0, w - 1))][c] / 9.0f;
      }
    pixels.swap(next);
  }
  return pixels;
}

}  // namespace

PictureDifference picture_difference(const QImage& a, const QImage& b, QImage* picture) {
  if (a.size() != b.size() || a.isNull()) return {255.0, 1.0};
  const Pixels pa = blurred(a), pb = blurred(b);
  if (picture != nullptr) *picture = QImage(a.size(), QImage::Format_Grayscale8);
  double sum = 0.0;
  std::size_t off = 0;
  for (std::size_t i = 0; i < pa.size(); ++i) {
    float most = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      const float d = std::abs(pa[i][c] - pb[i][c]);
      sum += d;
      most = std::max(most, d);
    }
    if (most > PictureDifference::kOffBy) ++off;
    if (picture != nullptr) {
      const int x = static_cast<int>(i) % a.width(), y = static_cast<int>(i) / a.width();
      picture->scanLine(y)[x] =
          static_cast<uchar>(std::min(255.0f, 255.0f * most / static_cast<float>(PictureDifference::kOffBy)));
    }
  }
  const auto count = static_cast<double>(pa.size());
  return {sum / (3.0 * count), static_cast<double>(off) / count};
}

}  // namespace vallecula::gui::window_test

// A screen for tests of windows: an own Xvfb and a Qt application, started once a process.
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gui/pages/window_application.h"
#include "gui/session/virtual_display.h"

namespace vallecula::gui::window_test {

class Screen : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    setenv("LANGUAGE", "en", 1);  // the tests read English, wherever they run
    display_ = std::make_unique<VirtualDisplay>(1400, 900);
    application_ = std::make_unique<WindowApplication>();
  }
  static void TearDownTestSuite() {
    application_.reset();
    display_.reset();
  }
  /// Lets the window work until `done` or the time is over; false when it is.
  static bool wait_for(const std::function<bool()>& done, int timeout_ms = 60000) {
    QElapsedTimer timer;
    timer.start();
    QTimer ask_again;  // the loop sleeps until something happens in it: whoever polls it takes a processor from the trial
    ask_again.start(2);
    while (!done()) {
      if (timer.elapsed() > timeout_ms) return false;
      QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    }
    return true;
  }
  /// Kept as a picture to be looked at, where VALLECULA_PICTURES=DIR asks for it.
  static void keep_picture(QWidget& widget, const std::string& name) {
    const char* folder = std::getenv("VALLECULA_PICTURES");
    if (folder == nullptr) return;
    std::filesystem::create_directories(folder);
    widget.grab().save(QString::fromStdString((std::filesystem::path(folder) / name).string()));
  }

 private:
  static inline std::unique_ptr<VirtualDisplay> display_;
  static inline std::unique_ptr<WindowApplication> application_;
};

/// Distinct colours in a picture, each channel cut to 4 bits: 1 for an empty one.
inline int colours_in(const QImage& image) {
  std::vector<bool> seen(4096, false);
  int count = 0;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2) {
      const QRgb c = image.pixel(x, y);
      const std::size_t key = static_cast<std::size_t>((qRed(c) >> 4) << 8 | (qGreen(c) >> 4) << 4 | qBlue(c) >> 4);
      if (!seen[key]) {
        seen[key] = true;
        ++count;
      }
    }
  return count;
}

/// Pixels that `wanted` is true of, and their middle (pixels; 0,0 is top left).
struct Spot {
  int pixels = 0;
  double x = 0.0, y = 0.0;
};
inline Spot find_pixels(const QImage& image, const std::function<bool(QRgb, int, int)>& wanted) {
  Spot spot;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (wanted(image.pixel(x, y), x, y)) {
        ++spot.pixels;
        spot.x += x;
        spot.y += y;
      }
  if (spot.pixels > 0) {
    spot.x /= spot.pixels;
    spot.y /= spot.pixels;
  }
  return spot;
}
/// Where two pictures of one size differ clearly.
inline Spot difference(const QImage& a, const QImage& b) {
  return find_pixels(a, [&b](QRgb c, int x, int y) {
    const QRgb d = b.pixel(x, y);
    return std::abs(qRed(c) - qRed(d)) + std::abs(qGreen(c) - qGreen(d)) + std::abs(qBlue(c) - qBlue(d)) > 60;
  });
}
/// The airway's blue, lit or not.
inline bool is_airway_blue(QRgb c) { return qBlue(c) > 90 && qBlue(c) > 2 * qRed(c) && qBlue(c) > qGreen(c) + 30; }

}  // namespace vallecula::gui::window_test

// Every text that a painting puts on its device, and where: asked of the painting itself, through a device that keeps
// no picture.
#pragma once

#include <QPainter>
#include <QString>
#include <QWidget>
#include <functional>
#include <string>
#include <vector>

namespace vallecula::gui::window_test {

struct PaintedWord {
  QString text;
  QRectF place;    ///< of its ink, in the device's pixels
  int pixels = 0;  ///< of its type
};

/// What `paint` writes on a device of this size.
std::vector<PaintedWord> painted_words(const QSize& size, const std::function<void(QPainter&)>& paint);
/// What a widget writes, without its children.
std::vector<PaintedWord> painted_words(QWidget& widget);

/// Every two texts that lie on one another, and every one that leaves the device, for a test's message.
std::vector<std::string> trouble_of(const std::vector<PaintedWord>& words, const QSize& size);

}  // namespace vallecula::gui::window_test

// Where a panel that leaves its window comes to lie.
#pragma once

#include <QPoint>
#include <QRect>
#include <vector>

namespace vallecula::gui {

/// The upper left corner of a rectangle of this size within the screen that covers as little as can be of the panels,
/// and after that of the window; of equal ones the nearest to the window's upper right corner. All on the desktop, px.
QPoint free_place(const QSize& size, const QRect& screen, const QRect& window, const std::vector<QRect>& panels);

}  // namespace vallecula::gui

#include "gui/pages/free_place.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace vallecula::gui {
namespace {

long long covered(const QRect& place, const QRect& other) {
  const QRect both = place & other;
  return both.isEmpty() ? 0 : static_cast<long long>(both.width()) * both.height();
}

}  // namespace

QPoint free_place(const QSize& size, const QRect& screen, const QRect& window, const std::vector<QRect>& panels) {
  // What covers least lies at an edge of something, or of the screen.
  std::vector<QRect> edges(panels);
  edges.push_back(window);
  std::vector<int> xs{screen.left(), screen.right() + 1 - size.width()},
      ys{screen.top(), screen.bottom() + 1 - size.height()};
  for (const QRect& one : edges) {
    xs.insert(xs.end(), {one.left() - size.width(), one.left(), one.right() + 1 - size.width(), one.right() + 1});
    ys.insert(ys.end(), {one.top() - size.height(), one.top(), one.bottom() + 1 - size.height(), one.bottom() + 1});
  }
  QPoint best = screen.topLeft();
  std::tuple<long long, long long, int> least{std::numeric_limits<long long>::max(), 0, 0};
  for (const int x : xs)
    for (const int y : ys) {
      // A window that is larger than its screen begins at the upper left.
      const QPoint corner(std::max(screen.left(), std::min(x, screen.right() + 1 - size.width())),
                          std::max(screen.top(), std::min(y, screen.bottom() + 1 - size.height())));
      const QRect place(corner, size);
      long long others = 0;
      for (const QRect& panel : panels) others += covered(place, panel);
      const std::tuple cost{others, covered(place, window),
                            (corner - QPoint(window.right() + 1, window.top())).manhattanLength()};
      if (cost >= least) continue;
      least = cost;
      best = corner;
    }
  return best;
}

}  // namespace vallecula::gui

// How the docks about the operator's view share the window's room for as long as nobody has moved one: what is how wide
// and how high, what stands behind whose tab, and whom the team's line comes before.
#include <QDockWidget>
#include <QSet>
#include <QTabBar>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "gui/pages/trial_panels.h"

namespace vallecula::gui {
namespace {

constexpr int kOneView = 150;   // px in height; where a view has less, the team's line comes before it
constexpr int kTwoViews = 420;  // px in height from which two views stand one above the other
constexpr double kSideShare = 0.36, kMostSideShare = 0.42;

}  // namespace

void TrialPanels::fit_later() {
  // Once the docks that came or went have their places.
  if (!as_at_first_) return;
  QTimer::singleShot(0, this, &TrialPanels::fit);
  QTimer::singleShot(0, this, &TrialPanels::widen);  // for the tabs that came by it
}

/// The side as wide as it is at first, or as the names on its tabs are, where the picture stays the largest.
void TrialPanels::widen() {
  if (!isVisible() || !as_at_first_) return;
  double wide = kSideShare * width();
  for (const QTabBar* tabs : findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    if (tabs->isVisible() && tabs->count() > 1)
      wide = std::max(wide, std::min(tabs->sizeHint().width() + 4.0, kMostSideShare * width()));
  resizeDocks({docks_[force]}, {static_cast<int>(wide)}, Qt::Horizontal);
}

/// A panel behind another's tab is not.
bool TrialPanels::in_front(Panel panel) const { return !docks_[panel]->widget()->visibleRegion().isEmpty(); }

bool TrialPanels::team_shares_place() const {
  const auto tabbed = tabifiedDockWidgets(docks_[team]);
  return std::any_of(tabbed.begin(), tabbed.end(), [](const QDockWidget* view) { return view->isVisible(); });
}

/// In a small window a sentence stands before a view for as long as it is to be read.
void TrialPanels::raise_team() {
  const auto tabbed = tabifiedDockWidgets(docks_[team]);
  for (const Panel view : {cut, video})
    if (in_front(view) && tabbed.contains(docks_[view])) behind_team_ = docks_[view];
  docks_[team]->setVisible(true);
  docks_[team]->raise();
}

/// Only where the team still stands in front: whoever closed it, or looks at another view meanwhile, keeps that.
void TrialPanels::put_back() {
  QDockWidget* view = std::exchange(behind_team_, nullptr);
  if (view != nullptr && in_front(team) && tabifiedDockWidgets(docks_[team]).contains(view)) view->raise();
}

void TrialPanels::fit_team(int left) {
  const bool tabbed = !tabifiedDockWidgets(docks_[team]).isEmpty();
  if (left < kOneView && !tabbed && !asks_) {
    const Panel view = in_front(video) && !in_front(cut) ? video : docks_[cut]->isVisible() ? cut : video;
    arranging_ = true;
    tabifyDockWidget(docks_[view], docks_[team]);
    arranging_ = false;
    behind_team_ = docks_[view];
    docks_[team]->raise();
  } else if (tabbed && (left >= kOneView || asks_)) {
    QDockWidget* view = in_front(video) ? docks_[video] : in_front(cut) ? docks_[cut] : behind_team_;
    arrange();  // the team on top again
    if (view != nullptr) view->raise();
  }
}

/// As high as its texts ask for; the cut has the rest.
void TrialPanels::fit() {
  if (!isVisible() || !as_at_first_) return;
  widen();
  docks_[readings]->widget()->updateGeometry();  // its height now: it does not ask by itself when a figure changes
  resizeDocks({docks_[monitor]}, {docks_[monitor]->sizeHint().height()}, Qt::Vertical);
  QList<QDockWidget*> side;
  QList<int> heights;
  int left = height();
  for (const Panel panel : {team, force, readings})
    if (docks_[panel]->isVisible()) {
      side << docks_[panel];
      heights << docks_[panel]->sizeHint().height();
      left -= heights.back();
    }
  if (docks_[team]->isVisible() && (docks_[cut]->isVisible() || docks_[video]->isVisible())) {
    fit_team(left);
    if (!tabifiedDockWidgets(docks_[team]).isEmpty()) {
      side.removeOne(docks_[team]);
      heights.removeFirst();
      left += docks_[team]->sizeHint().height();
    }
  }
  // Two views one above the other where there is room, else one behind the other's tab.
  if (docks_[cut]->isVisible() && docks_[video]->isVisible()) {
    const bool tabbed = tabifiedDockWidgets(docks_[cut]).contains(docks_[video]);
    arranging_ = true;
    if (left < kTwoViews && !tabbed) {
      tabifyDockWidget(docks_[cut], docks_[video]);
      if (!team_shares_place()) docks_[video]->raise();
    } else if (left >= kTwoViews && tabbed) {
      splitDockWidget(docks_[cut], docks_[video], Qt::Vertical);
    }
    arranging_ = false;
  }
  for (const Panel panel : {cut, video})
    if (docks_[panel]->isVisible()) {
      side << docks_[panel];
      heights << std::max(kOneView, left / 2);
      // A sentence before a view is there to be read, all of it.
      if (tabifiedDockWidgets(docks_[panel]).contains(docks_[team]) && docks_[team]->isVisible())
        heights.back() = std::max(heights.back(), docks_[team]->sizeHint().height() + 2 * fontMetrics().lineSpacing());
    }
  // Where that is more than there is, the readings give way: their last are scrolled to.
  if (const int at = side.indexOf(docks_[readings]); at >= 0) {
    QSet<QDockWidget*> counted;
    int over = -height();
    for (int i = 0; i < side.size(); ++i) {
      const auto tabbed = tabifiedDockWidgets(side[i]);
      if (std::any_of(tabbed.begin(), tabbed.end(), [&](QDockWidget* one) { return counted.contains(one); })) continue;
      counted.insert(side[i]);
      over += heights[i];
    }
    heights[at] -= std::clamp(over, 0, std::max(0, heights[at] - docks_[readings]->minimumSizeHint().height()));
  }
  resizeDocks(side, heights, Qt::Vertical);
}

}  // namespace vallecula::gui

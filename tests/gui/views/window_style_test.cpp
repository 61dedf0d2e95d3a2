// A box to choose from: what it has no room for ends in dots and is told by the tooltip, its list is as wide as its
// entries and stays on the screen, and nothing but its arrow stands at its end.
#include <QAbstractItemView>
#include <QComboBox>
#include <QHelpEvent>
#include <QScreen>
#include <QScrollBar>
#include <QToolTip>

#include "gui/views/theme.h"
#include "tests/gui/painted_words.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

const QString kLong = "Mouse and keyboard; the force is drawn, not felt, and told in newtons";

class WindowStyleOfBoxes : public Screen {
 protected:
  WindowStyleOfBoxes() { theme::apply(*qApp, {}); }
  ~WindowStyleOfBoxes() override { theme::apply(*qApp, {}); }
  static void fill(QComboBox& box) {
    box.addItems({"Touch", kLong});
    box.setCurrentIndex(1);
  }
  static void show(QWidget& widget, int wide) {
    widget.resize(wide, widget.sizeHint().height());
    widget.show();
    ASSERT_TRUE(wait_for([&] { return widget.isVisible() && widget.width() == wide; }, 5000));
    QApplication::processEvents();
  }
  static QString told_by_tooltip(QWidget& widget) {
    QToolTip::hideText();
    QHelpEvent over(QEvent::ToolTip, QPoint(20, 10), widget.mapToGlobal(QPoint(20, 10)));
    QApplication::sendEvent(&widget, &over);
    const QString said = QToolTip::isVisible() ? QToolTip::text() : QString();
    QToolTip::hideText();
    return said;
  }
};

TEST_F(WindowStyleOfBoxes, WhatHasNoRoomEndsInDotsAndIsToldByTheTooltip) {
  for (const double scale : {1.0, 1.35}) {
    theme::apply(*qApp, {theme::Ground::dark, scale});
    QComboBox box;
    fill(box);
    show(box, 200);
    const auto words = painted_words(box);
    ASSERT_EQ(words.size(), 1u);
    EXPECT_TRUE(words[0].text.endsWith(QChar(0x2026))) << words[0].text.toStdString();
    EXPECT_TRUE(kLong.startsWith(words[0].text.chopped(1).trimmed())) << words[0].text.toStdString();
    EXPECT_LT(words[0].place.right(), box.width() - 18) << "clear of the arrow";
    EXPECT_EQ(told_by_tooltip(box), kLong);
    box.setToolTip("What holds the blade");
    EXPECT_EQ(told_by_tooltip(box), kLong + "\nWhat holds the blade");
    show(box, box.sizeHint().width());
    EXPECT_EQ(painted_words(box).at(0).text, kLong) << "the box asks for the room of its longest entry";
    EXPECT_EQ(told_by_tooltip(box), "What holds the blade");
  }
}

TEST_F(WindowStyleOfBoxes, ItsListIsAsWideAsItsEntriesAndOnTheScreen) {
  QComboBox box;
  fill(box);
  show(box, 160);
  const QRect screen = box.screen()->availableGeometry();
  for (const int left : {screen.left() + 20, screen.right() - 170}) {
    box.move(left, screen.top() + 100);
    QApplication::processEvents();
    box.showPopup();
    ASSERT_TRUE(wait_for([&] { return box.view()->isVisible(); }, 5000));
    const QWidget& list = *box.view()->window();
    EXPECT_GE(box.view()->viewport()->width(), box.fontMetrics().horizontalAdvance(kLong));
    EXPECT_EQ(box.view()->horizontalScrollBar()->maximum(), 0);
    EXPECT_TRUE(screen.contains(list.geometry())) << list.x() << " + " << list.width();
    box.hidePopup();
  }
}

TEST_F(WindowStyleOfBoxes, NothingButTheArrowStandsAtItsEnd) {
  QComboBox box;
  box.addItem("");
  show(box, 160);
  const QColor panel = theme::panel();
  const QImage picture = box.grab().toImage();
  int ink = 0;
  // Within its edge: the panel's colour, and lighter where the arrow is.
  for (int y = 4; y < picture.height() - 4; ++y)
    for (int x = picture.width() / 2; x < picture.width() - 4; ++x) {
      const QColor seen = picture.pixelColor(x, y);
      ASSERT_GE(seen.lightness(), panel.lightness() - 1) << x << ", " << y << ": a notch";
      ink += seen.lightness() > panel.lightness() + 60 ? 1 : 0;
      if (x < picture.width() - 28) ASSERT_EQ(seen, panel) << x << ", " << y;
    }
  EXPECT_GT(ink, 8) << "the arrow is seen";
}

}  // namespace
}  // namespace vallecula::gui::window_test

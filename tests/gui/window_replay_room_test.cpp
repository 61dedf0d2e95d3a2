// A replay with large text and German words: its charts are seen whole, a chart may have the views' room, and what has
// no room ends in dots.
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QToolButton>

#include "gui/pages/linked_chart.h"
#include "gui/pages/look_settings.h"
#include "gui/report/monitor_chart.h"
#include "gui/session/languages.h"
#include "gui/views/elided_label.h"
#include "gui/views/operator_view.h"
#include "gui/views/scrolled.h"
#include "tests/gui/painted_words.h"
#include "tests/gui/window_replay.h"

namespace vallecula::gui::window_test {
namespace {

class WindowReplayRoom : public WindowReplay {
 protected:
  WindowReplayRoom() {
    LookSettings look;
    look.text_scale = 1.35;
    apply_look(look);
    EXPECT_TRUE(install_language(*qApp, "de"));
  }
  ~WindowReplayRoom() override {
    apply_look({});
    install_language(*qApp, "en");
  }
  /// px: as a chart has them that never grows smaller.
  static double letters_with_room() {
    const ChartView view("", 1.0, false);
    EXPECT_NEAR(view.em(), 0.9 * 1.35 * 10.0 * 96.0 / 72.0, 1.0);  // of 10 points; a font has whole pixels
    return view.em();
  }
};

TEST_F(WindowReplayRoom, AChartIsSeenWholeAndMayHaveTheViewsRoom) {
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  ReplayPage& page = opened(window, trial());
  EXPECT_EQ(window.size(), QSize(1280, 800));
  auto& chart = *page.findChild<LinkedChart*>("force_chart");
  ASSERT_TRUE(wait_for([&] { return chart.drawn(); }));
  const auto* scrolled = qobject_cast<QScrollArea*>(chart.parentWidget()->parentWidget());
  ASSERT_NE(scrolled, nullptr);
  EXPECT_EQ(scrolled->verticalScrollBar()->maximum(), 0);
  const double small = chart.em(), high = chart.height();
  const double letters = letters_with_room();
  EXPECT_GT(small, 0.65 * letters);
  keep_picture(window, "replay-room.png");

  key(page, Qt::Key_L);
  ASSERT_TRUE(wait_for([&] { return chart.height() > 1.6 * high; }, 5000));
  EXPECT_FALSE(page.operator_view().isVisible());
  EXPECT_NEAR(chart.em(), letters, 0.6);
  EXPECT_EQ(scrolled->verticalScrollBar()->maximum(), 0);
  keep_picture(window, "replay-room-large.png");
  auto* corner = chart.findChild<QToolButton*>("larger");
  ASSERT_NE(corner, nullptr);
  ASSERT_TRUE(wait_for([&] { return corner->geometry().right() == chart.width() - 2; }, 5000));
  EXPECT_GE(corner->width(), 16);
  QTest::mouseClick(corner, Qt::LeftButton);
  ASSERT_TRUE(wait_for([&] { return page.operator_view().isVisible() && chart.height() < 1.1 * high; }, 5000));
  QTest::mouseClick(corner, Qt::LeftButton);
  ASSERT_TRUE(wait_for([&] { return !page.operator_view().isVisible(); }, 5000));
  // Whoever opens the next finds the views.
  key(page, Qt::Key_Escape);
  window.show();  // opened for one trial only, it closed
  opened(window, trial());
  EXPECT_TRUE(page.operator_view().isVisible());
}

TEST_F(WindowReplayRoom, TheMonitorsChartIsSeenWholeWhereThereIsAThirdLessRoomThanItAsksFor) {
  auto* chart = new LinkedChart("Monitor", kLeastUntitledMonitorChart);
  Scrolled scrolled(chart, 7.0);
  const double letters = letters_with_room();
  scrolled.resize(720, static_cast<int>(0.7 * kLeastUntitledMonitorChart * letters));
  scrolled.show();
  ASSERT_TRUE(wait_for([&] { return scrolled.isVisible(); }, 5000));
  QApplication::processEvents();
  EXPECT_EQ(scrolled.verticalScrollBar()->maximum(), 0);
  EXPECT_NEAR(chart->form().em, 0.7 * letters, 0.5);
  EXPECT_LE(chart->form().height, scrolled.viewport()->height());
  scrolled.resize(720, 120);
  QApplication::processEvents();
  EXPECT_GT(scrolled.verticalScrollBar()->maximum(), 0) << "letters that cannot be read are no help";
}

TEST_F(WindowReplayRoom, ALineWithoutRoomTakesItsShorterWordingAndThenDots) {
  ElidedLabel label;
  const QString whole = "Durchgang wird neu simuliert bis 0:22,0 ... 47 % (Anhalten beendet es)",
                brief = "Simulation 47 %";
  label.say({whole, brief});
  const auto shown_at = [&](int wide) {
    label.resize(wide, label.sizeHint().height());
    label.show();
    QApplication::processEvents();
    const auto words = painted_words(label);
    return words.size() == 1 ? words[0].text : QString("%1 texts").arg(words.size());
  };
  EXPECT_EQ(shown_at(label.fontMetrics().horizontalAdvance(whole) + 4), whole);
  EXPECT_EQ(label.toolTip(), "");
  EXPECT_EQ(shown_at(label.fontMetrics().horizontalAdvance(brief) + 4), brief);
  EXPECT_EQ(label.toolTip(), whole);
  const QString cut = shown_at(label.fontMetrics().horizontalAdvance(brief) - 20);
  EXPECT_TRUE(cut.endsWith(QChar(0x2026)) && brief.startsWith(cut.chopped(1))) << cut.toStdString();
}

}  // namespace
}  // namespace vallecula::gui::window_test

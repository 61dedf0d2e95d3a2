// A chart's letters and its least height follow the text's size, whatever it is drawn for, and what was cut is told.
#include <QHelpEvent>
#include <QToolTip>
#include <mutex>
#include <vector>

#include "gui/pages/chart_view.h"
#include "gui/pages/look_settings.h"
#include "gui/records_pages/trial_chart.h"
#include "gui/views/theme.h"
#include "tests/gui/accessible.h"
#include "tests/gui/painted_words.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

class WindowChartView : public Screen {
 protected:
  ~WindowChartView() override { apply_look({}); }
  static void text(double scale) {
    LookSettings look;
    look.text_scale = scale;
    apply_look(look);
  }
};

TEST_F(WindowChartView, LettersAndLeastHeightFollowTheTextsSize) {
  std::mutex drawing;  // forms are asked for on threads of their own
  std::vector<ChartForm> asked;
  const auto last = [&] {
    const std::lock_guard<std::mutex> lock(drawing);
    return asked.back();
  };
  ChartView view("Force", 20.0, true);
  view.resize(600, 260);
  view.show_chart([&](const ChartForm& form) {
    {
      const std::lock_guard<std::mutex> lock(drawing);
      asked.push_back(form);
    }
    QImage picture(form.width, form.height, QImage::Format_RGB32);
    picture.fill(Qt::white);
    return Chart{picture, {{QRectF(10, 10, 60, 20), "dev...", "device limit 7.9 N"}}};
  });
  view.show();
  ASSERT_TRUE(wait_for([&] { return view.drawn(); }, 20000));
  const ChartForm small = last();
  // 10 points at 96 to the inch are 13.3 px; a chart's letters a tenth smaller.
  EXPECT_NEAR(small.em, 0.9 * 10.0 * 96.0 / 72.0, 0.6);
  EXPECT_EQ(small.width, 600);
  EXPECT_GE(view.minimumSizeHint().height(), 20.0 * small.em);
  QHelpEvent over(QEvent::ToolTip, QPoint(20, 20), view.mapToGlobal(QPoint(20, 20)));
  QApplication::sendEvent(&view, &over);
  EXPECT_EQ(QToolTip::text(), "device limit 7.9 N");
  QToolTip::hideText();
  text(1.35);
  ASSERT_TRUE(wait_for([&] { return last().em > 1.2 * small.em; }, 20000)) << "drawn anew";
  EXPECT_NEAR(last().em / small.em, 1.35, 0.08);
  EXPECT_NEAR(view.minimumSizeHint().height(), 20.0 * last().em, 1.0);
}

TEST_F(WindowChartView, ALearningCurvesWordsStandClearOfOneAnotherInEveryTextSize) {
  TrialChart::Content content;
  content.title = QString::fromUtf8("Dauer des Intubationsversuchs, bis die Spitze hinter den Stimmlippen stand (s)");
  for (int trial = 0; trial < 120; ++trial) {
    TrialChart::Point point;
    point.value = 0.05 * trial;
    content.points.push_back(point);
  }
  // Closer together than a line of text is high.
  content.levels = {{5.0, theme::target(), "Ziel", true},
                    {5.2, theme::over(), "bestanden bis hierher", false},
                    {5.1, theme::bad(), "nicht kompetent", false}};
  for (const double scale : {1.0, 1.35, 1.6}) {
    text(scale);
    for (const int wider : {0, 140, 600}) {
      TrialChart chart(nullptr);
      chart.show_content(content);
      const QSize least = chart.minimumSizeHint();
      chart.resize(least.width() + wider, least.height());
      const auto words = painted_words(chart);
      const std::string which = std::to_string(scale) + ", wider by " + std::to_string(wider);
      const auto trouble = trouble_of(words, chart.size());
      EXPECT_EQ(trouble, std::vector<std::string>()) << which << lines(trouble);
      for (const PaintedWord& word : words) EXPECT_NEAR(word.pixels, scale * 10.0 * 96.0 / 72.0, 1.0) << which;
      QStringList all;
      for (const PaintedWord& word : words) all << word.text;
      if (wider > 0)
        for (const auto& level : content.levels) EXPECT_TRUE(all.contains(level.text)) << which;
      QString title;
      for (const ChartLabel& label : chart.labels()) title += label.whole + ' ';
      EXPECT_TRUE(title.contains(content.title)) << which << ": " << title.toStdString();
      if (wider == 600 && scale == 1.0) EXPECT_TRUE(all.contains(content.title)) << "in one line where there is room";
    }
  }
}

}  // namespace
}  // namespace vallecula::gui::window_test

// What is open follows the look at once: links, rows of lists, sheets, sizes; and a dialog is told from what lies
// behind.
#include <QDialog>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <cmath>

#include "gui/pages/result_page.h"
#include "gui/pages/timed_list.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

using theme::Ground;

/// Relative luminance and contrast of WCAG 2.1.
double luminance(const QColor& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  const double one = luminance(a), other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

class WindowTheme : public Screen {
 protected:
  ~WindowTheme() override { theme::apply(*qApp, {}); }
  static void show(QWidget& widget) {
    widget.show();
    wait_for([&] { return widget.isVisible(); }, 2000);
    QApplication::processEvents();
  }
  /// The pixel of the widget that differs most from its ground: its ink.
  static double best_contrast(QWidget& widget) {
    const QImage picture = widget.grab().toImage();
    const QColor ground = picture.pixelColor(1, 1);
    double best = 1.0;
    for (int y = 2; y < picture.height() - 2; ++y)
      for (int x = 2; x < picture.width() - 2; ++x) best = std::max(best, contrast(ground, picture.pixelColor(x, y)));
    return best;
  }
};

TEST_F(WindowTheme, LinksAndRowsOfListsAreReadOnTheGroundTheyStandOn) {
  QWidget page;
  auto* link = new QLabel("<a href='1'>IIIIIII</a>", &page);
  auto* list = new TimedList("events", &page);
  list->add(1.0, "IIIIIII", theme::over());
  auto* own = new QLabel("IIIIIII", &page);
  theme::dress(*own, "color: @within@;");
  auto* column = new QVBoxLayout(&page);
  for (QWidget* one : {static_cast<QWidget*>(link), static_cast<QWidget*>(list), static_cast<QWidget*>(own)})
    column->addWidget(one);
  show(page);
  for (const Ground ground : {Ground::light, Ground::dark, Ground::light}) {
    theme::apply(*qApp, {ground, 1.0});
    QApplication::processEvents();
    EXPECT_GE(best_contrast(*link), 4.5) << "WCAG 2.1, 1.4.3";
    EXPECT_GE(best_contrast(*own), 4.5);
    EXPECT_GE(contrast(list->item(0)->foreground().color(), theme::panel()), 4.5);
  }
}

TEST_F(WindowTheme, FontsAndSizesOfTheirOwnFollowTheTextsSize) {
  QWidget page;
  auto* own = new QLabel("12.5 N", &page);
  theme::dress(*own, "font-size: @15pt@; font-weight: bold;");
  auto* wide = new QWidget(&page);
  theme::keep_wide(*wide, 100);
  theme::keep_high(*wide, 40);
  auto* readings = new TrialReadings(&page);
  auto* column = new QVBoxLayout(&page);
  for (QWidget* one : {static_cast<QWidget*>(own), wide, static_cast<QWidget*>(readings)}) column->addWidget(one);
  show(page);
  for (const double scale : {1.35, 0.8, 1.0}) {
    theme::apply(*qApp, {Ground::dark, scale});
    QApplication::processEvents();
    EXPECT_NEAR(own->font().pointSizeF(), 15.0 * scale, 0.06);
    EXPECT_EQ(wide->width(), static_cast<int>(100 * scale));
    EXPECT_EQ(wide->height(), static_cast<int>(40 * scale));
    int figures = 0;
    for (const QLabel* label : readings->findChildren<QLabel*>())
      if (label->font().bold()) {
        ++figures;
        EXPECT_NEAR(label->font().pointSizeF(), 22.0 * scale, 0.06);
      }
    EXPECT_EQ(figures, 2) << "the clock, and how much is seen";
  }
}

TEST_F(WindowTheme, ValuesOfTheResultStayLargerThanTheirLabels) {
  const test::Sandbox box;
  ResultPage page;
  TrialOutcome outcome;
  outcome.score.intubation.emplace();
  outcome.score.attempt_begun = true;
  page.show_outcome(outcome, {}, box.folder(), {});
  show(page);
  for (const double scale : {1.35, 1.0}) {
    theme::apply(*qApp, {Ground::dark, scale});
    QApplication::processEvents();
    int values = 0;
    for (const QLabel* label : page.findChild<QFrame*>("panel")->findChildren<QLabel*>())
      if (label->font().bold()) {
        ++values;
        EXPECT_NEAR(label->font().pointSizeF(), 11.0 * scale, 0.06) << label->text().toStdString();
      } else {
        EXPECT_NEAR(label->font().pointSizeF(), 10.0 * scale, 0.06) << label->text().toStdString();
      }
    EXPECT_GT(values, 5);
  }
}

/// How often anybody asks how large it has to be.
class Measured : public QLabel {
 public:
  using QLabel::QLabel;
  QSize minimumSizeHint() const override {
    ++asked;
    return QLabel::minimumSizeHint();
  }
  mutable int asked = 0;
};

// A long form behind a tab must not hold the window up when the text grows; seen again, it is measured anew.
TEST_F(WindowTheme, WhatNobodySeesIsMeasuredWhenItIsSeen) {
  const auto area_with = [](Measured* words) {
    auto area = std::make_unique<QScrollArea>();
    area->setWidget(words);
    area->setWidgetResizable(true);
    area->resize(200, 100);
    return area;
  };
  auto* words = new Measured(QString("a long form\n").repeated(40));
  const auto area = area_with(words);
  show(*area);
  const int small = area->verticalScrollBar()->maximum();
  words->asked = 0;
  theme::apply(*qApp, {Ground::dark, 1.3});
  EXPECT_GT(words->asked, 0) << "what is seen is measured at once";
  theme::apply(*qApp, {Ground::dark, 1.0});
  QApplication::processEvents();
  EXPECT_EQ(area->verticalScrollBar()->maximum(), small);

  area->hide();
  for (const double text : {1.1, 1.3}) {
    QApplication::processEvents();  // what the screen had still to say
    words->asked = 0;
    theme::apply(*qApp, {Ground::light, text});
    EXPECT_EQ(words->asked, 0);
  }
  show(*area);
  const auto truth = area_with(new Measured(words->text()));
  show(*truth);
  EXPECT_GT(area->verticalScrollBar()->maximum(), small);
  EXPECT_EQ(area->verticalScrollBar()->maximum(), truth->verticalScrollBar()->maximum());
}

// The colours of the charts (Okabe and Ito), as drawn on white.
TEST_F(WindowTheme, AChartForPaperIsReadOnADarkGroundInItsOwnHues) {
  QImage paper(9, 1, QImage::Format_RGB32);
  const std::vector<QColor> colours{Qt::white,
                                    QColor(0x22, 0x22, 0x22),
                                    QColor(0x00, 0x72, 0xB2),
                                    QColor(0xD5, 0x5E, 0x00),
                                    QColor(0x00, 0x9E, 0x73),
                                    QColor(0x55, 0x55, 0x55),
                                    QColor(0x39, 0x78, 0x9b),
                                    QColor(0xE3, 0xE3, 0xE3),
                                    Qt::black};
  for (int x = 0; x < 9; ++x) paper.setPixelColor(x, 0, colours[static_cast<std::size_t>(x)]);
  theme::apply(*qApp, {Ground::light, 1.0});
  EXPECT_EQ(theme::of_this_ground(paper), paper);
  theme::apply(*qApp, {Ground::dark, 1.0});
  const QImage dark = theme::of_this_ground(paper);
  EXPECT_EQ(dark.pixelColor(0, 0), theme::panel());
  EXPECT_EQ(dark.pixelColor(8, 0), QColor(Qt::white));
  for (int x = 1; x < 7; ++x) {
    const QColor before = paper.pixelColor(x, 0), now = dark.pixelColor(x, 0);
    EXPECT_GE(contrast(now, theme::panel()), 3.0) << "WCAG 2.1, 1.4.11: " << now.name().toStdString();
    if (before.hslSaturation() > 50) {
      EXPECT_NEAR(now.hslHue(), before.hslHue(), 4) << now.name().toStdString();
    }
  }
  EXPECT_LT(contrast(dark.pixelColor(7, 0), theme::panel()), 1.6) << "a grid stays faint";
  theme::apply(*qApp, {});
}

TEST_F(WindowTheme, ADialogHasAnEdge) {
  for (const Ground ground : {Ground::dark, Ground::light}) {
    theme::apply(*qApp, {ground, 1.0});
    QDialog dialog;
    dialog.resize(200, 120);
    show(dialog);
    const QImage picture = dialog.grab().toImage();
    for (const QPoint at : {QPoint(0, 60), QPoint(199, 60), QPoint(100, 0), QPoint(100, 119)})
      EXPECT_GE(contrast(picture.pixelColor(at), theme::ground()), 3.0) << "WCAG 2.1, 1.4.11";
    EXPECT_LT(contrast(picture.pixelColor(100, 60), theme::ground()), 1.3) << "its inside stays a ground to read on";
  }
}

}  // namespace
}  // namespace vallecula::gui::window_test

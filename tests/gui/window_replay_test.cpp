// The replay page as a person uses it: from the result or from a trial's folder to any second of it.
#include "tests/gui/window_replay.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "curricula/trial_log.h"
#include "gui/pages/linked_chart.h"
#include "gui/pages/timed_list.h"
#include "gui/pages/timeline.h"
#include "gui/views/heat_look.h"
#include "gui/views/operator_view.h"
#include "gui/views/replay_marks.h"

namespace vallecula::gui::window_test {
namespace {

TEST_F(WindowReplay, TheAttemptsTimeStandsInAPauseAsInTheResult) {
  const test::Sandbox box;
  TrialSetup with_pause = setup(box.folder());
  std::string csv = "# fault unplugged 0.8 0.3\nt,x,y,z,qw,qx,qy,qz\n";
  for (const char* row :
       {"0,0,0.005,0.006", "0.2,0,0.005,0.002", "0.6,0,0.005,-0.0025", "3.0,0,0.005,-0.0025", "3.2,0,0.005,0.006"})
    csv += std::string(row) + ",0,0.70710678118654752,-0.70710678118654752,0\n";
  test::write_text(box / "held.csv", csv);
  with_pause.device = "scripted:" + (box / "held.csv").string();
  TrialSession session(with_pause);
  session.start();
  ASSERT_TRUE(wait_for([&] { return session.finished(); }));
  const curricula::Score score = session.finish("ended").score;
  ASSERT_EQ(score.pauses.size(), 1u);
  const curricula::Pause pause = score.pauses.front();
  ASSERT_GE(pause.for_s, 0.3);
  ASSERT_NEAR(score.attempt_paused_s, pause.for_s, 1e-9) << "in the middle of the attempt";

  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, with_pause.out);
  const auto attempt = [&](double at_s) {
    page.seek(at_s);
    for (const auto* label : page.findChildren<QLabel*>()) {
      const auto found = QRegularExpression("attempt (\\d+\\.\\d) s").match(label->text());
      if (found.hasMatch()) return found.captured(1).toDouble();
    }
    return -1.0;
  };
  const double begun_s = score.attempt_start_s;
  EXPECT_NEAR(attempt(pause.at_s - 0.1), pause.at_s - 0.1 - begun_s, 0.051);
  const double stands = attempt(pause.at_s + 0.02);
  EXPECT_NEAR(stands, pause.at_s - begun_s, 0.051);
  EXPECT_EQ(attempt(pause.at_s + pause.for_s - 0.02), stands);
  EXPECT_NEAR(attempt(begun_s + score.attempt_time_s + pause.for_s - 0.001), score.attempt_time_s, 0.051)
      << "as the result has it";
  const auto labels = page.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* one) {
    return one->text().contains("with pauses");
  })) << "the film's own clock goes on";
}

TEST_F(WindowReplay, GoesToAnySecondByKeysTimelineChartAndList) {
  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, trial());
  EXPECT_EQ(window.page_name(), "replay");
  const auto frame_of = [&](double at_s) { return static_cast<long long>(page.film().frame_at(at_s)); };
  EXPECT_EQ(page.time_s(), 0.0);

  key(page, Qt::Key_Right);
  EXPECT_EQ(page.shown_frame(), 1);
  EXPECT_DOUBLE_EQ(page.time_s(), page.film().time_s(1));
  key(page, Qt::Key_Right);
  key(page, Qt::Key_Left);
  EXPECT_EQ(page.shown_frame(), 1);
  key(page, Qt::Key_End);
  EXPECT_EQ(page.shown_frame(), static_cast<long long>(page.film().plan().frames) - 1);
  key(page, Qt::Key_Home);
  EXPECT_EQ(page.shown_frame(), 0);

  auto& timeline = *page.findChild<Timeline*>("timeline");
  QTest::mouseClick(&timeline, Qt::LeftButton, Qt::NoModifier, QPoint(std::lround(timeline.x_of(0.9)), 30));
  // Where an event is marked within a few pixels, that is meant.
  EXPECT_NEAR(page.time_s(), 0.9, timeline.time_at(20.0) - timeline.time_at(12.0));
  EXPECT_EQ(page.shown_frame(), frame_of(page.time_s()));
  key(timeline, Qt::Key_Left);
  EXPECT_EQ(page.shown_frame(), frame_of(page.time_s())) << "the slider leaves keys to the page";

  auto& chart = *page.findChild<LinkedChart*>("force_chart");
  ASSERT_TRUE(wait_for([&] { return chart.drawn(); }));
  QTest::mouseClick(&chart, Qt::LeftButton, Qt::NoModifier, QPoint(std::lround(chart.x_of(0.6)), 60));
  EXPECT_NEAR(page.time_s(), 0.6, 0.01);

  auto& events = *page.findChild<TimedList*>("events");
  ASSERT_GT(events.count(), 0);
  page.seek(0.0);
  // The attempt's end is the end of its last tick; no later moment than that tick can be shown.
  const double end_s = page.film().time_s(page.film().plan().frames - 1);
  int jumps = 0;
  for (int i = 0; i < events.count(); ++i) {
    if (events.time_of(i) < page.time_s() + 1e-3) continue;
    key(page, Qt::Key_PageDown);
    ++jumps;
    EXPECT_NEAR(page.time_s(), std::min(events.time_of(i), std::max(end_s, page.time_s())), 1e-9);
    EXPECT_DOUBLE_EQ(timeline.marked_s(), events.time_of(i));
  }
  EXPECT_GT(jumps, 1);
  const double last_s = page.time_s();
  key(page, Qt::Key_PageDown);
  EXPECT_DOUBLE_EQ(page.time_s(), last_s) << "there is no later one";
  key(page, Qt::Key_Home);
  key(page, Qt::Key_PageUp);
  EXPECT_EQ(page.time_s(), 0.0);

  // A reason is looked at from two seconds before; of a trial of 1.2 s, from its beginning.
  auto& reasons = *page.findChild<TimedList*>("reasons");
  int with_second = -1;
  for (int row = 0; row < reasons.count(); ++row)
    if (reasons.time_of(row) > 0.0) with_second = row;
  ASSERT_GE(with_second, 0);
  page.seek(1.0);
  reasons.setCurrentRow(with_second);
  key(reasons, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(page.time_s(), std::max(0.0, reasons.time_of(with_second) - kBeforeReason_s));
  EXPECT_DOUBLE_EQ(timeline.marked_s(), reasons.time_of(with_second));

  keep_picture(window, "replay-block.png");
  key(page, Qt::Key_Escape);
  EXPECT_FALSE(page.is_open());
}

TEST_F(WindowReplay, ThatAnotherBuildRecordedItStandsInALineOfItsOwn) {
  const test::Sandbox box;
  const TrialSetup given = setup(box.folder());
  curricula::TrialLog log = curricula::read_trial_log(trial());
  std::filesystem::create_directories(given.out);
  const auto write_as = [&](const std::string& build) {
    curricula::LogHeader header = log.header;
    header.package_path = given.patient.string();
    header.build_hash = build;
    curricula::TrialLogWriter writer(given.out / "trial.vtrial", header);
    for (const curricula::LogTick& tick : log.ticks) writer.append(tick);
    writer.close(log.footer);
  };
  for (const bool other : {true, false}) {
    write_as(other ? std::string(64, '7') : log.header.build_hash);
    MainWindow window;
    window.resize(1024, 700);
    window.show();
    ReplayPage& page = opened(window, given.out, 60000, given.patient);
    auto* line = page.findChild<QLabel*>("replay_notice");
    ASSERT_NE(line, nullptr);
    ASSERT_EQ(line->isVisible(), other);
    if (!other) continue;
    EXPECT_TRUE(line->text().startsWith("Recorded by another build (")) << line->text().toStdString();
    EXPECT_TRUE(line->text().contains("777777777777"));
    EXPECT_LE(line->fontMetrics().boundingRect(line->rect(), Qt::TextWordWrap, line->text()).height(), line->height())
        << "all of it can be read";
    for (const auto* label : page.findChildren<QLabel*>()) {
      EXPECT_EQ(label->text().contains("another build"), label == line) << "nor does it fill another's place";
    }
    keep_picture(window, "replay-another-build.png");
  }
}

TEST_F(WindowReplay, PlaysAtFiveSpeedsToItsEnd) {
  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, trial());
  EXPECT_EQ(page.rate(), 1.0);
  for (int i = 0; i < 9; ++i) key(page, Qt::Key_Minus);
  EXPECT_EQ(page.rate(), 0.25);
  key(page, Qt::Key_Space);
  ASSERT_TRUE(page.playing());
  QElapsedTimer passed;
  passed.start();
  ASSERT_TRUE(wait_for([&] { return page.time_s() > 0.1; }));
  EXPECT_GT(passed.elapsed(), 350) << "a tenth of a second takes four";
  key(page, Qt::Key_Space);
  const double stands = page.time_s();
  QTest::qWait(120);
  EXPECT_EQ(page.time_s(), stands);
  for (int i = 0; i < 9; ++i) key(page, Qt::Key_Plus);
  EXPECT_EQ(page.rate(), 4.0);
  key(page, Qt::Key_Space);
  ASSERT_TRUE(wait_for([&] { return !page.playing(); }, 10000)) << "it stops at its end";
  EXPECT_NEAR(page.time_s(), 1.2, 0.01);
  key(page, Qt::Key_Space);
  EXPECT_TRUE(page.playing()) << "and begins anew from there";
  EXPECT_LT(page.time_s(), 0.5);
}

TEST_F(WindowReplay, ShowsForcesPathAndLetsTheEyeGoRound) {
  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, trial());
  page.seek(0.6);  // pressed
  const auto settle = [&] { QTest::qWait(100); };
  settle();
  EXPECT_EQ(page.operator_marks().arrows_shown(), 1);
  OperatorView& view = page.operator_view();
  const QImage with = view.picture();
  key(page, Qt::Key_A);
  settle();
  EXPECT_EQ(page.operator_marks().arrows_shown(), 0);
  const QImage without = view.picture();
  EXPECT_GT(difference(with, without).pixels, 20) << "the arrow is seen through whatever lies before it";
  EXPECT_EQ(page.operator_marks().path_points_shown(), 0u);
  key(page, Qt::Key_P);
  settle();
  EXPECT_EQ(page.operator_marks().path_points_shown(), 30u) << "each 20 ms until the frame of 0.594 s";
  EXPECT_GT(difference(view.picture(), without).pixels, 20);
  key(page, Qt::Key_P);

  key(page, Qt::Key_F);
  EXPECT_TRUE(view.free_camera());
  const auto mouse = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, view.mapToGlobal(at), button, buttons, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
  };
  mouse(QEvent::MouseButtonPress, {200, 120}, Qt::LeftButton, Qt::LeftButton);
  mouse(QEvent::MouseMove, {320, 140}, Qt::NoButton, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, {320, 140}, Qt::LeftButton, Qt::NoButton);
  const QImage turned = view.picture();
  EXPECT_GT(difference(turned, without).pixels, 500);
  key(page, Qt::Key_Left, Qt::ShiftModifier);
  settle();
  EXPECT_GT(difference(view.picture(), turned).pixels, 200) << "by keys as well";
  const QImage before = view.picture();
  page.seek(0.9);
  EXPECT_GT(difference(view.picture(), before).pixels, 0);
  page.seek(0.6);
  EXPECT_LT(difference(view.picture(), before).pixels, 20) << "it stays where it was put";
  key(page, Qt::Key_F);
  settle();
  EXPECT_LT(difference(view.picture(), without).pixels, 20) << "back at the operator's eye";

  const QString png = QString::fromStdString((*shared_ / "seen.png").string());
  page.save_picture(png);
  const QImage saved(png);
  EXPECT_GT(saved.width(), view.picture().width());
  EXPECT_GT(colours_in(saved), 10);
  EXPECT_THROW(page.save_picture("/nonexistent/seen.png"), std::runtime_error);
  const auto told = [&] {
    const auto labels = page.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->toolTip().contains("Saved: " + png); });
  };
  EXPECT_TRUE(wait_for(told, 5000)) << "where it is";
  page.seek(0.3);
  EXPECT_TRUE(wait_for([&] { return !told(); }, 5000)) << "until one goes on";
}

TEST_F(WindowReplay, ColoursWhatWasPressedByHowHard) {
  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, trial());
  ContactHeat& heat = page.heat();
  ASSERT_TRUE(wait_for([&] { return heat.computed() == page.film().plan().frames; }));
  const auto sum = [](const std::vector<float>& kpa) { return std::accumulate(kpa.begin(), kpa.end(), 0.0); };
  EXPECT_EQ(sum(heat.peaks_until(0)), 0.0) << "the blade is still above";
  const std::vector<float> at_half = heat.peaks_until(page.film().frame_at(0.6));
  const std::vector<float> at_end = heat.peaks_until(page.film().plan().frames - 1);
  EXPECT_GT(sum(at_half), 0.0);
  for (std::size_t i = 0; i < at_end.size(); ++i) EXPECT_GE(at_end[i], at_half[i]) << "a peak stays";
  EXPECT_EQ(heat.peaks_until(page.film().frame_at(0.6)), at_half) << "and goes when one goes back";
  EXPECT_FLOAT_EQ(*std::max_element(at_end.begin(), at_end.end()), heat.highest_kpa());

  page.findChild<QCheckBox*>("arrows")->setChecked(false);
  // The page is laid out once more after it is first shown: pictures are compared when that is over.
  QSize size;
  ASSERT_TRUE(
      wait_for([&] { return std::exchange(size, page.operator_view().size()) == page.operator_view().size(); }));
  auto& box = *page.findChild<QCheckBox*>("heat");
  const auto pixels_changed = [&](double at_s) {
    page.seek(at_s);
    box.setChecked(false);
    const QImage plain = page.operator_view().picture();
    key(page, Qt::Key_C);
    EXPECT_TRUE(box.isChecked());
    const QImage coloured = page.operator_view().picture();
    int changed = 0;
    for (int y = 0; y < plain.height(); ++y)
      for (int x = 0; x < plain.width(); ++x) changed += plain.pixel(x, y) != coloured.pixel(x, y);
    return changed;
  };
  EXPECT_EQ(pixels_changed(0.0), 0);
  EXPECT_GT(pixels_changed(1.19), 100) << "what was pressed stays coloured once the blade is off it";
  const auto labels = page.findChildren<QLabel*>();
  const QString scale = QString("%1 kPa and more, in every trial; at most %2 kPa in this one")
                            .arg(kHeatTopKpa)
                            .arg(heat.highest_kpa(), 0, 'f', 1);
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text().contains(scale); }))
      << scale.toStdString();
}

}  // namespace
}  // namespace vallecula::gui::window_test

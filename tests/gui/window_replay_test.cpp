// The replay page as a person uses it: from the result or from a trial's folder to any second of it.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDesktopServices>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QtTest/QtTest>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <utility>

#include "curricula/records/notes.h"
#include "curricula/records/recovery.h"
#include "gui/pages/clip_export.h"
#include "gui/pages/linked_chart.h"
#include "gui/pages/main_window.h"
#include "gui/pages/notes_panel.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/timed_list.h"
#include "gui/pages/timeline.h"
#include "gui/session/user_paths.h"
#include "gui/views/heat_look.h"
#include "gui/views/operator_view.h"
#include "gui/views/replay_marks.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

/// One trial of 1.2 s, done as fast as it goes, is looked at by all.
class WindowReplay : public Screen {
 protected:
  static void SetUpTestSuite() {
    Screen::SetUpTestSuite();
    shared_ = std::make_unique<test::Sandbox>();
    ::setenv("VALLECULA_HOME", shared_->home().c_str(), 1);
    TrialSession session(setup(shared_->folder()));
    session.start();
    ASSERT_TRUE(wait_for([&] { return session.finished(); }));
    session.finish("ended");
  }
  static void TearDownTestSuite() {
    shared_.reset();
    Screen::TearDownTestSuite();
  }
  static TrialSetup setup(const fs::path& folder) {
    TrialSetup setup;
    setup.patient = test::write_block_patient(folder);
    setup.curriculum = test::write_curriculum(folder);
    setup.scenario = "plain";
    setup.device = "scripted:" + test::write_press(folder).string();
    setup.out = folder / "out";
    setup.realtime = false;
    return setup;
  }
  static fs::path trial() { return *shared_ / "out"; }
  static void key(QWidget& widget, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&widget, static_cast<Qt::Key>(key), modifiers);
  }
  /// Opened, all of it computed.
  static ReplayPage& opened(MainWindow& window, const fs::path& trial, int timeout_ms = 60000,
                            const fs::path& patient = {}) {
    bool there = false;
    QString failure;
    QObject::connect(&window, &MainWindow::replay_opened, [&] { there = true; });
    QObject::connect(&window, &MainWindow::replay_failed, [&](const QString& message) { failure = message; });
    window.replay(trial, -1.0, patient);
    EXPECT_EQ(window.page_name(), "prepare") << "the window does not wait";
    EXPECT_TRUE(wait_for([&] { return there || !failure.isEmpty(); }));
    if (!there) throw std::runtime_error("not opened: " + failure.toStdString());
    ReplayPage& page = window.replay_page();
    EXPECT_TRUE(wait_for([&] { return page.film().finished() && page.shown_frame() >= 0; }, timeout_ms));
    return page;
  }

  static inline std::unique_ptr<test::Sandbox> shared_;
};

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
  ASSERT_TRUE(wait_for([&] { return std::exchange(size, page.operator_view().size()) == page.operator_view().size(); }));
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

/// What an MP4 file says of its one track (ISO/IEC 14496-12: tkhd, mdhd, stsz, stts).
struct Mp4 {
  int width = 0, height = 0;
  double length_s = 0.0;
  long long frames = 0;
  bool h264 = false;
};
Mp4 mp4_of(const fs::path& file) {
  const std::string bytes = test::text_of(file);
  const auto number = [&](std::size_t at) {
    long long value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
  };
  Mp4 found;
  const std::size_t track = bytes.find("tkhd"), media = bytes.find("mdhd"), sizes = bytes.find("stsz");
  if (bytes.compare(4, 4, "ftyp") != 0 || track == std::string::npos || media == std::string::npos ||
      sizes == std::string::npos || bytes.at(track + 4) != 0 || bytes.at(media + 4) != 0)
    return found;
  found.width = static_cast<int>(number(track + 80) >> 16);
  found.height = static_cast<int>(number(track + 84) >> 16);
  found.length_s = static_cast<double>(number(media + 20)) / static_cast<double>(number(media + 16));
  found.frames = number(sizes + 12);
  found.h264 = bytes.find("avcC") != std::string::npos;
  return found;
}

TEST_F(WindowReplay, SavesAClipOrNothing) {
  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, trial());
  EXPECT_NEAR(page.computed_s(), 1.2, 0.04);
  const fs::path file = *shared_ / "clip.mp4";
  const auto dialog = [&] {
    return std::make_unique<ClipExport>([&page](double at_s) { return page.picture_of(at_s); }, 0.3, page.computed_s(),
                                        1.0 / kFilmRateHz);
  };
  auto whole = dialog();
  whole->set_span(0.3, 0.6);
  whole->start(QString::fromStdString(file.string()));
  ASSERT_TRUE(wait_for([&] { return whole->result() == QDialog::Accepted; }));
  const QSize size = page.picture().size();
  const Mp4 clip = mp4_of(file);
  EXPECT_TRUE(clip.h264);
  EXPECT_EQ(clip.width, size.width() & ~1) << "no odd side";
  EXPECT_EQ(clip.height, size.height() & ~1);
  EXPECT_EQ(clip.frames, 10) << "0.3 s and both its ends";
  EXPECT_NEAR(clip.length_s, 10 / 30.0, 1e-3);
  cv::VideoCapture player(file.string());
  cv::Mat first;
  ASSERT_TRUE(player.read(first));
  const QImage meant = page.picture_of(0.3).convertToFormat(QImage::Format_BGR888);
  const cv::Scalar shown = cv::mean(first);
  double means[3] = {0, 0, 0};
  for (int y = 0; y < first.rows; ++y)
    for (int x = 0; x < 3 * first.cols; ++x) means[x % 3] += meant.constScanLine(y)[x];
  for (int channel = 0; channel < 3; ++channel)  // a lossy clip: within three grey levels on average
    EXPECT_NEAR(shown[channel], means[channel] / first.rows / first.cols, 3.0) << channel;

  auto cancelled = dialog();
  const fs::path other = *shared_ / "other.mp4";
  cancelled->start(QString::fromStdString(other.string()));
  ASSERT_TRUE(wait_for([&] { return page.time_s() > 0.35; }));
  cancelled->reject();
  EXPECT_FALSE(fs::exists(other));
  EXPECT_FALSE(fs::exists(*shared_ / "other.mp4.part.mp4"));
  auto nowhere = dialog();
  nowhere->start("/nonexistent/clip.mp4");
  EXPECT_FALSE(nowhere->working());
  const auto labels = nowhere->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text().contains("/nonexistent/clip.mp4");
  }));
}

TEST_F(WindowReplay, KeepsNotesAtTheirSecond) {
  MainWindow window;
  window.show();
  ReplayPage& page = opened(window, trial());
  auto& notes = *page.findChild<NotesPanel*>();
  auto& text = *page.findChild<QLineEdit*>("note");
  ASSERT_TRUE(wait_for([&] { return text.isEnabled(); }));
  page.seek(0.5);
  key(page, Qt::Key_Space);
  ASSERT_TRUE(page.playing());
  key(page, Qt::Key_N);
  EXPECT_FALSE(page.playing());
  page.seek(0.5);
  EXPECT_EQ(page.focusWidget(), &text);
  QTest::keyClicks(&text, "here the wrist turned");
  EXPECT_EQ(page.time_s(), 0.5) << "what is typed is text";
  page.seek(0.8);  // to look what came of it
  key(text, Qt::Key_Return);
  auto& list = *notes.findChild<TimedList*>();
  ASSERT_TRUE(wait_for([&] { return list.count() == 1; }));
  EXPECT_DOUBLE_EQ(list.time_of(0), 0.5);
  EXPECT_EQ(text.text(), "");
  key(text, Qt::Key_Escape);
  EXPECT_TRUE(page.is_open()) << "out of the note, not out of the replay";
  page.seek(0.0);
  QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, list.visualItemRect(list.item(0)).center());
  EXPECT_DOUBLE_EQ(page.time_s(), 0.5);

  curricula::Records records(records_database());
  curricula::Notes noted(records);
  const long long of_it = noted.trial_of_log(curricula::log_sha256(trial() / "trial.vtrial"));
  ASSERT_NE(of_it, 0);
  const auto kept = noted.of_trial({}, of_it);
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].text, "here the wrist turned");
  EXPECT_DOUBLE_EQ(kept[0].at_s, 0.5);
}

TEST_F(WindowReplay, IsReachedFromTheResultAndItsReasons) {
  MainWindow window;
  window.show();
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&] { finished = true; });
  const test::Sandbox own;
  const TrialSetup missing = setup(own.folder());
  // A limit that the press passes: the reason has a second.
  std::string curriculum = test::text_of(missing.curriculum);
  for (const auto& [limit, low] : {std::pair<std::string, std::string>{"peak_tongue_force_n: 6.8", "peak_tongue_force_n: 0.1"},
                                   {"tongue_force_n: 5.0", "tongue_force_n: 0.1"}}) {
    ASSERT_NE(curriculum.find(limit), std::string::npos);
    curriculum.replace(curriculum.find(limit), limit.size(), low);
  }
  test::write_text(missing.curriculum, curriculum);
  QString trial_failure;
  QObject::connect(&window, &MainWindow::trial_failed, [&](const QString& message) { trial_failure = message; });
  window.prepare(missing, true);
  ASSERT_TRUE(wait_for([&] { return finished || !trial_failure.isEmpty(); }));
  ASSERT_EQ(trial_failure.toStdString(), "");
  auto& result = *window.findChild<ResultPage*>();
  auto& reasons = *result.findChild<QLabel*>("reasons");
  const QString text = reasons.text();
  const int link = text.indexOf("href='");
  ASSERT_GE(link, 0) << text.toStdString();
  const QString at_s = text.mid(link + 6, text.indexOf("'", link + 6) - link - 6);
  keep_picture(window, "result-links.png");
  // No browser: Qt says so of a handler that there is not, as it does of a program.
  QDesktopServices::setUrlHandler("file", &window, "no_such_slot");
  result.findChild<QPushButton*>("report")->click();
  QDesktopServices::unsetUrlHandler("file");
  const std::string report = (own / "out" / "report.html").string();
  const auto said = result.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [&](const QLabel* label) {
    return label->isVisible() && label->text().contains(QString::fromStdString(report));
  })) << "nobody waits for a report that does not come";
  keep_picture(window, "result-no-browser.png");
  bool there = false;
  QObject::connect(&window, &MainWindow::replay_opened, [&] { there = true; });
  emit reasons.linkActivated(at_s);
  ASSERT_TRUE(wait_for([&] { return there; }));
  ReplayPage& page = window.replay_page();
  EXPECT_DOUBLE_EQ(page.findChild<Timeline*>("timeline")->marked_s(), at_s.toDouble());
  EXPECT_DOUBLE_EQ(page.time_s(), std::max(0.0, at_s.toDouble() - kBeforeReason_s));
  key(page, Qt::Key_Escape);
  EXPECT_EQ(window.page_name(), "result") << "back where one came from";

  // The patient has gone since: one sentence, and the result is still there.
  fs::rename(own / "block.patient", own / "gone");
  QString failure;
  QObject::connect(&window, &MainWindow::replay_failed, [&](const QString& message) { failure = message; });
  QTest::mouseClick(result.findChild<QPushButton*>("replay"), Qt::LeftButton);
  ASSERT_TRUE(wait_for([&] { return !failure.isEmpty(); }));
  EXPECT_EQ(window.page_name(), "result");
  EXPECT_TRUE(failure.contains("block.patient")) << failure.toStdString();
}

TEST_F(WindowReplay, BeginsAtTheVerySecondThatIsAskedFor) {
  MainWindow window;
  window.show();
  bool there = false;
  QObject::connect(&window, &MainWindow::replay_opened, [&] { there = true; });
  window.replay(trial(), 1.0);
  ASSERT_TRUE(wait_for([&] { return there; }));
  ReplayPage& page = window.replay_page();
  EXPECT_DOUBLE_EQ(page.time_s(), 1.0) << "as `vallecula replay --window --at 1` asks";
  EXPECT_DOUBLE_EQ(page.findChild<Timeline*>("timeline")->marked_s(), 1.0);
}

TEST_F(WindowReplay, OfAnAssessmentIsLockedAndSaysWhy) {
  MainWindow window;
  window.show();
  bool finished = false;
  QObject::connect(&window, &MainWindow::trial_finished, [&] { finished = true; });
  const test::Sandbox own;
  TrialSetup assessed = setup(own.folder());
  assessed.mode = curricula::Mode::assessment;
  window.prepare(assessed, true);
  ASSERT_TRUE(wait_for([&] { return finished; }));
  auto& result = *window.findChild<ResultPage*>();
  auto& button = *result.findChild<QPushButton*>("replay");
  EXPECT_FALSE(button.isEnabled());
  EXPECT_TRUE(button.toolTip().contains("assessment"));
  EXPECT_FALSE(result.findChild<QLabel*>("reasons")->text().contains("href"));
  QString failure;
  QObject::connect(&window, &MainWindow::replay_failed, [&](const QString& message) { failure = message; });
  window.replay(own / "out");
  ASSERT_TRUE(wait_for([&] { return !failure.isEmpty(); }));
  EXPECT_TRUE(failure.contains("assessment")) << failure.toStdString();
}

// Any trial, to be looked at: VALLECULA_TRIAL=DIR VALLECULA_PICTURES=DIR, and VALLECULA_PATIENT=PACKAGE if it was moved.
TEST_F(WindowReplay, PicturesOfATrialOfOnesOwn) {
  const char* trial = std::getenv("VALLECULA_TRIAL");
  if (trial == nullptr || std::getenv("VALLECULA_PICTURES") == nullptr)
    GTEST_SKIP() << "VALLECULA_TRIAL and VALLECULA_PICTURES name a trial and a folder for its pictures";
  MainWindow window;
  window.show();
  const char* patient = std::getenv("VALLECULA_PATIENT");
  ReplayPage& page = opened(window, trial, 600000, patient != nullptr ? patient : "");
  const auto take = [&](const char* name) {
    QTest::qWait(700);
    keep_picture(window, name);
  };
  const auto& events = *page.findChild<TimedList*>("events");
  page.look_at(events.count() > 2 ? events.time_of(events.count() / 2) : 1.0);
  page.seek(page.time_s() + kBeforeReason_s);
  take("replay-1.png");
  key(page, Qt::Key_P);
  key(page, Qt::Key_X);
  take("replay-2-paths.png");
  key(page, Qt::Key_F);
  key(page, Qt::Key_H);
  for (int i = 0; i < 12; ++i) key(page, Qt::Key_Right, Qt::ShiftModifier);
  take("replay-3-free.png");
  page.save_picture(QString(std::getenv("VALLECULA_PICTURES")) + "/replay-4-saved.png");
  key(page, Qt::Key_F);
  key(page, Qt::Key_N);
  key(page, Qt::Key_End);
  take("replay-5-end.png");
  key(page, Qt::Key_Escape);
  page.findChild<QTabWidget*>("charts")->setCurrentIndex(1);
  page.findChild<QTabWidget*>("lists")->setCurrentIndex(1);
  page.seek(18.0);
  take("replay-6-monitor.png");
  window.resize(1024, 700);
  take("replay-7-small.png");
}

}  // namespace
}  // namespace vallecula::gui::window_test

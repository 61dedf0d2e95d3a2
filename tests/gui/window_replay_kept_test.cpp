// What is kept of a replay, and how one comes to it: clips, notes, the result's reasons, the lock of an assessment.
#include <QDesktopServices>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <algorithm>
#include <cstdlib>
#include <opencv2/videoio.hpp>
#include <utility>

#include "curricula/records/notes.h"
#include "curricula/records/recovery.h"
#include "gui/pages/clip_export.h"
#include "gui/pages/notes_panel.h"
#include "gui/pages/result_page.h"
#include "gui/pages/timed_list.h"
#include "gui/pages/timeline.h"
#include "gui/session/user_paths.h"
#include "gui/views/operator_view.h"
#include "tests/gui/window_replay.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

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
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                          [](const QLabel* label) { return label->text().contains("/nonexistent/clip.mp4"); }));
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
  EXPECT_LE(text.geometry().top() - list.geometry().bottom(), notes.layout()->spacing() + 8)
      << "nothing empty takes room between list and line";
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
  for (const auto& [limit, low] :
       {std::pair<std::string, std::string>{"peak_tongue_force_n: 6.8", "peak_tongue_force_n: 0.1"},
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

// Any trial, to be looked at: VALLECULA_TRIAL=DIR VALLECULA_PICTURES=DIR, and VALLECULA_PATIENT=PACKAGE if it was
// moved.
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

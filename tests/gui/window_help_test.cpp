// The help: its chapters are all there, and its pictures look like the pages of today. VALLECULA_HELP_PICTURES=DIR
// writes the pictures anew; copied to gui/help they are in the next build.
#include <QApplication>
#include <QBuffer>
#include <QDirIterator>
#include <QFile>
#include <QImageReader>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTest>
#include <QTextBrowser>
#include <QUrl>
#include <algorithm>
#include <map>

#include "gui/authoring/authoring_page.h"
#include "gui/import/import_wizard.h"
#include "gui/pages/chart_view.h"
#include "gui/pages/help_dialog.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/main_menu.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/trial_page.h"
#include "gui/session/languages.h"
#include "gui/session/user_paths.h"
#include "gui/views/gl_view.h"
#include "tests/gui/coarse_infant.h"
#include "tests/gui/program.h"
#include "tests/gui/window_home.h"
#include "tests/gui/window_screen.h"
#include "tests/gui/window_wishes.h"

namespace vallecula::gui::window_test {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 720;                ///< pixels of a stored picture
constexpr qint64 kMostBytes = 600 * 1024;  ///< of all pictures

QString text_of_chapter(const QString& chapter) {
  QFile file(":/help/" + chapter + ".md");
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << chapter.toStdString();
  return QString::fromUtf8(file.readAll());
}

QStringList named_pictures() {
  QStringList names;
  static const QRegularExpression picture("!\\[[^\\]]+\\]\\(([^)]+)\\)");
  for (const QString& chapter : help_chapters())
    for (auto match = picture.globalMatch(text_of_chapter(chapter)); match.hasNext();)
      names << match.next().captured(1);
  return names;
}

/// How far two pictures are apart as a person sees them from afar: both in 32 x 20 cells, the mean difference of a
/// cell's grey over the whole range. 0: the same; a page against another page is 0.1 and more, against itself with
/// other words, times and figures below 0.04.
double difference_from_afar(const QImage& a, const QImage& b) {
  const auto cells = [](const QImage& image) {
    return image.convertToFormat(QImage::Format_RGB32)
        .scaled(32, 20, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_Grayscale8);
  };
  const QImage x = cells(a), y = cells(b);
  double sum = 0.0;
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 32; ++column)
      sum += std::abs(qGray(x.pixel(column, row)) - qGray(y.pixel(column, row)));
  return sum / (32 * 20 * 255.0);
}
constexpr double kMostDifference = 0.06;
constexpr int kBusyMs = 300000;      ///< more than a whole trial takes on a busy machine
constexpr double kTubeNearS = 11.5;  ///< into the expert's trial: lifted, the glottis in sight, the tube on its way

class WindowHelp : public Screen {
 protected:
  WindowHelp() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowHelp() override {
    window_.reset();
    install_language(*qApp, "en");
    apply_look({});
    unsetenv("VALLECULA_HOME");
  }
  void keep(const QString& name) {
    for (int i = 0; i < 5; ++i) QApplication::processEvents(QEventLoop::AllEvents, 20);
    picture(name);
  }
  void picture(const QString& name) {
    keep_picture(*window_, "help-" + QString(name).replace(".jpg", ".png").toStdString());
    pictures_[name] = window_->grab().toImage().scaledToWidth(kWidth, Qt::SmoothTransformation);
  }
  /// Every page that the help shows. The trial is a scripted pair's intubation of the term infant with a coarse tongue,
  /// in lockstep: its pictures show the same moments on every machine.
  void go_through_the_window() {
    wish_words({});
    const fs::path patient = box_ / "infant.patient";
    fs::copy(test::coarse_infant(), patient, fs::copy_options::recursive);
    window_ = std::make_unique<MainWindow>();
    wish_size(*window_);
    window_->show_start({curricula::load_curriculum(default_curriculum()),
                         curricula::load_curriculum(curricula_folder() / "first-intubation.yaml")});
    window_->start_page().add_patient(patient, true);
    window_->show();
    QApplication::processEvents();
    keep("home.jpg");
    open_course_page(*window_);
    keep("course.jpg");
    for (const auto& [signal, picture] : std::initializer_list<std::pair<void (MainMenu::*)(), const char*>>{
             {&MainMenu::records_wanted, "records.jpg"},
             {&MainMenu::devices_wanted, "devices.jpg"},
             {&MainMenu::import_wanted, "import.jpg"}}) {
      (window_->menu().*signal)();
      wait_for([&] { return false; }, 400);  // lists are asked for on threads of their own
      keep(picture);
    }
    window_->write_course(default_curriculum());
    keep("authoring.jpg");
    emit window_->authoring_page().left();
    bool finished = false, replayed = false;
    QObject::connect(window_.get(), &MainWindow::trial_finished, [&] { finished = true; });
    QObject::connect(window_.get(), &MainWindow::replay_opened, [&] { replayed = true; });
    TrialSetup setup;
    setup.patient = patient;
    setup.curriculum = curricula_folder() / "first-intubation.yaml";
    setup.scenario = "term-tube";
    setup.device = "scripted:expert";
    setup.out = box_ / "out";
    setup.realtime = false;
    double shown_s = 0.0;
    window_->trial_page().set_frame_hook([&](const engine::Snapshot& seen) {
      if (shown_s == 0.0 && seen.time_s >= kTubeNearS) {
        shown_s = seen.time_s;
        picture("trial.jpg");
      }
      // As finely as can be where it is looked at, however slow the machine; coarsely on the way there and from there.
      if (shown_s == 0.0 && seen.time_s > kTubeNearS - 2.0)
        GlView::governor().hold(0);
      else
        GlView::governor().set_mode(QualityGovernor::Mode::low);
    });
    window_->prepare(setup, true);
    ASSERT_TRUE(wait_for([&] { return finished; }, kBusyMs));
    ASSERT_GT(shown_s, 0.0);
    ASSERT_TRUE(wait_for([&] {  // every curve is drawn on a thread of its own
      const auto charts = window_->findChild<ResultPage*>()->findChildren<ChartView*>();
      return charts.size() == 2 &&
             std::all_of(charts.begin(), charts.end(), [](const ChartView* chart) { return chart->drawn(); });
    }));
    keep("result.jpg");
    window_->replay(box_ / "out", shown_s + kBeforeReason_s);
    ASSERT_TRUE(wait_for([&] { return replayed; }, kBusyMs));
    ASSERT_TRUE(wait_for([&] { return window_->replay_page().computed_s() > shown_s; }, kBusyMs));
    GlView::governor().hold(0);
    wait_for([&] { return false; }, 500);
    keep("replay.jpg");
  }

  test::Sandbox box_;
  std::unique_ptr<MainWindow> window_;
  std::map<QString, QImage> pictures_;
};

TEST(HelpText, EveryChapterIsThereAndSaysSomething) {
  ASSERT_EQ(help_chapters().size(), 9);
  for (const QString& chapter : help_chapters()) {
    const QString text = text_of_chapter(chapter);
    EXPECT_TRUE(text.startsWith("# ")) << chapter.toStdString();
    EXPECT_GT(text.size(), 400) << chapter.toStdString();
  }
  for (const char* page :
       {"home", "start", "records", "devices", "import", "authoring", "prepare", "trial", "rating", "result", "replay"})
    EXPECT_TRUE(help_chapters().contains(help_chapter_of(page))) << page;
}

/// How a chapter is built: its headings, rows of tables and items, in their order.
QStringList build_of(const QString& text) {
  QStringList build;
  static const QRegularExpression part("^(#+ |\\||- |\\d+\\. )");
  for (const QString& line : text.split('\n'))
    if (const auto match = part.match(line); match.hasMatch()) build << match.captured(1);
  return build;
}

TEST(HelpText, EveryLanguageOfTheWindowHasEveryChapterWithTheSameParts) {
  static const QRegularExpression picture("!\\[[^\\]]+\\]\\(([^)]+)\\)");
  int others = 0;
  for (const Language& language : available_languages()) {
    if (language.code == "en") continue;
    ++others;
    for (const QString& chapter : help_chapters()) {
      const QString english = text_of_chapter(chapter), text = text_of_chapter(language.code + '/' + chapter);
      EXPECT_TRUE(text != english) << chapter.toStdString();
      EXPECT_EQ(build_of(text).join(' ').toStdString(), build_of(english).join(' ').toStdString())
          << chapter.toStdString() << " in " << language.name.toStdString();
      QStringList names, english_names;
      for (auto match = picture.globalMatch(text); match.hasNext();) names << match.next().captured(1);
      for (auto match = picture.globalMatch(english); match.hasNext();)
        english_names << "../" + match.next().captured(1);
      EXPECT_EQ(names.join(' ').toStdString(), english_names.join(' ').toStdString()) << chapter.toStdString();
    }
  }
  EXPECT_GE(others, 1);
}

TEST(HelpText, ItsPicturesAreThereNoneTooManyAndSmall) {
  const QStringList named = named_pictures();
  EXPECT_GE(named.size(), 9);
  qint64 bytes = 0;
  for (const QString& name : named) {
    QFile file(":/help/" + name);
    EXPECT_TRUE(file.exists()) << name.toStdString();
    bytes += file.size();
  }
  EXPECT_LT(bytes, kMostBytes);
  for (QDirIterator all(":/help", {"*.jpg", "*.png"}); all.hasNext();) {
    all.next();
    EXPECT_TRUE(named.contains(all.fileName())) << all.fileName().toStdString() << " is in no chapter";
  }
}

TEST_F(WindowHelp, ItsPicturesLookLikeThePagesOfToday) {
  go_through_the_window();
  ASSERT_FALSE(HasFatalFailure());
  if (const char* folder = std::getenv("VALLECULA_HELP_PICTURES")) {
    fs::create_directories(folder);
    for (const auto& [name, picture] : pictures_)
      ASSERT_TRUE(picture.save(QString::fromStdString((fs::path(folder) / name.toStdString()).string()), nullptr, 82));
    GTEST_SKIP() << "written to " << folder << "; copy them to gui/help and build again";
  }
  for (const QString& name : named_pictures()) {
    ASSERT_TRUE(pictures_.count(name)) << name.toStdString() << " is made by no page here";
    const double apart = difference_from_afar(pictures_[name], QImage(":/help/" + name));
    EXPECT_LT(apart, kMostDifference) << name.toStdString() << ": make it anew with VALLECULA_HELP_PICTURES=DIR";
  }
  // The scale tells pages apart.
  EXPECT_GT(difference_from_afar(pictures_["home.jpg"], QImage(":/help/trial.jpg")), kMostDifference);
  EXPECT_GT(difference_from_afar(pictures_["course.jpg"], QImage(":/help/replay.jpg")), kMostDifference);
}

TEST_F(WindowHelp, SpeaksTheLanguageOfTheWindow) {
  ASSERT_TRUE(install_language(*qApp, "de"));
  HelpDialog german;
  german.show_chapter("devices");
  install_language(*qApp, "en");
  auto* text = german.findChild<QTextBrowser*>();
  EXPECT_TRUE(text->toPlainText().contains("Haptische Ger\u00e4te")) << text->toPlainText().toStdString();
  EXPECT_EQ(german.findChild<QListWidget*>("chapters")->item(0)->text(), "Ihre erste Laryngoskopie");
  EXPECT_FALSE(text->loadResource(QTextDocument::ImageResource, QUrl("../devices.jpg")).isNull());
  HelpDialog english;
  english.show_chapter("devices");
  EXPECT_TRUE(english.findChild<QTextBrowser*>()->toPlainText().contains("Haptic devices"));
}

TEST_F(WindowHelp, ItsPicturesAreNoWiderThanItsText) {
  HelpDialog help;
  help.show();
  auto* text = help.findChild<QTextBrowser*>("help_text");
  ASSERT_NE(text, nullptr);
  const auto look_at_all = [&](const std::string& when) {
    for (const QString& chapter : help_chapters()) {
      help.show_chapter(chapter);
      EXPECT_TRUE(wait_for([&] { return text->horizontalScrollBar()->maximum() == 0; }, 5000))
          << chapter.toStdString() << when << ": " << text->horizontalScrollBar()->maximum() << " px too wide";
    }
  };
  look_at_all("");
  LookSettings large;
  large.text_scale = 1.35;
  apply_look(large);
  look_at_all(" with large text");
  help.resize(700, 720);
  look_at_all(" in a narrow window");
  apply_look({});
}

TEST_F(WindowHelp, F1OpensTheChapterOfThePage) {
  window_ = std::make_unique<MainWindow>();
  window_->show_start({curricula::load_curriculum(default_curriculum())});
  window_->show();
  QApplication::setActiveWindow(window_.get());
  emit window_->menu().devices_wanted();
  QTest::keyClick(window_.get(), Qt::Key_F1);
  auto* help = window_->findChild<HelpDialog*>();
  ASSERT_NE(help, nullptr);
  EXPECT_TRUE(help->isVisible());
  EXPECT_EQ(help->chapter(), "devices");
  EXPECT_TRUE(help->findChild<QTextBrowser*>()->toPlainText().contains("Haptic devices"));
  keep_picture(*help, "help.png");
  auto* chapters = help->findChild<QListWidget*>("chapters");
  chapters->setFocus();
  QTest::keyClick(chapters, Qt::Key_Home);
  EXPECT_TRUE(help->findChild<QTextBrowser*>()->toPlainText().contains("Your first laryngoscopy"));
  keep_picture(*help, "help-first.png");
  QApplication::setActiveWindow(help);  // as a window manager does
  QTest::keyClick(help, Qt::Key_Escape);
  EXPECT_FALSE(help->isVisible());
}

}  // namespace
}  // namespace vallecula::gui::window_test

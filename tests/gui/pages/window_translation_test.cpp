// The German translation is whole, keeps the places to be filled, and fits on the pages; every control has a name.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>
#include <set>

#include "curricula/scenario.h"
#include "gui/authoring/authoring_page.h"
#include "gui/import/import_wizard.h"
#include "gui/pages/device_dialog.h"
#include "gui/pages/devices_page.h"
#include "gui/session/languages.h"
#include "gui/pages/home_page.h"
#include "gui/pages/look_settings.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/result_page.h"
#include "gui/pages/self_rating_page.h"
#include "gui/pages/start_page.h"
#include "gui/records_pages/records_page.h"
#include "gui/report/markdown.h"
#include "gui/session/curricula_files.h"
#include "gui/session/user_paths.h"
#include "gui/session/words_from_below.h"
#include "tests/gui/accessible.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

struct Message {
  QString context, source;
  QStringList translations;
  bool finished = true, plural = false;
};

QString sources_folder() { return VALLECULA_SOURCE_DIR; }
QString german_file() { return sources_folder() + "/gui/translations/vallecula_de.ts"; }

std::vector<Message> messages_of(const QString& ts) {
  QFile file(ts);
  if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error(ts.toStdString() + ": cannot be read");
  QXmlStreamReader xml(&file);
  std::vector<Message> all;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == "name") context = xml.readElementText();
    if (xml.name() == "message") {
      all.push_back({context, {}, {}, true, xml.attributes().value("numerus") == "yes"});
    } else if (xml.name() == "source") {
      all.back().source = xml.readElementText();
    } else if (xml.name() == "translation") {
      all.back().finished = !xml.attributes().hasAttribute("type");
      if (!all.back().plural) all.back().translations << xml.readElementText();
    } else if (xml.name() == "numerusform") {
      all.back().translations << xml.readElementText();
    }
  }
  if (xml.hasError()) throw std::runtime_error(ts.toStdString() + ": " + xml.errorString().toStdString());
  return all;
}

/// Sorted: the places to be filled, tags, mnemonics, and whether blanks stand at the ends.
QStringList fixed_parts(const QString& text) {
  QStringList parts;
  static const QRegularExpression place("%(?:\\d|n)|</?[a-z]+[^>]*>|&[#a-z0-9]+;|\\.yaml|\\.patient");
  for (auto found = place.globalMatch(text); found.hasNext();) parts << found.next().captured();
  QString bare = text;
  bare.remove(place).remove("&&");
  if (bare.contains(QRegularExpression("&\\S"))) parts << "mnemonic";
  if (text.startsWith(' ')) parts << "blank before";
  if (text.endsWith(' ')) parts << "blank after";
  parts.sort();
  return parts;
}

TEST(Translation, EveryMessageIsFinishedAndKeepsItsFixedParts) {
  const std::vector<Message> all = messages_of(german_file());
  EXPECT_GT(all.size(), 900u);
  for (const Message& one : all) {
    const std::string which = one.context.toStdString() + ": " + one.source.toStdString();
    EXPECT_TRUE(one.finished) << which;
    EXPECT_EQ(one.translations.size(), one.plural ? 2 : 1) << which;
    for (int i = 0; i < one.translations.size(); ++i) {
      const QString& text = one.translations[i];
      EXPECT_FALSE(text.isEmpty()) << which;
      QStringList wanted = fixed_parts(one.source);
      if (one.plural && i == 0 && !text.contains("%n")) wanted.removeAll("%n");  // "one thing" may be a word
      EXPECT_EQ(fixed_parts(text).join(" ").toStdString(), wanted.join(" ").toStdString()) << which << "\n"
                                                                                           << text.toStdString();
    }
  }
}

TEST(Translation, GermanTellsATipFromAPeakAndABreathFromALift) {
  int peaks = 0, breaths = 0;
  const QRegularExpression tip("\\bSpitzen?\\b"),
      lift("\\b(Hub|Hübe|Hüben)\\b", QRegularExpression::UseUnicodePropertiesOption);
  for (const Message& one : messages_of(german_file())) {
    const QString all = one.translations.join(" ");
    if (one.source.contains(QRegularExpression("\\bpeak", QRegularExpression::CaseInsensitiveOption)) &&
        !one.source.contains(QRegularExpression("\\btip\\b"))) {
      ++peaks;
      EXPECT_FALSE(tip.match(all).hasMatch()) << all.toStdString();
    }
    if (one.source.contains("breath", Qt::CaseInsensitive)) {
      ++breaths;
      EXPECT_FALSE(lift.match(all).hasMatch()) << all.toStdString();
    }
  }
  EXPECT_GT(peaks, 5);
  EXPECT_GT(breaths, 30);
}

TEST(Translation, NoSentenceOfTheSourcesIsMissing) {
  const QString lupdate = QStandardPaths::findExecutable("lupdate");
  if (lupdate.isEmpty()) GTEST_SKIP() << "lupdate is not installed (qttools5-dev-tools), so sources were not read";
  const QTemporaryDir folder;
  const QString fresh = folder.filePath("fresh_de.ts");
  QProcess run;
  run.setWorkingDirectory(sources_folder());
  run.start(lupdate, {"-silent", "-I", ".", "gui", "-no-obsolete", "-locations", "none", "-source-language", "en",
                      "-target-language", "de", "-ts", fresh});
  ASSERT_TRUE(run.waitForFinished(60000) && run.exitCode() == 0) << run.readAllStandardError().toStdString();
  std::set<std::pair<QString, QString>> known;
  for (const Message& one : messages_of(german_file())) known.insert({one.context, one.source});
  const std::vector<Message> found = messages_of(fresh);
  EXPECT_GT(found.size(), 900u);
  for (const Message& one : found)
    EXPECT_TRUE(known.count({one.context, one.source}) > 0)
        << one.context.toStdString() << ": " << one.source.toStdString() << "\nrun lupdate (gui/README.md, Languages)";
}

/// All string literals below gui's pages, those that are written one after the other joined.
QString literals_below() {
  static const QRegularExpression between("\"\\s*\\n\\s*\"");
  QString all;
  for (const char* folder :
       {"curricula", "device", "pipeline", "gui/session", "gui/report", "gui/views", "gui/pages"}) {
    QDirIterator files(sources_folder() + "/" + folder, {"*.cpp", "*.h", "*.json"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      if (files.next().contains("/from_below/")) continue;  // the lists themselves
      QFile file(files.filePath());
      if (file.open(QIODevice::ReadOnly))
        all += QString::fromUtf8(file.readAll()).remove(between).replace("\\\"", "\"");
    }
  }
  return all;
}

TEST(Translation, WhatIsListedFromBelowIsStillSaidThere) {
  const QString below = literals_below();
  int looked_for = 0;
  for (const std::string& sentence : sentences_from_below()) {
    const QString text = QString::fromStdString(sentence);
    if (text.contains('%') || text.size() < 25) continue;  // put together there, or a single word
    ++looked_for;
    // The last words of one that is put together of two.
    EXPECT_TRUE(below.contains(text) || below.contains(text.mid(text.indexOf(": ") + 2)) ||
                below.contains(text.right(16)))
        << sentence;
  }
  EXPECT_GT(looked_for, 100);
}

class WindowTranslation : public Screen {
 protected:
  WindowTranslation() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowTranslation() override { install_language(*qApp, "en"); }

  static device::FoundDevice mouse() {
    device::FoundDevice one;
    one.name = "mouse";
    one.info.kind = "mouse";
    one.info.model = "mouse and keyboard";
    return one;
  }
  void look_at(QWidget& page, const std::string& name) {
    page.resize(room_);
    page.show();
    wait_for([] { return false; }, 150);
    EXPECT_LE(page.minimumSizeHint().width(), room_.width()) << name << lines(wider_than(page, room_.width() - 24));
    EXPECT_LE(page.minimumSizeHint().height(), room_.height()) << name;
    EXPECT_EQ(nameless_controls(page), std::vector<std::string>()) << name << lines(nameless_controls(page));
    EXPECT_EQ(unreachable_controls(page), std::vector<std::string>()) << name << lines(unreachable_controls(page));
    EXPECT_EQ(cut_texts(page), std::vector<std::string>()) << name << lines(cut_texts(page));
    EXPECT_EQ(keys_of_menus(page), std::vector<std::string>()) << name << lines(keys_of_menus(page));
    keep_picture(page, name + ".png");
    page.hide();
  }
  void look_at_all(const std::string& language) {
    ASSERT_TRUE(install_language(*qApp, QString::fromStdString(language)));
    const auto found = find_curricula().curricula;
    StartPage start;
    start.set_curricula(found);
    look_at(start, "start-" + language);
    DevicesPage devices(nullptr, [] { return std::vector<device::FoundDevice>{mouse()}; });
    look_at(devices, "devices-" + language);
    DeviceDialog settings(mouse().info);
    look_at(settings, "device-settings-" + language);
    RecordsPage records;
    look_at(records, "records-" + language);
    const HomePage home;
    const WhoStrip who(records.desk(), nullptr);
    for (const QWidget* one : {static_cast<const QWidget*>(&home), static_cast<const QWidget*>(&who)})
      EXPECT_EQ(keys_of_menus(*one), std::vector<std::string>()) << language << lines(keys_of_menus(*one));
    SelfRatingPage rating;
    rating.ask(*curricula::load_curriculum(curricula_folder() / "first-intubation.yaml").find("term-tube"));
    look_at(rating, "own-rating-" + language);
    ImportWizard import;
    import.begin();
    look_at(import, "import-" + language);
    AuthoringPage authoring;
    authoring.begin();
    look_at(authoring, "authoring-" + language);
    ReplayPage replay;
    look_at(replay, "replay-" + language);
    ResultPage result;
    look_at(result, "result-" + language);
    // The longest title there is beside each verdict that is a sentence.
    curricula::Scenario longest;
    for (const auto& one : found)
      for (const auto& scenario : one.scenarios)
        if (scenario.title.size() > longest.title.size()) longest = scenario;
    ASSERT_FALSE(longest.title.empty());
    TrialOutcome outcome;
    for (const bool at_vallecula : {true, false}) {
      outcome.score.at_vallecula = at_vallecula;
      outcome.score.set_aside = {at_vallecula ? "It began" : "It was changed"};
      result.show_outcome(outcome, longest, box_.folder(), {});
      look_at(result, std::string("result-") + (at_vallecula ? "helped-" : "changed-") + language);
    }
  }
  QSize room_{1024, 700};  ///< the smallest size that is promised
  test::Sandbox box_;
};

/// With text a third larger a page has 1280 x 800.
class WindowLargeText : public WindowTranslation {
 protected:
  WindowLargeText() {
    apply_look({"dark", 1.35});
    room_ = {1280, 800};
  }
  ~WindowLargeText() override { apply_look({}); }
};

TEST_F(WindowLargeText, GermanFitsOnThePages) { look_at_all("de"); }
TEST_F(WindowLargeText, EnglishFitsOnThePages) { look_at_all("en"); }

TEST_F(WindowTranslation, GermanFitsOnThePagesAndEveryControlHasAName) { look_at_all("de"); }
TEST_F(WindowTranslation, EnglishFitsOnThePagesAndEveryControlHasAName) { look_at_all("en"); }

TEST_F(WindowTranslation, ACoursesTextsComeInTheWindowsLanguageWhereItHasThem) {
  const curricula::Text both({{"en", "Lift along the handle."}, {"de", "Heben Sie den Griff."}});
  const curricula::Text english("Only English.");
  ASSERT_TRUE(install_language(*qApp, "de"));
  EXPECT_TRUE(html_of(both).contains("Heben Sie")) << html_of(both).toStdString();
  EXPECT_EQ(plain_of(english), "Only English.");
  ASSERT_TRUE(install_language(*qApp, "en"));
  EXPECT_TRUE(html_of(both).contains("Lift along"));
}

TEST_F(WindowTranslation, FiguresAreFilledIntoTheTranslatedSentence) {
  ASSERT_TRUE(install_language(*qApp, "de"));
  EXPECT_EQ(in_words("Peak force on the gums 4.20 N at 3.51 s, more than the 3 N allowed").toStdString(),
            u8"Höchste Kraft auf die Zahnleisten 4,20 N bei 3,51 s, mehr als die erlaubten 3 N");
  EXPECT_EQ(in_words("Glottis seen to 62.00 % at 7.10 s, at least the 50 % asked for").toStdString(),
            "Glottis bei 7,10 s zu 62,00 % gesehen, mindestens die verlangten 50 %");
  EXPECT_EQ(in_words("12 unknown things in 3 places").toStdString(), "12 unknown things in 3 places");
}

}  // namespace
}  // namespace vallecula::gui::window_test

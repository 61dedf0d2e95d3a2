// The window's languages: what is offered, what is taken at the start, and that the translations are whole.
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <cstdlib>

#include "gui/pages/devices_page.h"
#include "gui/session/languages.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"
#include "tests/gui/program.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

class WindowLanguages : public Screen {
 protected:
  WindowLanguages() { setenv("VALLECULA_HOME", box_.home().c_str(), 1); }
  ~WindowLanguages() override { install_language(*qApp, "en"); }
  static bool has_button(const QWidget& page, const QString& text) {
    const auto buttons = page.findChildren<QPushButton*>();
    return std::any_of(buttons.begin(), buttons.end(), [&](const QPushButton* one) { return one->text() == text; });
  }
  test::Sandbox box_;
};

TEST_F(WindowLanguages, EachIsOfferedByItsOwnName) {
  const std::vector<Language> all = available_languages();
  ASSERT_GE(all.size(), 2u);
  EXPECT_EQ(all[0].code, "en");
  EXPECT_EQ(all[0].name, "English");
  const auto german = std::find_if(all.begin(), all.end(), [](const Language& one) { return one.code == "de"; });
  ASSERT_NE(german, all.end());
  EXPECT_EQ(german->name, "Deutsch");
  EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const Language& one) { return one.code == "en"; }), 1);
}

TEST_F(WindowLanguages, TheChosenOneComesBeforeTheSystemsAndEnglishIsLast) {
  EXPECT_EQ(language_at_start({"fr-FR", "de-CH", "en"}), "de");
  keep_language("en");
  EXPECT_EQ(language_at_start({"de-DE"}), "en");
  keep_language("de");
  EXPECT_EQ(language_at_start({"en-GB"}), "de");
  keep_language("");
  EXPECT_EQ(language_at_start({"en-GB"}), "en");
  EXPECT_EQ(language_at_start({"xx"}), "en");
  EXPECT_EQ(language_at_start(), "en") << "the test's own system";
  user_settings()->setValue("language/code", "../xx");
  EXPECT_EQ(chosen_language(), "") << "one that is not there is not chosen";
  EXPECT_FALSE(install_language(*qApp, "xx"));
  EXPECT_EQ(language(), "en") << "nothing was changed";
}

TEST_F(WindowLanguages, EnglishIsTheSourcesAndGermanChangesAKnownButton) {
  const auto none = [] { return std::vector<device::FoundDevice>(); };
  ASSERT_TRUE(install_language(*qApp, "en"));
  const DevicesPage english(nullptr, none);
  EXPECT_TRUE(has_button(english, "Use this one"));
  ASSERT_TRUE(install_language(*qApp, "de"));
  EXPECT_EQ(language(), "de");
  const DevicesPage german(nullptr, none);
  EXPECT_TRUE(has_button(german, "Dieses verwenden"));
  EXPECT_EQ(in_words("Vallecula reached"), "Vallecula erreicht") << "what comes from the folders below, too";
  EXPECT_EQ(in_words("no such sentence 7"), "no such sentence 7");
  ASSERT_TRUE(install_language(*qApp, "en"));
  const DevicesPage again(nullptr, none);
  EXPECT_TRUE(has_button(again, "Use this one")) << "German has left";
}

}  // namespace
}  // namespace vallecula::gui::window_test

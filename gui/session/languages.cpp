#include "gui/session/languages.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>
#include <memory>

#include "gui/session/user_settings.h"

/// The files lie in a static library: without this the linker leaves them out. Must not stand in a namespace.
static void reach_languages() { Q_INIT_RESOURCE(languages); }

namespace vallecula::gui {
namespace {

constexpr const char *kSource = "en", *kSetting = "language/code";

struct Installed {
  QString code = kSource;
  std::vector<std::unique_ptr<QTranslator>> translators;
};
Installed& installed() {
  static Installed one;
  return one;
}

bool is_available(const QString& code) {
  const std::vector<Language> all = available_languages();
  return std::any_of(all.begin(), all.end(), [&code](const Language& one) { return one.code == code; });
}

}  // namespace

std::vector<Language> available_languages() {
  reach_languages();
  std::vector<Language> others;
  for (const QString& file : QDir(":/languages").entryList({"vallecula_*.qm"}, QDir::Files)) {
    const QString code = file.section('_', 1).section('.', 0, 0);
    if (code == kSource) continue;  // holds plurals only
    others.push_back({code, QLocale(code).nativeLanguageName()});
  }
  std::sort(others.begin(), others.end(), [](const Language& a, const Language& b) { return a.name < b.name; });
  others.insert(others.begin(), {kSource, "English"});
  return others;
}

QString chosen_language() {
  const QString code = user_settings()->value(kSetting).toString();
  return is_available(code) ? code : QString();
}

void keep_language(const QString& code) { user_settings()->setValue(kSetting, code); }

QString language_at_start(const QStringList& of_the_system) {
  const QString chosen = chosen_language();
  if (!chosen.isEmpty()) return chosen;
  for (const QString& wanted : of_the_system) {
    const QString code = wanted.section(QRegularExpression("[-_]"), 0, 0);
    if (is_available(code)) return code;
  }
  return kSource;
}

bool install_language(QCoreApplication& application, const QString& code) {
  if (!is_available(code)) return false;
  for (const auto& translator : installed().translators) application.removeTranslator(translator.get());
  installed() = Installed{code, {}};
  // Numbers, dates and a course's texts follow the words; where the system speaks this language its country is kept.
  const QLocale system = QLocale::system(), spoken(code);
  const bool same = system.language() == spoken.language() || (code == kSource && system.language() == QLocale::C);
  QLocale::setDefault(same ? system : spoken);
  const auto add = [&application](const QString& file) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(file)) return;
    application.installTranslator(translator.get());
    installed().translators.push_back(std::move(translator));
  };
  if (code != kSource) add(QLibraryInfo::location(QLibraryInfo::TranslationsPath) + "/qtbase_" + code);
  add(":/languages/vallecula_" + code);
  return true;
}

QString language() { return installed().code; }

}  // namespace vallecula::gui

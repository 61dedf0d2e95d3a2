// The window's languages: English is written in the sources, every other is a file gui/translations/vallecula_CODE.ts.
// vallecula_en.ts holds nothing but English plurals.
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <vector>

class QCoreApplication;

namespace vallecula::gui {

struct Language {
  QString code;  ///< ISO 639, as in the file's name; "en" for the sources' own
  QString name;  ///< as those who speak it call it
};
/// English first, then the others by name.
std::vector<Language> available_languages();

/// What a person chose (settings.ini, [language] code); empty: as the system has it. A language that is not there
/// counts as not chosen.
QString chosen_language();
/// From the next start of the program on; empty: as the system has it.
void keep_language(const QString& code);

/// The language of the window: the chosen one, else the first of the system's for which there is a translation, else
/// English.
QString language_at_start(const QStringList& of_the_system = QLocale::system().uiLanguages());

/// Has everything said in this language from now on, Qt's own buttons where their translation is installed; "en" takes
/// all others away. Pages that are open keep their words. False: there is no such language, and nothing was changed.
bool install_language(QCoreApplication& application, const QString& code);
/// What was installed last.
QString language();

}  // namespace vallecula::gui

#include "gui/pages/recent_entry.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <exception>

#include "curricula/scenario.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

QString recent_said(const char* text) { return QCoreApplication::translate("RecentFiles", text); }

/// Of the trial's scenario, as its score beside the log has it; empty: there is none.
QString scenario_title(const std::filesystem::path& trial) {
  const auto folder = trial.extension() == ".vtrial" ? trial.parent_path() : trial;
  QFile score(QString::fromStdString((folder / "score.json").string()));
  if (!score.open(QIODevice::ReadOnly)) return {};
  return QJsonDocument::fromJson(score.readAll()).object().value("scenario_title").toString();
}

QString course_title(const std::filesystem::path& course) {
  try {
    return QString::fromStdString(curricula::load_curriculum(course).title);
  } catch (const std::exception&) {
    return {};  // what is wrong with it is told when it is opened
  }
}

QString recent_words(const RecentFile& file) {
  if (file.kind == DroppedKind::trial) {
    const QString title = scenario_title(file.path);
    if (title.isEmpty()) return described(file);
    return recent_said(QT_TRANSLATE_NOOP("RecentFiles", "Trial: %1, %2"))
        .arg(course_words(title.toStdString()), QLocale().toString(file.changed, QLocale::ShortFormat));
  }
  if (file.kind != DroppedKind::course) return described(file);
  const QString title = course_title(file.path);
  if (title.isEmpty()) return described(file);
  return recent_said(QT_TRANSLATE_NOOP("RecentFiles", "Course: %1")).arg(course_words(title.toStdString()));
}

}  // namespace

std::vector<RecentEntry> with_words(const std::vector<RecentFile>& files) {
  std::vector<RecentEntry> entries;
  for (const RecentFile& file : files) entries.push_back({file, recent_words(file)});
  return entries;
}

}  // namespace vallecula::gui

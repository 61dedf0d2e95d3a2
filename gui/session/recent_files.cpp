#include "gui/session/recent_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QStringList>

#include "gui/session/user_settings.h"

namespace vallecula::gui {
namespace {

constexpr const char* kKey = "recent/files";
constexpr const char* kFolderKey = "recent/folder";

/// When it was made: a trial's folder changes with whatever is exported into it, its log does not.
QDateTime date_of(DroppedKind kind, const std::filesystem::path& path) {
  const std::filesystem::path log = path / "trial.vtrial";
  std::error_code none;
  const bool folder = kind == DroppedKind::trial && std::filesystem::exists(log, none);
  return QFileInfo(QString::fromStdString((folder ? log : path).string())).lastModified();
}

QString said(const char* text) { return QCoreApplication::translate("RecentFiles", text); }

}  // namespace

void remember_recent(const std::filesystem::path& path) {
  const QString first = QString::fromStdString(std::filesystem::absolute(path).string());
  const auto kept = user_settings();
  QStringList files = kept->value(kKey).toStringList();
  files.removeAll(first);
  files.prepend(first);
  kept->setValue(kKey, QStringList(files.mid(0, kMostRecent)));
}

QString folder_to_open() {
  const QString last = user_settings()->value(kFolderKey).toString();
  if (!last.isEmpty() && QFileInfo(last).isDir()) return last;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();  // not everybody has that folder
}

void keep_opened(const QString& path) { user_settings()->setValue(kFolderKey, QFileInfo(path).absolutePath()); }

std::vector<std::filesystem::path> kept_recent() {
  std::vector<std::filesystem::path> paths;
  for (const QString& file : user_settings()->value(kKey).toStringList()) paths.emplace_back(file.toStdString());
  return paths;
}

std::vector<RecentFile> still_there(const std::vector<std::filesystem::path>& paths) {
  std::vector<RecentFile> there;
  for (const auto& path : paths) {
    const Dropped found = what_was_dropped({path});
    if (found.kind == DroppedKind::nothing) continue;
    there.push_back({found.kind, path, date_of(found.kind, path)});
  }
  return there;
}

QString described(const RecentFile& file) {
  QString name = QString::fromStdString(file.path.stem().string());
  switch (file.kind) {
    case DroppedKind::patient:
      return said(QT_TRANSLATE_NOOP("RecentFiles", "Patient: %1")).arg(name);
    case DroppedKind::course:
      return said(QT_TRANSLATE_NOOP("RecentFiles", "Course: %1")).arg(name);
    case DroppedKind::trial: {
      if (file.path.extension() == ".vtrial") name = QString::fromStdString(file.path.parent_path().filename().string());
      name.remove(QRegularExpression("^\\d{8}-\\d{6}-"));  // the moment, which stands behind it in words
      return said(QT_TRANSLATE_NOOP("RecentFiles", "Trial: %1, %2"))
          .arg(name, QLocale().toString(file.changed, QLocale::ShortFormat));
    }
    default:
      return said(QT_TRANSLATE_NOOP("RecentFiles", "CT: %1")).arg(name);
  }
}

}  // namespace vallecula::gui

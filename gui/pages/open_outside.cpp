#include "gui/pages/open_outside.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QUrl>

namespace vallecula::gui {

QString open_outside(const std::filesystem::path& path) {
  const QString name = QString::fromStdString(path.string());
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    return QCoreApplication::translate("OpenOutside", "%1 is not there any more.").arg(name);
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(name))) return {};
  return QCoreApplication::translate("OpenOutside",
                                     "No program was found here that opens it; with a browser it can be read: %1")
      .arg(name);
}

}  // namespace vallecula::gui

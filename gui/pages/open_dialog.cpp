#include "gui/pages/open_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>

#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

/// By a look into it only: what else it may be is found out where it is opened.
bool is_one_thing(const QString& folder) {
  return QFileInfo::exists(folder + "/patient.yaml") || QFileInfo::exists(folder + "/trial.vtrial");
}

}  // namespace

OpenDialog::OpenDialog(const QString& folder, QWidget* parent)
    : QFileDialog(parent, tr("Open a patient, a trial, a course or a CT"), folder,
                  tr("What can be opened (*.vtrial *.yaml *.yml *.dcm *.ima *.nii *.nii.gz *.nrrd *.nhdr *.mha "
                     "*.mhd);;All files (*)")) {
  setOption(DontUseNativeDialog);  // the desktops' own choose files or folders, not both
  setFileMode(ExistingFile);
  if (!QFileInfo(folder).isDir()) setDirectory(QDir::homePath());
  resize(static_cast<int>(theme::points(760)), static_cast<int>(theme::points(500)));
  auto* whole = new QPushButton(tr("Open the &folder"), this);
  whole->setObjectName("whole_folder");
  whole->setToolTip(
      tr("Opens the folder that is chosen, or else the one that is shown: a patient (NAME.patient), a trial, "
         "a CT"));
  whole->setAutoDefault(false);
  if (auto* rows = qobject_cast<QGridLayout*>(layout()))  // below the dialog's own, which leave no room for a third
    rows->addWidget(whole, rows->rowCount(), 0, 1, -1, Qt::AlignRight);
  connect(whole, &QPushButton::clicked, this, [this] {
    const QStringList chosen = selectedFiles();
    take(chosen.size() == 1 && QFileInfo(chosen.front()).isDir() ? chosen.front() : directory().absolutePath());
  });
}

void OpenDialog::accept() {
  const QStringList chosen = selectedFiles();
  if (chosen.size() != 1) return QFileDialog::accept();
  const QFileInfo path(chosen.front());
  if (path.isFile() || (path.isDir() && is_one_thing(path.absoluteFilePath()))) return take(path.absoluteFilePath());
  QFileDialog::accept();  // goes into a folder, or tells that there is no such file
}

void OpenDialog::take(const QString& path) {
  QDialog::accept();
  emit chosen(path);
}

}  // namespace vallecula::gui

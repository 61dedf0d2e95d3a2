#include "gui/import/import_choice.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "gui/session/play_check.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {

std::filesystem::path patients_folder() { return user_data_folder() / "patients"; }

QString free_patient_name() {
  for (int i = 1;; ++i) {
    const std::string name = "patient-" + std::to_string(i);
    if (!std::filesystem::exists(patients_folder() / (name + ".patient"))) return QString::fromStdString(name);
  }
}

QString problem_with_name(const QString& name) {
  static const QRegularExpression allowed("^[A-Za-z0-9][A-Za-z0-9_-]{0,39}$");
  if (!allowed.match(name).hasMatch())
    return QCoreApplication::translate("ImportChoice",
                                       "Give it a name of letters, digits, - and _ (at most 40), not the patient's.");
  if (std::filesystem::exists(patients_folder() / (name.toStdString() + ".patient")))
    return QCoreApplication::translate("ImportChoice", "A patient of this name exists already; choose another name.");
  return {};
}

std::filesystem::path package_of(const QString& name) { return patients_folder() / (name.toStdString() + ".patient"); }

pipeline::ImportOptions options_of(const ImportChoice& choice) {
  pipeline::ImportOptions options;
  options.series = choice.source;
  options.choose = choice.series.toStdString();
  options.generic_face = choice.generic_face;
  options.check = check_by_playing;
  options.out = package_of(choice.name);
  return options;
}

}  // namespace vallecula::gui

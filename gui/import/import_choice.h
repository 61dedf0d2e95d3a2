// What a person chose to import, and where it goes.
#pragma once

#include <QString>
#include <filesystem>

#include "pipeline/import.h"

namespace vallecula::gui {

struct ImportChoice {
  std::filesystem::path source;  ///< a folder of DICOM files, or a file
  QString series;                ///< which of several, as SeriesRow::id has it; empty: the only one
  QString name;                  ///< of the package, without ".patient"
  bool generic_face = false;     ///< the shipped face for the patient's
};

/// What can be said of the build itself, and said otherwise for another build.
struct BuildChoice {
  bool keep_position = false;    ///< as pipeline::ImportOptions has them
  bool to_newborn_size = false;
  int tetrahedra = 5000;
  bool same_position(const BuildChoice& o) const {
    return keep_position == o.keep_position && to_newborn_size == o.to_newborn_size;
  }
};

/// $user_data_folder()/patients; not created here.
std::filesystem::path patients_folder();
/// "patient-1", or the first of that kind that is still free. Never taken from the scan: it may hold a person's name.
QString free_patient_name();
/// Empty when `name` can be a new patient's; else what is wrong with it, for a person.
QString problem_with_name(const QString& name);
std::filesystem::path package_of(const QString& name);
/// The one place where a choice becomes the pipeline's options.
pipeline::ImportOptions options_of(const ImportChoice& choice);

}  // namespace vallecula::gui

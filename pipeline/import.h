// From a CT series to a patient package: the stages in order.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/dicom/read_series.h"
#include "pipeline/exchange/edit_files.h"
#include "pipeline/package/patient_package.h"
#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Looks at a package that is ready to be written, as a player would: what it finds goes into the quality report and the
/// package's `approach`.
/// The second argument gets its share done, 0..1.
using PackageCheck =
    std::function<std::vector<QualityItem>(PatientPackage&, const std::function<void(double)>& progress)>;

struct ImportOptions {
  std::filesystem::path series;  ///< folder with a CT series, or a volume file; other files in it are ignored
  std::string choose;            ///< which of several series: its number in list_series, or its UID
  std::filesystem::path out;     ///< NAME.patient
  bool replace = false;          ///< a package already there is replaced when the new one is whole; else that is an error
  int tetrahedra = 5000;         ///< of the tongue, about (within 10 %): 1,000 to 100,000
  Edits edits;
  bool generic_face = false;  ///< the shipped face for the patient's; taken at mesh(), taken back by segment() again
  EditFiles edit_files;  ///< read anew by each segment(); `edits` go before them
  bool keep_position = false;    ///< leave a closed mouth closed and an unextended head as it lies
  bool to_newborn_size = false;  ///< scale all lengths so that the skull is as broad as a term newborn's
  PackageCheck check;  ///< the last stage before writing; empty: left out
};

struct ImportStage {
  std::string name;
  double seconds = 0.0;
};

struct ImportReport {
  std::filesystem::path package;
  std::vector<ImportStage> stages;
  std::vector<QualityItem> quality;  ///< as written into the package
};

/// Where each stage begins in the share of the whole work that is reported: about as their times lie, measured on
/// infants and a grown-up.
namespace stage_begin {
constexpr double kRead = 0.0, kSegment = 0.03, kPosition = 0.18, kSurfaces = 0.22, kTetrahedra = 0.53, kCheck = 0.63,
                 kWrite = 0.98;
}  // namespace stage_begin

/// Called from the importing thread with the stage's name ("surfaces"; where it has parts, "segment: airway") and the
/// share of the whole work done, 0..1, never falling. What it throws ends the work as an ImportError and leaves nothing
/// behind: so a person cancels.
using ImportProgress = std::function<void(const std::string& stage, double fraction)>;

/// What is wrong, where, and how to mend it; ready to be shown to a person. Holds nothing that identifies a patient.
class ImportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The stages one by one, for a person who looks at each before the next: in this order, any of them again (what comes
/// after it is then to be done again too). Each throws ImportError.
class Import {
 public:
  explicit Import(ImportOptions options, ImportProgress progress = {});
  ~Import();
  Import(const Import&) = delete;
  Import& operator=(const Import&) = delete;

  ImportOptions& options();  ///< may be changed between stages, but for `series`
  const ImportOptions& options() const;

  void read();
  void segment();  ///< with options().edits and edit_files
  /// Gives back the memory of series().hu's voxels, when nobody looks at them any more.
  void forget_scan();
  /// Opens a closed mouth, extends the head, scales when asked for; segmentation() is then the moved one, and
  /// labels_on_scan() stays what was measured. To do it otherwise segment() again. mesh() does it when it was left out.
  void position();
  void mesh();     ///< surfaces and tetrahedra
  void check();    ///< options().check
  /// Writes the package and returns the report. Until then nothing lies on the disk.
  ImportReport write();

  const CtSeries& series() const;            ///< after read()
  const Segmentation& segmentation() const;  ///< after segment()
  Labels labels_on_scan() const;             ///< after segment(): on the grid of series().hu
  const PatientPackage& package() const;     ///< after mesh()
  std::vector<QualityItem> quality() const;  ///< after mesh(), with what check() found: as write() will write it

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// All stages. Throws ImportError, and then leaves nothing behind.
ImportReport import_series(const ImportOptions& options, const ImportProgress& progress = {});

}  // namespace vallecula::pipeline

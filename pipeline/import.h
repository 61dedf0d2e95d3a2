// From a CT series to a patient package: the stages in order.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

struct ImportOptions {
  std::filesystem::path series;  ///< folder with a CT series, or a volume file; other files in it are ignored
  std::string choose;            ///< which of several series: its number in list_series, or its UID
  std::filesystem::path out;     ///< NAME.patient; a package already there is replaced when the new one is whole
  std::map<std::string, Point>
      seeds;  ///< mm LPS; known: "tongue". Needed only where the structure cannot be found by itself
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

/// Called from the importing thread with the stage's name and the share of the whole work done, 0..1, never falling.
using ImportProgress = std::function<void(const std::string& stage, double fraction)>;

/// What is wrong, where, and how to mend it; ready to be shown to a person. Holds nothing that identifies a patient.
class ImportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads, segments, meshes and writes the package. Throws ImportError, and then leaves nothing behind.
ImportReport import_series(const ImportOptions& options, const ImportProgress& progress = {});

}  // namespace vallecula::pipeline

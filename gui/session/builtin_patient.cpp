#include "gui/session/builtin_patient.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include "gui/session/files.h"
#include "gui/session/user_paths.h"
#include "pipeline/import.h"
#include "pipeline/manikin/manikin.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {
namespace {

namespace fs = std::filesystem;

constexpr double kScanShare = 0.25;  // of the whole work, by the clock on a term manikin

/// Empty: none is known.
fs::path cache_folder() {
  if (const char* home = set_variable("VALLECULA_HOME")) return fs::path(home) / "cache";
  if (const char* cache = set_variable("XDG_CACHE_HOME")) return fs::path(cache) / "vallecula";
  if (const char* home = set_variable("HOME")) return fs::path(home) / ".cache" / "vallecula";
  return {};
}

bool readable(const fs::path& package) {
  if (!fs::exists(package / "patient.yaml")) return false;
  try {
    pipeline::read_package(package);
    return true;
  } catch (const pipeline::PackageError&) {
    return false;  // damaged, or of another schema: it can be made anew
  }
}

/// A folder that is gone with this object, whatever happens.
class WorkFolder {
 public:
  explicit WorkFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    fs::remove_all(folder_, error);
    fs::create_directories(folder_, error);
    if (error)
      throw std::runtime_error(folder_.parent_path().string() + ": cannot be written (" + error.message() +
                               "); set VALLECULA_HOME to a folder you may write to");
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const fs::path& path() const { return folder_; }

 private:
  fs::path folder_;
};

}  // namespace

fs::path make_manikin_patient(const curricula::ManikinSpec& manikin, const fs::path& folder,
                              const PatientProgress& progress) {
  pipeline::ManikinOptions options;
  options.weight_kg = manikin.weight_kg;
  options.seed = manikin.seed;
  options.shape = {manikin.mouth_opening, manikin.tongue_size, manikin.larynx_height_mm, manikin.epiglottis_length,
                   manikin.gestation_weeks};
  pipeline::write_manikin(options, folder / "ct", [&](const std::string& stage, double fraction) {
    if (progress) progress("manikin: " + stage, kScanShare * fraction);
  });
  pipeline::ImportOptions import;
  import.series = folder / "ct";
  import.out = folder / "manikin.patient";
  pipeline::import_series(import, [&](const std::string& stage, double fraction) {
    if (progress) progress("import: " + stage, kScanShare + (1.0 - kScanShare) * fraction);
  });
  return import.out;
}

fs::path builtin_patients_folder() {
  const fs::path cache = cache_folder();
  return cache.empty() ? fs::path() : cache / "patients";
}

std::string builtin_patient_name(const curricula::ManikinSpec& manikin) {
  // Another build may make another patient of the same numbers.
  std::string key = sha256_of_program();
  char text[64];
  const auto add = [&](const std::optional<double>& value) {
    std::snprintf(text, sizeof text, "%.17g", value.value_or(0.0));
    key += value ? std::string(" ") + text : " -";
  };
  for (const std::optional<double>& value :
       {std::optional<double>(manikin.weight_kg), manikin.mouth_opening, manikin.tongue_size, manikin.larynx_height_mm,
        manikin.epiglottis_length, manikin.gestation_weeks})
    add(value);
  std::snprintf(text, sizeof text, "manikin-%.2fkg-%u-", manikin.weight_kg, manikin.seed);
  return text + sha256_of_bytes(key).substr(0, 12);
}

fs::path builtin_patient(const curricula::ManikinSpec& manikin, const PatientProgress& progress) {
  const fs::path folder = builtin_patients_folder();
  if (folder.empty()) throw std::runtime_error("no folder for the user's cache is known: set VALLECULA_HOME to one");
  const fs::path kept = folder / (builtin_patient_name(manikin) + ".patient");
  if (readable(kept)) return kept;
  const WorkFolder work(kept.string() + ".making-" + std::to_string(getpid()));
  const fs::path made = make_manikin_patient(manikin, work.path(), progress);
  std::error_code error;
  fs::remove_all(kept, error);
  fs::rename(made, kept, error);
  if (error && !readable(kept))  // another program may have been quicker with the same
    throw std::runtime_error(kept.string() + ": cannot be written (" + error.message() + ")");
  return kept;
}

}  // namespace vallecula::gui

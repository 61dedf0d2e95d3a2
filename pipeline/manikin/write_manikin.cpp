#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "pipeline/dicom/write_series.h"
#include "pipeline/manikin/manikin.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

/// A folder beside the wanted one, removed again unless it was kept.
class Aside {
 public:
  explicit Aside(const fs::path& wanted) : wanted_(wanted) {
    path_ = wanted.parent_path() / ("." + wanted.filename().string() + ".partial-" + std::to_string(::getpid()));
    std::error_code error;
    fs::create_directories(wanted.parent_path(), error);
    if (!error) fs::create_directory(path_, error);
    if (error)
      throw std::runtime_error("manikin: cannot write beside " + wanted.string() + " (" + error.message() +
                               "); choose a folder you may write to");
  }
  ~Aside() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  const fs::path& path() const { return path_; }
  void keep() {
    std::error_code error;
    fs::rename(path_, wanted_, error);  // over an empty folder, if there is one
    if (error)
      throw std::runtime_error("manikin: cannot create " + wanted_.string() + " (" + error.message() +
                               "); choose another folder");
    kept_ = true;
  }

 private:
  fs::path wanted_;
  fs::path path_;
  bool kept_ = false;
};

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

}  // namespace

void write_manikin(const ManikinOptions& options, const fs::path& dir, const ManikinProgress& progress) {
  if (dir.empty()) throw std::runtime_error("manikin: no folder was given to write to");
  fs::path wanted = fs::absolute(dir).lexically_normal();
  if (!wanted.has_filename()) wanted = wanted.parent_path();
  std::error_code error;
  if (fs::exists(fs::symlink_status(wanted, error)) &&
      !(fs::is_directory(wanted, error) && fs::is_empty(wanted, error)))
    throw std::runtime_error("manikin: " + dir.string() +
                             " already exists and is not an empty folder; "
                             "choose another name or remove it");
  Aside aside(wanted);
  const auto part = [&](double from, double to) {
    return [&progress, from, to](const std::string& stage, double fraction) {
      if (progress) progress(stage, from + (to - from) * fraction);
    };
  };
  const ManikinScan scan = scan_manikin(options, part(0.0, 0.8));
  SeriesDescription about;
  about.patient_id = "MANIKIN-" + std::to_string(options.seed);
  about.patient_name = "Manikin^" + std::to_string(options.seed);
  about.patient_weight_kg = options.weight_kg;
  about.study_description = "Synthetic newborn head";
  about.series_description = "Head and airway";
  about.unique_key = "vallecula manikin 1 " + text(options.weight_kg) + " " + std::to_string(options.seed) + " " +
                     text(options.noise_hu) + " " + text(scan.ct.grid.spacing[0]) + " " + text(scan.ct.grid.spacing[2]);
  const auto write_part = part(0.8, 0.95);
  write_ct_series(scan.ct, about, aside.path(), [&](double fraction) { write_part("writing the series", fraction); });
  if (progress) progress("writing the labels", 0.95);
  write_label_map(scan.labels, aside.path() / "truth.nrrd");
  aside.keep();
  if (progress) progress("done", 1.0);
}

}  // namespace vallecula::pipeline

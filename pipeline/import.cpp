#include "pipeline/import.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <sstream>

#include "pipeline/dicom/file_list.h"
#include "pipeline/exchange/landmark_file.h"
#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/generic_face.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "pipeline/package/aside.h"
#include "pipeline/package/label_map.h"
#include "pipeline/pose/position.h"
#include "pipeline/quality.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVersion = "0.1.0";
constexpr const char* kFaceNotice =
    "the face is the patient's own and can be recognised: treat the package as patient data, or import with the "
    "generic "
    "face";

/// Names the stage at hand, measures it, and maps its own 0..1 into the whole's.
class Stages {
 public:
  Stages(ImportReport& report, const ImportProgress& progress) : report_(report), progress_(progress) {}
  ~Stages() { end(); }
  void begin(const std::string& name, double from, double to) {
    end();
    name_ = name;
    from_ = from;
    to_ = to;
    done_ = from;  // a stage may be run again
    start_ = std::chrono::steady_clock::now();
    say(0.0);
  }
  /// `part`: of the stage, by name; for a person, who waits for it.
  void say(double fraction, const std::string& part = {}) {
    done_ = std::max(done_, from_ + std::clamp(fraction, 0.0, 1.0) * (to_ - from_));
    if (progress_) progress_(part.empty() ? name_ : name_ + ": " + part, done_);
  }
  void end() {
    if (name_.empty()) return;
    report_.stages.push_back({name_, std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count()});
    name_.clear();
  }

 private:
  ImportReport& report_;
  const ImportProgress& progress_;
  std::string name_;
  double from_ = 0.0;
  double to_ = 0.0;
  double done_ = 0.0;
  std::chrono::steady_clock::time_point start_;
};

std::string millimetres(const std::array<double, 3>& v) {
  std::ostringstream text;
  text << v[0] << " x " << v[1] << " x " << v[2] << " mm";
  return text.str();
}

std::map<std::string, std::string> provenance_of(const CtSeries& series) {
  return {{"modality", "CT"},
          {"matrix", std::to_string(series.matrix[0]) + " x " + std::to_string(series.matrix[1]) + " x " +
                         std::to_string(series.slices)},
          {"voxel", millimetres(series.source_spacing)},
          {"resampled", series.resampled ? "yes" : "no"},
          {"software", std::string("Vallecula ") + kVersion}};
}

std::string package_name(const fs::path& out) {
  auto name = out.lexically_normal();
  if (name.filename().empty()) name = name.parent_path();
  return name.extension() == ".patient" ? name.stem().string() : name.filename().string();
}

void check_out(const fs::path& out, bool replace) {
  const auto dir = package_folder(out);
  if (dir.extension() != ".patient") throw ImportError("package " + out.string() + ": the name must end in .patient");
  clean_asides(dir);
  if (fs::exists(dir) && !fs::exists(dir / "patient.yaml")) {
    throw ImportError("package " + out.string() +
                      ": a file or folder of this name exists and is not a patient package; choose another name");
  }
  if (fs::exists(dir) && !replace) {
    throw ImportError("package " + out.string() +
                      ": a package of this name is already there; choose another name, or --replace it");
  }
  // Before minutes of work: can it be written at all?
  auto parent = dir.parent_path();
  while (!parent.empty() && !fs::exists(parent) && parent != parent.parent_path()) parent = parent.parent_path();
  if (!fs::is_directory(parent)) {
    throw ImportError("package " + out.string() + ": " + parent.string() +
                      " is a file, not a folder; choose another place with --out");
  }
  const auto probe = parent / asides_of(dir).part.filename();
  if ((::mkdir(probe.c_str(), 0700) != 0 && errno != EEXIST) || ::rmdir(probe.c_str()) != 0) {
    throw ImportError("package " + out.string() + ": the folder " + parent.string() +
                      " cannot be written; choose another with --out");
  }
}

void check_count(int tetrahedra) {
  if (tetrahedra >= kFewestTetrahedra && tetrahedra <= kMostTetrahedra) return;
  throw ImportError("tetrahedra: " + std::to_string(tetrahedra) + " cannot be made; ask for " +
                    std::to_string(kFewestTetrahedra) + " to " + std::to_string(kMostTetrahedra));
}

/// Runs a stage; whatever goes wrong in it becomes one message for a person.
template <class Stage>
void guarded(const Stage& stage) {
  // The series' own folder may hold a person's name: it is never repeated.
  try {
    stage();
  } catch (const ImportError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw ImportError("series: not enough memory for a series of this size; close other programs");
  } catch (const SeriesError& e) {
    throw ImportError(e.what());
  } catch (const PackageError& e) {
    throw ImportError(e.what());
  } catch (const LabelMapError& e) {
    throw ImportError(e.what());
  } catch (const LandmarkFileError& e) {
    throw ImportError(e.what());
  } catch (const EditError& e) {
    throw ImportError(e.what());
  } catch (const fs::filesystem_error& e) {  // its own words hold paths
    throw ImportError("files: " + e.code().message() + "; check the names and the folders' permissions");
  } catch (const std::runtime_error& e) {
    throw ImportError(std::string("series: ") + e.what());
  }
}

}  // namespace

struct Import::Work {
  ImportOptions options;
  ImportProgress progress;
  ImportReport report;
  Stages stages{report, progress};
  CtSeries series;
  Segmentation segmentation;
  bool positioned = false;  ///< since the last segment()
  Labels measured;          ///< on the scan, once `segmentation` has been moved away from it
  PatientPackage package;
  std::vector<QualityItem> played;
  std::vector<std::string> edit_remarks;
};

Import::Import(ImportOptions options, ImportProgress progress) : work_(std::make_unique<Work>()) {
  work_->options = std::move(options);
  work_->progress = std::move(progress);
}
Import::~Import() = default;

ImportOptions& Import::options() { return work_->options; }
const ImportOptions& Import::options() const { return work_->options; }
const CtSeries& Import::series() const { return work_->series; }
const Segmentation& Import::segmentation() const { return work_->segmentation; }
Labels Import::labels_on_scan() const {
  if (!work_->measured.voxels.empty()) return work_->measured;
  return on_series_grid(work_->segmentation, work_->series.hu.grid);
}
const PatientPackage& Import::package() const { return work_->package; }

std::vector<QualityItem> Import::quality() const {
  auto items = work_->package.quality;
  auto played = work_->played;
  // What playing found wrong is the verdict on the whole, and is read first.
  const auto well = std::stable_partition(played.begin(), played.end(),
                                          [](const QualityItem& item) { return item.judged && !item.ok; });
  items.insert(items.begin(), played.begin(), well);
  items.insert(items.end(), well, played.end());
  return items;
}

void Import::read() {
  auto& w = *work_;
  guarded([&] {
    w.stages.begin("read", stage_begin::kRead, stage_begin::kSegment);
    w.series = read_ct_series(
        w.options.series, [&](double f) { w.stages.say(f); }, w.options.choose);
    w.stages.end();
  });
}

void Import::segment() {
  auto& w = *work_;
  guarded([&] {
    w.stages.begin("segment", stage_begin::kSegment, stage_begin::kPosition);
    w.positioned = false;
    w.measured = Labels();
    auto edits = w.options.edits;
    w.edit_remarks = add_edit_files(w.options.edit_files, w.series.hu.grid, edits);
    w.segmentation =
        pipeline::segment(w.series.hu, edits, [&](const std::string& part, double f) { w.stages.say(f, part); });
    w.stages.end();
  });
}

void Import::position() {
  auto& w = *work_;
  guarded([&] {
    w.stages.begin("position", stage_begin::kPosition, stage_begin::kSurfaces);
    if (!w.positioned) {
      const bool moves = !w.options.keep_position && aim_of(w.segmentation).any();
      if (moves || w.options.to_newborn_size) {
        // On a copy: whoever cancels half way keeps what was measured, whole.
        auto s = w.segmentation;
        if (moves) put_into_position(s, [&](double f) { w.stages.say(f); });
        if (w.options.to_newborn_size) scale_lengths(s, 1.0 / s.frame.scale);
        w.measured = on_series_grid(w.segmentation, w.series.hu.grid);
        w.segmentation = std::move(s);
      }
      w.positioned = true;
    }
    w.stages.end();
  });
}

void Import::mesh() {
  auto& w = *work_;
  if (!w.positioned) position();
  guarded([&] {
    check_count(w.options.tetrahedra);
    w.package = PatientPackage();
    w.stages.begin("surfaces", stage_begin::kSurfaces, stage_begin::kTetrahedra);
    if (w.options.generic_face) give_generic_face(w.segmentation);
    const auto fields = fields_of(w.segmentation);
    w.package.surfaces =
        surfaces_of(w.segmentation, fields, [&](const std::string& part, double f) { w.stages.say(f, part); });
    w.stages.begin("tetrahedra", stage_begin::kTetrahedra, stage_begin::kCheck);
    w.package.tongue = soft_mesh(w.segmentation, fields, w.options.tetrahedra);
    w.stages.end();
    w.package.provenance = provenance_of(w.series);
    w.package.provenance["face"] = w.options.generic_face ? "the shipped generic one" : "the patient's own";
    if (w.segmentation.pose.scale != 1.0) w.package.provenance["size"] = "scaled to a term newborn's";
    w.package.landmarks = w.segmentation.landmarks;
    w.package.findings = w.segmentation.findings;
    w.package.pose = w.segmentation.pose;
    w.package.materials = default_materials();
    auto notes = w.series.notes;
    if (!w.options.generic_face) notes.emplace_back(kFaceNotice);
    notes.insert(notes.end(), w.edit_remarks.begin(), w.edit_remarks.end());
    w.package.quality = quality_report(w.segmentation, w.package, notes);
  });
}

void Import::forget_scan() { work_->series.hu.voxels = {}; }

void Import::check() {
  auto& w = *work_;
  w.played.clear();
  if (!w.options.check) return;
  guarded([&] {
    w.stages.begin("check by playing", stage_begin::kCheck, stage_begin::kWrite);
    w.played = w.options.check(w.package, [&](double f) { w.stages.say(f); });
    w.stages.end();
  });
}

ImportReport Import::write() {
  auto& w = *work_;
  guarded([&] {
    check_out(w.options.out, w.options.replace);
    w.stages.begin("write", stage_begin::kWrite, 1.0);
    auto package = w.package;
    package.name = package_name(w.options.out);
    package.quality = quality();
    auto labels = labels_on_scan();
    if (w.options.generic_face) labels = without_face(labels, w.segmentation.frame.scale);
    write_package(package, labels, w.options.out);
    w.stages.say(1.0);
    w.stages.end();
    w.report.package = w.options.out;
    w.report.quality = package.quality;
  });
  return w.report;
}

ImportReport import_series(const ImportOptions& options, const ImportProgress& progress) {
  guarded([&] {
    check_out(options.out, options.replace);
    check_count(options.tetrahedra);
    status_of_place(options.series);  // before any progress is told
  });
  Import import(options, progress);
  import.read();
  import.segment();
  import.forget_scan();
  import.position();
  import.mesh();
  import.check();
  return import.write();
}

}  // namespace vallecula::pipeline

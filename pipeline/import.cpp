#include "pipeline/import.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <sstream>

#include "pipeline/dicom/read_series.h"
#include "pipeline/mesh/anatomy_surfaces.h"
#include "pipeline/mesh/tetrahedralize.h"
#include "pipeline/package/label_map.h"
#include "pipeline/quality.h"
#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVersion = "0.1.0";

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
    start_ = std::chrono::steady_clock::now();
    say(0.0);
  }
  void say(double fraction) {
    done_ = std::max(done_, from_ + std::clamp(fraction, 0.0, 1.0) * (to_ - from_));
    if (progress_) progress_(name_, done_);
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

/// Where the label map waits for its package; gone on every way out.
class TemporaryLabels {
 public:
  TemporaryLabels()
      : path_(fs::temp_directory_path() / ("vallecula-labels-" + std::to_string(::getpid()) + ".nrrd")) {}
  ~TemporaryLabels() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryLabels(const TemporaryLabels&) = delete;
  TemporaryLabels& operator=(const TemporaryLabels&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
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

void check_out(const fs::path& out) {
  const auto target = fs::absolute(out).lexically_normal();
  const auto dir = target.filename().empty() ? target.parent_path() : target;
  if (dir.extension() != ".patient") throw ImportError("package " + out.string() + ": the name must end in .patient");
  if (fs::exists(dir) && !fs::exists(dir / "patient.yaml")) {
    throw ImportError("package " + out.string() +
                      ": a file or folder of this name exists and is not a patient package; choose another name");
  }
  // Before minutes of work: can it be written at all?
  auto parent = dir.parent_path();
  while (!parent.empty() && !fs::exists(parent) && parent != parent.parent_path()) parent = parent.parent_path();
  if (!fs::is_directory(parent)) {
    throw ImportError("package " + out.string() + ": " + parent.string() +
                      " is a file, not a folder; choose another place with --out");
  }
  std::string probe = (parent / ".vallecula-XXXXXX").string();
  if (::mkdtemp(probe.data()) == nullptr || ::rmdir(probe.c_str()) != 0) {
    throw ImportError("package " + out.string() + ": the folder " + parent.string() +
                      " cannot be written; choose another with --out");
  }
}

}  // namespace

ImportReport import_series(const ImportOptions& options, const ImportProgress& progress) {
  ImportReport report;
  report.package = options.out;
  try {
    check_out(options.out);
    for (const auto& [name, point] : options.seeds) {
      (void)point;
      if (name != "tongue")
        throw ImportError("seed " + name + ": only the tongue takes a seed; write --seed tongue=x,y,z");
    }
    Stages stages(report, progress);
    stages.begin("read", 0.0, 0.1);
    auto series = read_ct_series(options.series, [&](double f) { stages.say(f); }, options.choose);

    stages.begin("segment", 0.1, 0.5);
    const auto segmentation = segment(series.hu, options.seeds, [&](const std::string&, double f) { stages.say(f); });

    stages.begin("surfaces", 0.5, 0.8);
    const auto fields = fields_of(segmentation);
    PatientPackage package;
    package.surfaces = surfaces_of(segmentation, fields, [&](double f) { stages.say(f); });

    stages.begin("tetrahedra", 0.8, 0.93);
    package.tongue = soft_mesh(segmentation, fields);

    stages.begin("write", 0.93, 1.0);
    package.name = package_name(options.out);
    package.provenance = provenance_of(series);
    package.landmarks = segmentation.landmarks;
    package.materials = default_materials();
    package.quality = quality_report(segmentation, package, series.notes);
    const TemporaryLabels labels;
    write_label_map(on_series_grid(segmentation, series.hu.grid), labels.path());
    stages.say(0.5);
    write_package(package, labels.path(), options.out);
    stages.say(1.0);
    stages.end();
    report.quality = package.quality;
    return report;
  } catch (const ImportError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw ImportError("series " + options.series.string() + ": not enough memory for a series of this size");
  } catch (const SeriesError& e) {
    throw ImportError(e.what());
  } catch (const PackageError& e) {
    throw ImportError(e.what());
  } catch (const std::exception& e) {
    throw ImportError("series " + options.series.string() + ": " + e.what());
  }
}

}  // namespace vallecula::pipeline

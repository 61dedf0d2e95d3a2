#include <fcntl.h>
#include <stdio.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <fstream>
#include <system_error>

#include "pipeline/exchange/landmark_file.h"
#include "pipeline/package/aside.h"
#include "pipeline/package/digest.h"
#include "pipeline/package/label_map.h"
#include "pipeline/package/mesh_files.h"
#include "pipeline/package/patient_package.h"
#include "pipeline/package/thumbnail.h"
#include "pipeline/segment/reslice.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

void check_complete(const PatientPackage& package) {
  for (const auto* name : kLandmarks) {
    const auto found = package.landmarks.find(name);
    if (found == package.landmarks.end()) throw PackageError(std::string("package: landmark ") + name + " is missing");
    for (const double v : found->second) {
      if (!std::isfinite(v)) throw PackageError(std::string("package: landmark ") + name + " is not a finite point");
    }
  }
  for (const auto* name : {"tongue", "epiglottis"}) {
    if (package.materials.count(name) == 0)
      throw PackageError(std::string("package: material ") + name + " is missing");
  }
  for (const auto* name : kSurfaces) {
    if (package.surfaces.count(name) == 0) throw PackageError(std::string("package: surface ") + name + " is missing");
  }
}

void describe_findings(const PatientPackage& package, YAML::Emitter& y) {
  y << YAML::Key << "findings" << YAML::Value << YAML::BeginMap;
  for (const auto& [name, finding] : package.findings) {
    y << YAML::Key << name << YAML::Value << YAML::BeginMap << YAML::Key << "origin" << YAML::Value
      << name_of(finding.origin) << YAML::Key << "how" << YAML::Value << YAML::DoubleQuoted << finding.how
      << YAML::EndMap;
  }
  y << YAML::EndMap;
}

void describe_pose(const PoseChange& pose, YAML::Emitter& y) {
  y << YAML::Key << "pose" << YAML::Value << YAML::BeginMap;
  y << YAML::Key << "scan_to_package" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const double v : pose.scan_to_package) y << v;
  y << YAML::EndSeq;
  for (const auto& [key, value] :
       {std::pair{"tilt_deg", pose.tilt_deg}, std::pair{"turn_deg", pose.turn_deg}, std::pair{"nod_deg", pose.nod_deg},
        std::pair{"extension_deg", pose.extension_deg}, std::pair{"mouth_opened_deg", pose.mouth_opened_deg},
        std::pair{"scale", pose.scale}})
    y << YAML::Key << key << YAML::Value << value;
  y << YAML::EndMap;
}

std::string described(const PatientPackage& package, const std::map<std::string, std::string>& hashes) {
  YAML::Emitter y;
  y.SetDoublePrecision(17);
  y << YAML::BeginMap;
  y << YAML::Key << "schema" << YAML::Value << package.schema;
  y << YAML::Key << "name" << YAML::Value << package.name;
  y << YAML::Key << "unit" << YAML::Value << "mm" << YAML::Key << "frame" << YAML::Value << "LPS";
  y << YAML::Key << "provenance" << YAML::Value << YAML::BeginMap;
  for (const auto& [key, value] : package.provenance)
    y << YAML::Key << key << YAML::Value << YAML::DoubleQuoted << value;
  y << YAML::EndMap;
  y << YAML::Key << "landmarks" << YAML::Value << YAML::BeginMap;
  for (const auto& [key, p] : package.landmarks) {
    y << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq << p[0] << p[1] << p[2] << YAML::EndSeq;
  }
  y << YAML::EndMap;
  describe_findings(package, y);
  describe_pose(package.pose, y);
  y << YAML::Key << "approach" << YAML::Value << YAML::BeginMap << YAML::Key << "along_mm" << YAML::Value
    << package.approach.along_mm << YAML::Key << "lift_mm" << YAML::Value << package.approach.lift_mm << YAML::EndMap;
  y << YAML::Key << "materials" << YAML::Value << YAML::BeginMap;
  for (const auto& [key, m] : package.materials) {
    y << YAML::Key << key << YAML::Value << YAML::BeginMap << YAML::Key << "young_pa" << YAML::Value << m.young_pa
      << YAML::Key << "poisson" << YAML::Value << m.poisson << YAML::Key << "density_kg_m3" << YAML::Value
      << m.density_kg_m3 << YAML::EndMap;
  }
  y << YAML::EndMap;
  y << YAML::Key << "quality" << YAML::Value << YAML::BeginSeq;
  for (const auto& q : package.quality) {
    y << YAML::BeginMap << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << q.name;
    if (q.value) y << YAML::Key << "value" << YAML::Value << *q.value;
    y << YAML::Key << "unit" << YAML::Value << YAML::DoubleQuoted << q.unit;
    if (q.judged) y << YAML::Key << "ok" << YAML::Value << q.ok;
    y << YAML::Key << "note" << YAML::Value << YAML::DoubleQuoted << q.note << YAML::EndMap;
  }
  y << YAML::EndSeq;
  y << YAML::Key << "files" << YAML::Value << YAML::BeginMap;
  for (const auto& [file, hash] : hashes) y << YAML::Key << file << YAML::Value << hash;
  y << YAML::EndMap << YAML::EndMap;
  std::string text = std::string(y.c_str()) + "\n";
  // The description guards itself too: its last line is the digest of every line above it.
  return text + "sha256: " + sha256_of_text(text) + "\n";
}

void fill_folder(const PatientPackage& package, const Labels& labels, const fs::path& folder) {
  std::map<std::string, std::string> hashes;
  const auto listed = [&](const std::string& file) { hashes[file] = sha256_of_file(folder / file); };

  listed("labels.nrrd");
  write_landmark_file(package, folder / "landmarks.mrk.json");
  listed("landmarks.mrk.json");
  for (const auto& [name, surface] : package.surfaces) {
    write_surface(surface, folder / (name + ".vtp"));
    listed(name + ".vtp");
  }
  write_tet_mesh(package.tongue, package.materials, folder / "tongue.vtu");
  listed("tongue.vtu");
  // The labels lie in the scan's frame, the landmarks in the package's.
  const auto gum = moved(inverse_of(package.pose.scan_to_package), package.landmarks.at("upper_gum_midline"));
  write_thumbnail(labels, gum[0], folder / "thumbnail.png");
  listed("thumbnail.png");

  std::ofstream out(folder / "patient.yaml", std::ios::binary);
  out << described(package, hashes);
  out.close();
  if (!out) throw PackageError("package file patient.yaml: cannot be written; is there space on the disk?");
}

/// Puts the whole folder in the place of what is there, which is then at `aside`; in one step where the file system
/// can.
void exchange(const fs::path& aside, const fs::path& target, const fs::path& old) {
  if (::renameat2(AT_FDCWD, aside.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return;
  fs::rename(target, old);
  std::error_code error;
  fs::rename(aside, target, error);
  if (!error) return;
  std::error_code ignored;
  fs::rename(old, target, ignored);
  throw fs::filesystem_error("rename", target, error);
}

}  // namespace

void write_package(const PatientPackage& package, const Labels& labels, const fs::path& dir) {
  check_complete(package);
  const auto target = package_folder(dir);
  if (fs::exists(target) && !fs::exists(target / "patient.yaml")) {
    throw PackageError("package " + target.filename().string() +
                       ": a file or folder of this name exists and is not a patient package; choose another name");
  }
  const auto [aside, old] = asides_of(target);
  std::error_code ignored;
  try {
    fs::create_directories(target.parent_path());
    clean_asides(target);
    fs::remove_all(aside);
    fs::create_directory(aside);
    write_label_map(labels, aside / "labels.nrrd");
    fill_folder(package, labels, aside);
    if (fs::exists(target)) {
      exchange(aside, target, old);
    } else {
      fs::rename(aside, target);
    }
  } catch (const fs::filesystem_error& e) {
    fs::remove_all(aside, ignored);
    throw PackageError("package " + target.filename().string() + ": cannot be written into " +
                       target.parent_path().string() + " (" + e.code().message() +
                       "); choose a folder you may write to");
  } catch (const std::exception& e) {
    fs::remove_all(aside, ignored);
    throw PackageError(e.what());
  }
  fs::remove_all(aside, ignored);
  fs::remove_all(old, ignored);
}

}  // namespace vallecula::pipeline

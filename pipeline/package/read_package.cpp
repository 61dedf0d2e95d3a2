#include <yaml-cpp/yaml.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "pipeline/package/digest.h"
#include "pipeline/package/mesh_files.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr int kSchema = 1;

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw PackageError("package file " + file + ": " + what);
}

/// The text above the last line, after checking that line's digest.
std::string checked_description(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse("patient.yaml", "cannot be read; is this a patient package?");
  std::ostringstream all;
  all << in.rdbuf();
  const auto text = all.str();
  const auto last = text.rfind("sha256: ");
  if (last == std::string::npos || (last > 0 && text[last - 1] != '\n'))
    refuse("patient.yaml", "has no digest; import the series again");
  const auto above = text.substr(0, last);
  if (text.substr(last) != "sha256: " + sha256_of_text(above) + "\n") {
    refuse("patient.yaml", "was changed after the package was written; import the series again");
  }
  return above;
}

YAML::Node required(const YAML::Node& node, const char* key) {
  const auto value = node[key];
  if (!value) refuse("patient.yaml", std::string("the field \"") + key + "\" is missing");
  return value;
}

double number(const YAML::Node& node, const std::string& what) {
  const auto value = node.as<double>();
  if (!std::isfinite(value)) refuse("patient.yaml", what + " is not a finite number");
  return value;
}

/// Packages of before these fields were written are in the scan's own position.
void read_findings_and_pose(const YAML::Node& root, PatientPackage& package) {
  for (const auto& item : root["findings"]) {
    const auto name = item.first.as<std::string>();
    Finding finding;
    const auto origin = required(item.second, "origin").as<std::string>();
    if (!origin_from(origin, finding.origin))
      refuse("patient.yaml",
             "origin \"" + origin + "\" of " + name + "; expected measured, inferred, given or template");
    finding.how = required(item.second, "how").as<std::string>();
    package.findings[name] = finding;
  }
  if (const auto approach = root["approach"]) {
    package.approach.along_mm = number(required(approach, "along_mm"), "along_mm of the approach");
    package.approach.lift_mm = number(required(approach, "lift_mm"), "lift_mm of the approach");
  }
  const auto node = root["pose"];
  if (!node) return;
  auto& pose = package.pose;
  const auto matrix = required(node, "scan_to_package");
  if (matrix.size() != pose.scan_to_package.size()) refuse("patient.yaml", "scan_to_package needs sixteen numbers");
  for (std::size_t i = 0; i < pose.scan_to_package.size(); ++i)
    pose.scan_to_package[i] = number(matrix[i], "scan_to_package");
  for (const auto& [key, value] :
       {std::pair{"tilt_deg", &pose.tilt_deg}, std::pair{"turn_deg", &pose.turn_deg},
        std::pair{"nod_deg", &pose.nod_deg}, std::pair{"extension_deg", &pose.extension_deg},
        std::pair{"mouth_opened_deg", &pose.mouth_opened_deg}, std::pair{"scale", &pose.scale}})
    *value = number(required(node, key), key);
}

void read_description(const YAML::Node& root, PatientPackage& package) {
  package.schema = required(root, "schema").as<int>();
  if (package.schema != kSchema) {
    refuse("patient.yaml",
           "schema " + std::to_string(package.schema) + "; this program reads schema " + std::to_string(kSchema));
  }
  if (required(root, "unit").as<std::string>() != "mm" || required(root, "frame").as<std::string>() != "LPS") {
    refuse("patient.yaml", "expected unit mm and frame LPS");
  }
  package.name = required(root, "name").as<std::string>();
  for (const auto& item : required(root, "provenance"))
    package.provenance[item.first.as<std::string>()] = item.second.as<std::string>();
  for (const auto& item : required(root, "landmarks")) {
    const auto name = item.first.as<std::string>();
    if (item.second.size() != 3) refuse("patient.yaml", "landmark " + name + " needs three numbers");
    for (int a = 0; a < 3; ++a) package.landmarks[name][a] = number(item.second[a], "landmark " + name);
  }
  for (const auto* name : kLandmarks) {
    if (package.landmarks.count(name) == 0) refuse("patient.yaml", std::string("landmark ") + name + " is missing");
  }
  read_findings_and_pose(root, package);
  for (const auto& item : required(root, "materials")) {
    const auto name = item.first.as<std::string>();
    Material m;
    m.young_pa = number(required(item.second, "young_pa"), "young_pa of " + name);
    m.poisson = number(required(item.second, "poisson"), "poisson of " + name);
    m.density_kg_m3 = number(required(item.second, "density_kg_m3"), "density_kg_m3 of " + name);
    if (!(m.young_pa > 0.0) || !(m.poisson >= 0.0 && m.poisson < 0.5) || !(m.density_kg_m3 > 0.0)) {
      refuse("patient.yaml",
             "material " + name + " is not physical; expected young_pa > 0, 0 <= poisson < 0.5, density_kg_m3 > 0");
    }
    package.materials[name] = m;
  }
  for (const auto& item : required(root, "quality")) {
    QualityItem q;
    q.name = required(item, "name").as<std::string>();
    if (item["value"]) q.value = item["value"].as<double>();  // a remark has no figure
    q.unit = required(item, "unit").as<std::string>();
    q.judged = static_cast<bool>(item["ok"]);  // a figure without a verdict has none in the file
    if (q.judged) q.ok = item["ok"].as<bool>();
    q.note = required(item, "note").as<std::string>();
    package.quality.push_back(q);
  }
}

/// Checks every listed file and returns the names.
std::vector<std::string> checked_files(const YAML::Node& root, const fs::path& dir) {
  std::vector<std::string> files;
  for (const auto& item : required(root, "files")) {
    const auto name = item.first.as<std::string>();
    if (name.empty() || fs::path(name).filename() != fs::path(name) || name == "." || name == "..") {
      refuse("patient.yaml", "lists a file outside the package");
    }
    if (!fs::is_regular_file(dir / name)) refuse(name, "is missing; import the series again");
    if (sha256_of_file(dir / name) != item.second.as<std::string>()) {
      refuse(name, "was changed after the package was written; import the series again");
    }
    files.push_back(name);
  }
  return files;
}

}  // namespace

PatientPackage read_package(const fs::path& dir) {
  if (!fs::is_directory(dir))
    throw PackageError("package " + dir.string() + ": there is no such folder; name a NAME.patient folder");
  if (!fs::is_regular_file(dir / "patient.yaml")) {
    throw PackageError("package " + dir.filename().string() +
                       ": patient.yaml is missing; this folder is not a patient package");
  }
  PatientPackage package;
  std::vector<std::string> files;
  try {
    const auto root = YAML::Load(checked_description(dir / "patient.yaml"));
    read_description(root, package);
    files = checked_files(root, dir);
  } catch (const YAML::Exception& e) {
    refuse("patient.yaml", std::string("cannot be understood (") + e.what() + "); import the series again");
  }
  for (const auto& file : files) {
    if (fs::path(file).extension() == ".vtp")
      package.surfaces[fs::path(file).stem().string()] = read_surface(dir / file);
  }
  for (const auto* name : kSurfaces) {
    if (package.surfaces.count(name) == 0) refuse(std::string(name) + ".vtp", "is missing; import the series again");
  }
  package.tongue = read_tet_mesh(dir / "tongue.vtu");
  if (package.materials.count("tongue") == 0 || package.materials.count("epiglottis") == 0) {
    refuse("patient.yaml", "the materials tongue and epiglottis are needed");
  }
  const auto& face = package.surfaces.at("face");
  if (face.tissue.size() != face.triangles.size())
    refuse("face.vtp", "the array \"tissue\" is missing; import the series again");
  return package;
}

}  // namespace vallecula::pipeline

#include "pipeline/exchange/landmark_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "pipeline/dicom/file_list.h"
#include "pipeline/mesh/vector3.h"
#include "pipeline/segment/reslice.h"

namespace vallecula::pipeline {
namespace {

constexpr double kNormalMm = 10.0;
constexpr const char* kFoundAt = "found at LPS ";

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw LandmarkFileError("landmark file " + told_name(file) + ": " + what);
}

bool is_landmark(const std::string& name) {
  return std::any_of(kLandmarks.begin(), kLandmarks.end(), [&](const char* known) { return name == known; });
}

std::string numbers(const Point& p, const char* between) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.4f%s%.4f%s%.4f", p[0], between, p[1], between, p[2]);
  return text.data();
}

/// Quotes and backslashes as JSON wants them; the words are this program's own.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

/// The place a description says the point was found at.
bool found_place(const std::string& description, Point& place) {
  const auto at = description.find(kFoundAt);
  if (at == std::string::npos) return false;
  std::istringstream text(description.substr(at + std::string(kFoundAt).size()));
  return static_cast<bool>(text >> place[0] >> place[1] >> place[2]);
}

Point point_of(const YAML::Node& node, const std::string& name, const std::filesystem::path& file) {
  if (!node || !node.IsSequence() || node.size() != 3) fail(file, "the point " + name + " has no position");
  Point p{};
  for (std::size_t a = 0; a < 3; ++a) {
    p[a] = node[a].as<double>();
    if (!(std::abs(p[a]) < 1e5)) fail(file, "the position of " + name + " is not a place near a patient");
  }
  return p;
}

struct Found {
  std::map<std::string, Point> points;
  std::map<std::string, bool> moved;
  int left_out = 0;
};

void read_markup(const YAML::Node& markup, const std::filesystem::path& file, Found& found) {
  const auto system = markup["coordinateSystem"] ? markup["coordinateSystem"].as<std::string>() : "RAS";
  if (system != "LPS" && system != "RAS") fail(file, "coordinate system \"" + system + "\"; expected LPS or RAS");
  if (markup["coordinateUnits"] && markup["coordinateUnits"].as<std::string>() != "mm")
    fail(file, "its points are not in mm");
  for (const auto& node : markup["controlPoints"]) {
    const auto name = node["label"] ? node["label"].as<std::string>() : std::string();
    const auto status = node["positionStatus"] ? node["positionStatus"].as<std::string>() : "defined";
    if (!is_landmark(name) || status != "defined") {
      ++found.left_out;
      continue;
    }
    if (found.points.count(name) != 0) fail(file, "it holds the point " + name + " twice");
    auto p = point_of(node["position"], name, file);
    if (system == "RAS") p = {-p[0], -p[1], p[2]};
    Point before{};
    const auto description = node["description"] ? node["description"].as<std::string>() : std::string();
    found.points[name] = p;
    found.moved[name] = !found_place(description, before) || distance(before, p) > 1e-3;
  }
}

}  // namespace

void write_landmark_file(const PatientPackage& package, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  if (!out) fail(file, "cannot be created; is the folder writable?");
  out << "{\n  \"@schema\": "
         "\"https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
         "Schema/markups-schema-v1.0.3.json#\",\n  \"markups\": [\n    {\n      \"type\": \"Fiducial\",\n"
         "      \"coordinateSystem\": \"LPS\",\n      \"coordinateUnits\": \"mm\",\n      \"locked\": false,\n"
         "      \"fixedNumberOfControlPoints\": false,\n      \"labelFormat\": \"%N-%d\",\n      \"controlPoints\": [";
  const auto centre = package.landmarks.at("glottis_centre");
  const auto to_scan = inverse_of(package.pose.scan_to_package);
  int id = 0;
  for (const auto* name : kLandmarks) {
    auto p = package.landmarks.at(name);
    if (std::string(name) == "glottis_normal") p = centre + kNormalMm * p;
    p = moved(to_scan, p);
    const auto finding = package.findings.find(name);
    std::string description;
    if (finding != package.findings.end()) {
      description = name_of(finding->second.origin);
      if (!finding->second.how.empty()) description += " (" + finding->second.how + ")";
      description += "; ";
    }
    if (std::string(name) == "glottis_normal") description += "10 mm from glottis_centre across the glottis; ";
    if (package.pose.mouth_opened_deg != 0.0 || package.pose.extension_deg != 0.0)
      description += "placed after mouth or neck were moved, so it may lie beside the scan's own place; ";
    description += kFoundAt + numbers(p, " ");
    ++id;
    out << (id > 1 ? "," : "") << "\n        {\n          \"id\": \"" << id
        << "\",\n          \"label\": " << quoted(name) << ",\n          \"description\": " << quoted(description)
        << ",\n          \"associatedNodeID\": \"\",\n          \"position\": [" << numbers(p, ", ")
        << "],\n          \"orientation\": [-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0],\n"
        << "          \"selected\": true,\n          \"locked\": false,\n          \"visibility\": true,\n"
        << "          \"positionStatus\": \"defined\"\n        }";
  }
  out << "\n      ],\n      \"measurements\": []\n    }\n  ]\n}\n";
  out.close();
  if (!out) fail(file, "cannot be written; is the disk full?");
}

GivenLandmarks read_landmark_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) fail(file, "cannot be opened");
  constexpr std::size_t kMostBytes = 1U << 24;
  std::string text(kMostBytes, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  std::replace(text.begin(), text.end(), '\t', ' ');  // JSON is YAML but for tabs
  Found found;
  try {
    const auto root = YAML::Load(text);
    if (!root.IsMap() || !root["markups"] || !root["markups"].IsSequence())
      fail(file, "this is no 3D Slicer markups file (.mrk.json)");
    for (const auto& markup : root["markups"]) read_markup(markup, file, found);
  } catch (const YAML::Exception&) {
    fail(file, "it cannot be read as a 3D Slicer markups file (.mrk.json)");
  }
  if (found.points.empty()) {
    std::string names;
    for (const auto* name : kLandmarks) names += (names.empty() ? "" : ", ") + std::string(name);
    fail(file, "none of its points has a name known here: " + names);
  }
  GivenLandmarks given;
  given.left_out = found.left_out;
  for (const auto& [name, point] : found.points) {
    if (!found.moved[name]) {
      ++given.unmoved;
      continue;
    }
    if (name != "glottis_normal") {
      given.moved[name] = point;
      continue;
    }
    const auto centre = found.points.find("glottis_centre");
    if (centre == found.points.end() || !(distance(point, centre->second) > 1e-3))
      fail(file, "glottis_normal needs a point glottis_centre apart from it");
    given.moved[name] = unit(point - centre->second);
  }
  return given;
}

}  // namespace vallecula::pipeline

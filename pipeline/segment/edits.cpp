#include "pipeline/segment/edits.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pipeline/mesh/vector3.h"
#include "pipeline/package/label_map.h"

namespace vallecula::pipeline {
namespace {

/// What a point can be grown from. The hyoid has no label; its seed is its landmark's.
constexpr std::array<const char*, 9> kSeeded = {"tongue",     "airway",      "bone_skull", "bone_mandible", "spine",
                                                "epiglottis", "soft_palate", "larynx",     "hyoid"};

template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

bool finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

void check_threshold(const std::string& name, const std::array<double, 2>& hu) {
  const bool known = std::any_of(kLabelNames.begin(), kLabelNames.end(), [&](const auto& l) { return name == l.name; });
  if (!known) {
    std::string names;
    for (const auto& label : kLabelNames) names += (names.empty() ? "" : ", ") + std::string(label.name);
    throw EditError("threshold " + name + ": no structure of this name; known are " + names);
  }
  if (name == "skin" && std::isfinite(hu[1]))
    throw EditError(
        "threshold skin: it has no highest value, for what is denser and no other structure is skin too; "
        "give skin=LO");
  if (!(std::isfinite(hu[0]) && (name == "skin" || std::isfinite(hu[1])) && hu[0] < hu[1]))
    throw EditError("threshold " + name + ": expected the lowest, then the highest Hounsfield value, " + name +
                    "=LO,HI");
  // The border between air and tissue; outside of these there is nothing on one side of it.
  const double border = name == "airway" ? hu[1] : name == "skin" ? hu[0] : -500.0;
  if (!(border > -1000.0 && border < 0.0))
    throw EditError("threshold " + name + ": the border between air and tissue lies between -1000 and 0 HU");
}

}  // namespace

void check_edits(const Edits& edits) {
  for (const auto& [name, point] : edits.seeds) {
    if (std::none_of(kSeeded.begin(), kSeeded.end(), [&, n = name](const char* known) { return n == known; }))
      throw EditError("seed " + name + ": nothing is grown from a point under this name; known are " + listed(kSeeded));
    if (!finite(point)) throw EditError("seed " + name + ": its coordinates are not finite numbers");
  }
  for (const auto& [name, hu] : edits.thresholds) check_threshold(name, hu);
  const auto airway = edits.thresholds.find("airway");
  const auto skin = edits.thresholds.find("skin");
  if (airway != edits.thresholds.end() && skin != edits.thresholds.end() && airway->second[1] != skin->second[0])
    throw EditError(
        "threshold airway and skin: air ends where skin begins; give one of them, or the airway's highest value as the "
        "skin's lowest");
  for (const auto& [name, point] : edits.landmarks) {
    if (std::none_of(kLandmarks.begin(), kLandmarks.end(), [&, n = name](const char* known) { return n == known; }))
      throw EditError("landmark " + name + ": not a landmark of a package; known are " + listed(kLandmarks));
    if (!finite(point)) throw EditError("landmark " + name + ": its coordinates are not finite numbers");
    if (name == "glottis_normal" && !(norm(point) > 1e-6))
      throw EditError("landmark glottis_normal: a direction of no length");
  }
  if (!edits.replaced.empty() && !edits.labels)
    throw EditError("structures are to be replaced, but there is no label map");
}

void check_edits_in(const Edits& edits, const Grid& scan) {
  const auto low = scan.position(-0.5, -0.5, -0.5);
  const auto high = scan.position(scan.size[0] - 0.5, scan.size[1] - 0.5, scan.size[2] - 0.5);
  const auto check = [&](const std::string& what, const Point& point, double beyond_mm) {
    for (int a = 0; a < 3; ++a) {
      if (point[a] >= low[a] - beyond_mm && point[a] <= high[a] + beyond_mm) continue;
      std::ostringstream text;
      text << what << ": the point lies outside the scan (x " << low[0] << " to " << high[0] << ", y " << low[1]
           << " to " << high[1] << ", z " << low[2] << " to " << high[2]
           << " mm); coordinates are LPS (x to the left, y to the back, z to the head)";
      throw EditError(text.str());
    }
  };
  constexpr double kBelowTheScanMm = 100.0;  // an adult's carina when the scan ends at the larynx
  for (const auto& [name, point] : edits.seeds) check("seed " + name, point, 0.0);
  for (const auto& [name, point] : edits.landmarks) {
    if (name != "glottis_normal" && name != "operator_eye") check("landmark " + name, point, kBelowTheScanMm);
  }
}

}  // namespace vallecula::pipeline

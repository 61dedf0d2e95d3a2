#include "pipeline/quality.h"

#include <algorithm>

#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

double millilitres(const Labels& labels, std::uint8_t label) {
  return static_cast<double>(std::count(labels.voxels.begin(), labels.voxels.end(), label)) * labels.grid.voxel_mm3() /
         1000.0;
}

/// A figure that no published limit is known for at this size: shown, not judged.
QualityItem plain(const std::string& name, double value, const std::string& unit, const std::string& note) {
  return {name, value, unit, true, note, false};
}

/// Limits in cubed term lengths: a tongue half or four times the usual is a segmentation to look at, not to trust.
QualityItem volume_item(const std::string& name, double ml, double low, double high) {
  const bool ok = ml >= low && ml <= high;
  return {name, ml, "ml", ok, ok ? "" : "outside what is usual for a head of this size; check the labels"};
}

}  // namespace

std::map<std::string, Material> default_materials() {
  return {{"tongue", {6000.0, 0.45, 1040.0}}, {"epiglottis", {90e3, 0.45, 1040.0}}};
}

std::vector<QualityItem> quality_report(const Segmentation& s, const PatientPackage& package,
                                        const std::vector<std::string>& notes) {
  std::vector<QualityItem> items;
  const double k = s.frame.scale;
  const double k3 = k * k * k;
  items.push_back(plain("head size", k / s.pose.scale, "of term", "breadth of the skull over that of a term infant"));
  if (s.pose.scale != 1.0) {
    items.push_back({"scaled", s.pose.scale, "times", false,
                     "a larger patient's head at a newborn's size, as was asked for: an adult's proportions are others"});
  }
  items.push_back(volume_item("tongue volume", millilitres(s.labels, kTongue), 2.5 * k3, 22.0 * k3));
  items.push_back(volume_item("epiglottis volume", millilitres(s.labels, kEpiglottis), 0.05 * k3, 1.0 * k3));
  items.push_back(volume_item("airway volume", millilitres(s.labels, kAirway), 4.0 * k3, 80.0 * k3));
  items.push_back(volume_item("mandible volume", millilitres(s.labels, kMandible), 2.0 * k3, 25.0 * k3));
  const bool open = !s.head.lips.empty();
  items.push_back({"mouth open", open ? 1.0 : 0.0, "", open,
                   open ? "" : "the mouth is closed: good for pressing on the tongue, not for a view"});
  const auto moved = [&](const char* name, double degrees, const char* how) {
    if (degrees != 0.0) items.push_back({name, degrees, "degrees", false, how});
  };
  moved("mouth opened", s.pose.mouth_opened_deg,
        "closed in the scan: the jaw was turned about its joints, the lips drawn back, the tongue taken off the palate");
  moved("head extended", s.pose.extension_deg, "not extended in the scan: neck and larynx were turned under the head");
  const double gap = norm(Vector3(s.landmarks.at("upper_gum_midline")) - Vector3(s.landmarks.at("lower_gum_midline")));
  // CLINICAL.md; how far a mouth is open is the position's doing, so it is told and not judged.
  items.push_back(
      plain("gap between the gums", gap, "mm", "widest opening below one month of age: 22.0 (20.4 to 23.6)"));
  items.push_back(plain("glottis area", s.airway.glottis.area_mm2, "mm2", ""));
  for (const auto& [name, surface] : package.surfaces) {
    if (name == "glottis") continue;
    const auto f = facts_of(surface);
    items.push_back({name + " surface", static_cast<double>(surface.triangles.size()), "triangles", f.fault.empty(),
                     f.fault.empty() ? "closed, " + std::to_string(f.parts) + " part" : f.fault});
  }
  const auto q = quality_of(package.tongue);
  const auto leaf = std::count(package.tongue.tissue.begin(), package.tongue.tissue.end(), 1);
  items.push_back(plain("tetrahedra", static_cast<double>(package.tongue.tets.size()), "",
                        std::to_string(leaf) + " of the epiglottis"));
  items.push_back({"tetrahedra volume", q.volume_mm3 / 1000.0, "ml", q.smallest_volume_mm3 > 0.0, ""});
  items.push_back({"smallest dihedral angle", q.smallest_dihedral_deg, "degrees", q.smallest_dihedral_deg > 5.0, ""});
  items.push_back(plain("shortest edge", q.shortest_edge_mm, "mm", ""));
  for (const auto anchor : {Anchor::mandible, Anchor::hyoid, Anchor::larynx}) {
    const auto n =
        std::count(package.tongue.anchor.begin(), package.tongue.anchor.end(), static_cast<std::uint8_t>(anchor));
    const char* name = anchor == Anchor::mandible ? "nodes held by the mandible"
                       : anchor == Anchor::hyoid  ? "nodes held by the hyoid"
                                                  : "nodes held by the larynx";
    const bool needed = anchor != Anchor::larynx || s.epiglottis.seen;
    items.push_back({name, static_cast<double>(n), "", n > 0, "", needed});
  }
  items.push_back(
      plain("epiglottis stiffness", package.materials.at("epiglottis").young_pa, "Pa",
            "stands for cartilage of 1 MPa: one layer of linear tetrahedra bends too stiffly by that much"));
  for (const auto& [name, finding] : package.findings) {
    // What a person gave needs no second look; what was not seen does.
    if (finding.origin == Origin::measured || finding.origin == Origin::given) continue;
    items.push_back({name_of(finding.origin), 0.0, "", false, name + ": " + finding.how});
  }
  for (const auto& text : notes) items.push_back(plain("note", 0.0, "", text));
  return items;
}

}  // namespace vallecula::pipeline

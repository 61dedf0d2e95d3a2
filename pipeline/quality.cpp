#include "pipeline/quality.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/mesh/triangle_tree.h"
#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {
namespace {

double millilitres(const Labels& labels, std::uint8_t label) {
  return static_cast<double>(std::count(labels.voxels.begin(), labels.voxels.end(), label)) * labels.grid.voxel_mm3() /
         1000.0;
}

/// A figure that no published limit is known for at this size: shown, not judged.
QualityItem plain(const std::string& name, std::optional<double> value, const std::string& unit,
                  const std::string& note) {
  return {name, value, unit, true, note, false};
}

/// Limits in cubed term lengths: a tongue half or four times the usual is a segmentation to look at, not to trust.
QualityItem volume_item(const std::string& name, double ml, double low, double high) {
  const bool ok = ml >= low && ml <= high;
  std::ostringstream usual;
  usual << std::setprecision(2) << "usual for a head of this size: " << low << " to " << high
        << " ml; check its labels";
  return {name, ml, "ml", ok, ok ? "" : usual.str()};
}

/// A volume over that of the labels.
QualityItem share_item(const std::string& name, double share) {
  const bool ok = std::abs(share - 1.0) <= 0.01;
  return {name, 100.0 * share, "%", ok, ok ? "" : "more than 1 % larger or smaller than the labels it was made from"};
}

/// Closed, in one piece, not crossing itself, and as large as the label it stands for.
void add_surfaces(const Segmentation& s, const PatientPackage& package, std::vector<QualityItem>& items) {
  for (const auto& [name, surface] : package.surfaces) {
    const auto crossings = self_intersections(surface).size();
    items.push_back({name + " surface crosses itself", static_cast<double>(crossings), "times", crossings == 0,
                     crossings == 0 ? "" : "a fault of the surface where a sheet is thin; look at it there"});
    if (name == "glottis") continue;
    const auto f = facts_of(surface);
    items.push_back({name + " surface", static_cast<double>(surface.triangles.size()), "triangles", f.fault.empty(),
                     f.fault.empty() ? "closed, " + std::to_string(f.parts) + " part" : f.fault});
  }
  for (const auto& [name, label] : {std::pair{"airway", kAirway}, std::pair{"mandible", kMandible}}) {
    const double ml = millilitres(s.labels, label);
    if (!(ml > 0.0)) continue;
    items.push_back(share_item(std::string("volume kept by the ") + name + " surface",
                               facts_of(package.surfaces.at(name)).volume_mm3 / 1000.0 / ml));
  }
}

void add_tetrahedra(const Segmentation& s, const PatientPackage& package, std::vector<QualityItem>& items) {
  const auto& mesh = package.tongue;
  const auto q = quality_of(mesh);
  const auto leaf = std::count(mesh.tissue.begin(), mesh.tissue.end(), 1);
  items.push_back(plain("tetrahedra", static_cast<double>(mesh.tets.size()), "",
                        std::to_string(leaf) + " of the epiglottis"));
  items.push_back({"tetrahedra volume", q.volume_mm3 / 1000.0, "ml", q.smallest_volume_mm3 > 0.0, ""});
  const double ml = millilitres(s.labels, kTongue) + millilitres(s.labels, kEpiglottis);
  if (ml > 0.0) items.push_back(share_item("volume kept by the tetrahedra", q.volume_mm3 / 1000.0 / ml));
  items.push_back({"smallest dihedral angle", q.smallest_dihedral_deg, "degrees", q.smallest_dihedral_deg > 5.0, ""});
  std::size_t sharp = 0;
  for (const auto& t : mesh.tets) {
    const auto angles =
        dihedral_range({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]});
    sharp += angles[0] < 10.0 ? 1 : 0;
  }
  items.push_back({"tetrahedra below 10 degrees", static_cast<double>(sharp), "", sharp == 0,
                   sharp == 0 ? "" : "thin ones; another count (--tets) may do without"});
  items.push_back(plain("shortest edge", q.shortest_edge_mm, "mm", ""));
}

/// Tissues meet and do not overlap: the tongue's nodes against the surfaces of jaw and head.
void add_neighbours(const Segmentation& s, const PatientPackage& package, std::vector<QualityItem>& items) {
  const auto& mesh = package.tongue;
  const double k = s.frame.scale;
  const SurfaceDistance jaw(package.surfaces.at("mandible"));
  const SurfaceDistance head(package.surfaces.at("face"));
  double in_jaw = 0.0;
  double in_head = 0.0;
  std::vector<double> gaps;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    in_jaw = std::max(in_jaw, -jaw.at(mesh.points[v]));
    const double d = head.at(mesh.points[v]);
    in_head = std::max(in_head, -d);
    if (mesh.anchor[v] == static_cast<std::uint8_t>(Anchor::mandible) ||
        mesh.anchor[v] == static_cast<std::uint8_t>(Anchor::hyoid))
      gaps.push_back(std::abs(d));
  }
  items.push_back({"tongue inside the jaw's bone", in_jaw, "mm", in_jaw < 0.5 * k, "the deepest node"});
  items.push_back({"tongue inside the tissue around it", in_head, "mm", in_head < 0.8 * k, "the deepest node"});
  if (gaps.empty()) return;
  std::nth_element(gaps.begin(), gaps.begin() + gaps.size() * 19 / 20, gaps.end());
  const double gap = gaps[gaps.size() * 19 / 20];
  items.push_back({"gap where the tongue is held", gap, "mm", gap < 0.8 * k, "19 of 20 nodes are nearer to what holds them"});
}

constexpr double kInfantBelow = 1.3;  ///< breadth of the skull over a term infant's

/// The skull's breadth grows by a half in the first year and by little after the sixth.
QualityItem size_item(double scale) {
  if (scale < kInfantBelow)
    return plain("head size", scale, "x term", "breadth of the skull over a term infant's: an infant's head");
  if (scale < 1.55) {
    return {"child size", scale, "x term", false,
            "a child's head, larger than an infant's: lengths in it are not a newborn's"};
  }
  return {"adult size", scale, "x term", false,
          "an adult's head, or that of a child of school age: lengths in it are not a newborn's"};
}

double largest_of(const PoseChange& pose) {
  return std::max({std::abs(pose.tilt_deg), std::abs(pose.turn_deg), std::abs(pose.nod_deg)});
}

std::string degrees(double angle) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << angle;
  return text.str();
}

}  // namespace

std::map<std::string, Material> default_materials() {
  return {{"tongue", {6000.0, 0.45, 1040.0}}, {"epiglottis", {90e3, 0.45, 1040.0}}};
}

std::vector<QualityItem> segmentation_quality(const Segmentation& s) {
  std::vector<QualityItem> items;
  const double k = s.frame.scale;
  const double k3 = k * k * k;
  items.push_back(size_item(k / s.pose.scale));
  if (s.pose.tilt_deg != 0.0 || s.pose.turn_deg != 0.0 || s.pose.nod_deg != 0.0) {
    items.push_back(plain("position corrected", largest_of(s.pose), "degrees",
                          "the head lay askew: tilt " + degrees(s.pose.tilt_deg) + ", turn " +
                              degrees(s.pose.turn_deg) + ", nod " + degrees(s.pose.nod_deg) +
                              "; labels.nrrd lies as scanned, all else upright"));
  }
  if (s.pose.scale != 1.0) {
    items.push_back({"scaled", s.pose.scale, "times", false,
                     "a larger patient's head at a newborn's size, as was asked for: an adult's proportions are others"});
  }
  items.push_back(volume_item("tongue volume", millilitres(s.labels, kTongue), 2.5 * k3, 22.0 * k3));
  items.push_back(volume_item("epiglottis volume", millilitres(s.labels, kEpiglottis), 0.05 * k3, 1.0 * k3));
  items.push_back(volume_item("airway volume", millilitres(s.labels, kAirway), 4.0 * k3, 80.0 * k3));
  items.push_back(volume_item("mandible volume", millilitres(s.labels, kMandible), 2.0 * k3, 25.0 * k3));
  const bool open = !s.head.lips.empty();
  items.push_back(
      {"mouth open", std::nullopt, "", open,
       !open                            ? "the mouth is closed: good for pressing on the tongue, not for a view"
       : s.pose.mouth_opened_deg != 0.0 ? "the lips stand apart after the opening"
                                        : "the lips stand apart"});
  const auto moved = [&](const char* name, double degrees, const char* how) {
    if (degrees != 0.0) items.push_back({name, degrees, "degrees", false, how});
  };
  moved("mouth opened", s.pose.mouth_opened_deg,
        "closed in the scan: the jaw was turned about its joints, the lips drawn back, the tongue taken off the palate");
  moved("head extended", s.pose.extension_deg, "not extended in the scan: neck and larynx were turned under the head");
  const double gap = norm(Vector3(s.landmarks.at("upper_gum_midline")) - Vector3(s.landmarks.at("lower_gum_midline")));
  // CLINICAL.md; how far a mouth is open is the position's doing, so it is told and not judged.
  items.push_back(plain("gap between the gums", gap, "mm",
                        k < kInfantBelow ? "widest opening below one month of age: 22.0 mm (20.4 to 23.6)" : ""));
  items.push_back(plain("glottis area", s.airway.glottis.area_mm2, "mm2", ""));
  return items;
}

std::vector<QualityItem> quality_report(const Segmentation& s, const PatientPackage& package,
                                        const std::vector<std::string>& notes) {
  auto items = segmentation_quality(s);
  add_surfaces(s, package, items);
  add_tetrahedra(s, package, items);
  add_neighbours(s, package, items);
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
  for (auto& item : finding_items(package.findings)) items.push_back(std::move(item));
  for (const auto& text : notes) items.push_back(plain("note", std::nullopt, "", text));
  return items;
}

std::vector<QualityItem> finding_items(const std::map<std::string, Finding>& findings) {
  std::vector<QualityItem> items;
  for (const auto& [name, finding] : findings) {
    // What a person gave needs no second look; what was not seen does.
    if (finding.origin == Origin::measured || finding.origin == Origin::given) continue;
    const std::string note = std::string(name_of(finding.origin)) + ": " + finding.how;
    const auto same = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.note == note; });
    if (same == items.end())
      items.push_back({words_of(name), std::nullopt, "", false, note});
    else
      same->name += ", " + words_of(name);
  }
  return items;
}

std::vector<QualityGroup> in_groups(const std::vector<QualityItem>& items) {
  std::vector<QualityGroup> groups{{"To be checked first", {}}, {"Within limits", {}}, {"For information", {}}};
  for (const auto& item : items) groups[!item.judged ? 2 : item.ok ? 1 : 0].items.push_back(item);
  const auto empty = [](const QualityGroup& group) { return group.items.empty(); };
  groups.erase(std::remove_if(groups.begin(), groups.end(), empty), groups.end());
  return groups;
}

std::string value_text(const QualityItem& item) {
  if (!item.value) return {};
  std::ostringstream text;
  if (std::abs(*item.value) >= 1000.0)  // never 1.6e+04 triangles
    text << std::fixed << std::setprecision(0) << *item.value;
  else
    text << std::setprecision(3) << *item.value;
  if (!item.unit.empty()) text << " " << item.unit;
  return text.str();
}

}  // namespace vallecula::pipeline

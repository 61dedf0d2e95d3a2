#include "pipeline/pose/position.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pipeline/pose/bare_face.h"
#include "pipeline/pose/resample.h"
#include "pipeline/segment/landmarks.h"
#include "pipeline/segment/upright.h"

namespace vallecula::pipeline {
namespace {

constexpr double kPerDegree = 3.14159265358979323846 / 180.0;

Mask of_label(const Labels& labels, std::uint8_t label) {
  return where(labels, [label](std::uint8_t v) { return v == label; });
}

/// Each voxel of a mask stamped where its centre goes.
Mask stamped(const Mask& mask, const Grid& onto, const Aim& aim, Tie tie) {
  Mask out(onto);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    if (mask.voxels[i] == 0) continue;
    const auto c = onto.nearest(tied(tie, aim, mask.grid.position(i)));
    if (onto.contains(c[0], c[1], c[2])) out.at(c[0], c[1], c[2]) = 1;
  }
  return out;
}

Section turned(Section section, const Turn& turn) {
  const Vector3 tip = turn(section.centre + section.normal);
  section.centre = turn(section.centre);
  section.normal = tip - section.centre;
  return section;
}

/// The airway's measures lie in the part that goes with the neck, rigidly.
void turn_airway(Airway& airway, const Turn& neck) {
  for (auto& cut : airway.course) cut = turned(cut, neck);
  airway.glottis = turned(airway.glottis, neck);
  airway.carina = neck(airway.carina);
  airway.front_commissure = neck(airway.front_commissure);
  for (auto& p : airway.glottis_outline) p = neck(p);
}

/// The piece of gas that the glottis opens into.
Mask lumen_about(const Mask& gas, const Vector3& glottis, double reach_mm) {
  const auto parts = components(gas);
  const auto id = piece_at(parts, glottis, reach_mm);
  return id != 0 ? parts.mask(id) : Mask(gas.grid);
}

/// Where the lips' edges have gone, on the new grid.
std::vector<LipGap> moved_lips(const std::vector<LipGap>& lips, const Grid& from, const Sheets& sheets, const Grid& to) {
  std::vector<LipGap> out;
  for (const auto& lip : lips) {
    const double x = from.origin[0] + lip.x * from.spacing[0];
    const auto upper = sheets.moved(kUpper, {x, lip.upper[0], lip.upper[1]});
    const auto lower = sheets.moved(kLower, {x, lip.lower[0], lip.lower[1]});
    out.push_back({to.nearest({x, 0, 0})[0], {upper[1], upper[2]}, {lower[1], lower[2]}});
  }
  return out;
}

/// The head as carried, and of what opened what lies behind the lips.
Head head_of(const Carried& carried, std::vector<LipGap> lips, double air) {
  const auto& g = carried.hu.grid;
  Head head;
  head.inside = where(carried.labels, [](std::uint8_t v) { return v != kBackground; });
  // Beside the scan nothing was carried either; that is no mouth.
  Mask rim(g);
  for (std::size_t i = 0; i < g.count(); ++i) {
    const auto c = g.cell(i);
    for (int a = 0; a < 3; ++a) {
      if (c[a] == 0 || c[a] == g.size[a] - 1) rim.voxels[i] = carried.opened.voxels[i];
    }
  }
  const auto beside = grown(rim, carried.opened);
  for (std::size_t i = 0; i < g.count(); ++i) {
    if (carried.opened.voxels[i] == 0 || beside.voxels[i] != 0) continue;
    const auto p = g.position(i);
    const int x = g.cell(i)[0];
    const auto lip = std::find_if(lips.begin(), lips.end(), [x](const LipGap& l) { return l.x == x; });
    if (lip != lips.end()) {
      const double height = lip->upper[1] - lip->lower[1];
      const double f = height > 1e-6 ? std::clamp((p[2] - lip->lower[1]) / height, 0.0, 1.0) : 0.5;
      if (p[1] < lip->lower[0] + f * (lip->upper[0] - lip->lower[0])) continue;
    }
    head.inside.voxels[i] = 1;
  }
  head.body = Mask(g);
  for (std::size_t i = 0; i < g.count(); ++i)
    head.body.voxels[i] = head.inside.voxels[i] != 0 && carried.hu.voxels[i] > air ? 1 : 0;
  // Narrow ends of the lips' line are none.
  lips.erase(std::remove_if(lips.begin(), lips.end(), [](const LipGap& l) { return l.upper[1] - l.lower[1] < 1.0; }),
             lips.end());
  head.lips = std::move(lips);
  return head;
}

/// Airway, skin and what lies in them, from the moved grey values; the other labels as carried.
void label_again(Segmentation& s, const Labels& carried) {
  const auto gas = without(s.head.inside, s.head.body);
  s.airway.lumen = lumen_about(gas, s.airway.glottis.centre, 6.0 * s.frame.scale);
  if (count(s.airway.lumen) == 0)
    throw std::runtime_error(
        "the airway was lost when the mouth was opened; import the scan as it lies with --keep-position");
  s.airway.other_gas = without(gas, s.airway.lumen);
  s.labels = Labels(s.hu.grid);
  for (std::size_t i = 0; i < s.labels.voxels.size(); ++i) {
    if (s.head.inside.voxels[i] == 0) continue;
    auto label = carried.voxels[i];
    const bool air = s.head.body.voxels[i] == 0;
    if (s.airway.lumen.voxels[i] != 0) {
      label = kAirway;
    } else if (label == kAirway || label == kBackground || (air && label != kOesophagus)) {
      label = kSkin;
    }
    s.labels.voxels[i] = label;
  }
}

/// Tongue and leaf are one body by the ligament about the vallecula's floor; where moving them left a seam of tissue
/// between the two, it is tongue.
void join_leaf(Segmentation& s, const Vector3& vallecula) {
  const double k = s.frame.scale;
  auto labels = cropped(s.labels, s.throat);
  const auto leaf = of_label(labels, kEpiglottis);
  const auto tongue = of_label(labels, kTongue);
  if (components(any_of(leaf, tongue)).sizes.size() < 3) return;
  const auto seam = all_of(dilated(leaf, 2.5 * k), dilated(tongue, 2.5 * k));
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    if (seam.voxels[i] != 0 && labels.voxels[i] == kSkin && labels.grid.position(i)[2] < vallecula[2] + 5.0 * k)
      labels.voxels[i] = kTongue;
  }
  paste(labels, s.throat, s.labels);
}

/// Says anew how those landmarks came about that the closed mouth hid: how they were found before no longer holds.
void find_landmarks_again(Segmentation& s, const std::map<std::string, Point>& given) {
  std::vector<std::string> hidden;
  for (const auto* name : {"upper_gum_midline", "lower_gum_midline", "condyle_axis", "hyoid"}) {
    const auto finding = s.findings.find(name);
    if (finding == s.findings.end() || finding->second.origin == Origin::measured || given.count(name) != 0) continue;
    s.findings.erase(finding);
    hidden.emplace_back(name);
  }
  find_landmarks(s, given);
  for (const auto& name : hidden)
    s.findings.emplace(name, Finding{Origin::inferred, "seen once the mouth was opened or the neck extended"});
}

}  // namespace

PositionFacts put_into_position(Segmentation& s, const std::function<void(double)>& progress) {
  const auto say = [&](double f) {
    if (progress) progress(f);
  };
  PositionFacts facts;
  facts.aim = aim_of(s);
  const auto& aim = facts.aim;
  if (!aim.any()) return facts;
  facts.bared_mm3 = bare_face(s);
  if (facts.bared_mm3 > 0.0) {
    s.findings["skin"] = {Origin::inferred, "strips of a mask, tape or wire before the mouth were taken off (" +
                                                std::to_string(std::lround(facts.bared_mm3)) + " mm3)"};
  }
  std::map<std::string, Point> given;
  const auto parts = parts_of(s, aim);
  say(0.1);
  const Sheets sheets(parts, aim, s.frame.scale);
  say(0.5);
  facts.smallest_jacobian = sheets.smallest_jacobian();
  facts.folded_mm3 = sheets.folded_mm3();
  facts.lower_volume_ratio = sheets.lower_volume_ratio();
  auto carried = carry(s, aim, parts, sheets);
  facts.overlap_mm3 = carried.overlap_mm3;
  say(0.75);

  for (auto& [name, point] : s.landmarks) {
    const auto finding = s.findings.find(name);
    if (finding == s.findings.end() || finding->second.origin != Origin::given) continue;
    if (name == "lower_gum_midline" || name == "condyle_axis") {
      given[name] = aim.jaw(point);
    } else if (name == "operator_eye") {
      given[name] = point;  // no tissue; it stays where the person put it, over the skull that does not move
    } else if (name != "glottis_normal") {
      given[name] = sheets.moved(kUpper, point);
    }
  }
  const auto tip = sheets.moved(kUpper, s.epiglottis.tip);
  const auto vallecula = sheets.moved(kUpper, s.epiglottis.vallecula);
  const auto hyoid = sheets.moved(kUpper, s.landmarks.at("hyoid"));
  const bool hyoid_seen = s.bones.hyoid_seen;
  s.bones.hyoid = stamped(s.bones.hyoid, carried.hu.grid, aim, Tie::hyoid);
  turn_airway(s.airway, aim.neck);

  // From here on as if the patient had been scanned so.
  s.head = head_of(carried, moved_lips(parts.lips, s.hu.grid, sheets, carried.hu.grid), s.thresholds.air);
  s.hu = std::move(carried.hu);
  s.box = whole(s.hu.grid);
  say(0.85);
  label_again(s, carried.labels);
  s.bones.skull = of_label(s.labels, kSkull);
  s.bones.mandible = of_label(s.labels, kMandible);
  s.bones.spine = of_label(s.labels, kSpine);
  s.throat = throat_of(s);
  if (s.epiglottis.seen) {
    join_leaf(s, vallecula);
    s.epiglottis.mask = largest_component(cropped(of_label(s.labels, kEpiglottis), s.throat));
    s.epiglottis.tip = tip;
    s.epiglottis.vallecula = vallecula;
  }
  if (!hyoid_seen) given["hyoid"] = hyoid;
  s.pose.mouth_opened_deg = aim.jaw.angle_rad / kPerDegree;
  s.pose.extension_deg = aim.neck.angle_rad / kPerDegree;
  find_landmarks_again(s, given);

  say(1.0);
  return facts;
}

void scale_lengths(Segmentation& s, double f) {
  const auto grid = [f](Grid& g) {
    for (int a = 0; a < 3; ++a) {
      g.spacing[a] *= f;
      g.origin[a] *= f;
    }
  };
  for (auto* v : {&s.head.body, &s.head.inside, &s.labels, &s.airway.lumen, &s.airway.other_gas, &s.bones.skull,
                  &s.bones.mandible, &s.bones.spine, &s.bones.hyoid, &s.epiglottis.mask})
    grid(v->grid);
  grid(s.hu.grid);
  const auto section = [f](Section& c) {
    c.centre = f * c.centre;
    c.area_mm2 *= f * f;
  };
  for (auto& c : s.airway.course) section(c);
  section(s.airway.glottis);
  s.airway.carina = f * s.airway.carina;
  s.airway.front_commissure = f * s.airway.front_commissure;
  for (auto& p : s.airway.glottis_outline) p = f * p;
  for (auto& lips : s.head.lips) {
    for (int a = 0; a < 2; ++a) {
      lips.upper[a] *= f;
      lips.lower[a] *= f;
    }
  }
  s.epiglottis.tip = f * s.epiglottis.tip;
  s.epiglottis.vallecula = f * s.epiglottis.vallecula;
  s.epiglottis.thickness_mm *= f;
  s.frame.scale *= f;
  s.frame.mid_x *= f;
  s.frame.skull_top *= f;
  for (auto& [name, point] : s.landmarks) {
    if (name != "glottis_normal") point = f * Vector3(point);
  }
  for (int row = 0; row < 3; ++row) {
    for (int c = 0; c < 4; ++c) s.pose.scan_to_package[4 * row + c] *= f;
  }
  s.pose.scale *= f;
  // The operator is no smaller: the eye stays as far from the gum.
  auto known = s.landmarks;
  const auto eye = s.findings.find("operator_eye");
  if (eye == s.findings.end() || eye->second.origin != Origin::given) known.erase("operator_eye");
  find_landmarks(s, known);
}

}  // namespace vallecula::pipeline

#include "pipeline/segment/segment.h"

#include <algorithm>
#include <stdexcept>

#include "pipeline/segment/border_field.h"
#include "pipeline/segment/given.h"
#include "pipeline/segment/landmarks.h"
#include "pipeline/segment/mouth_bounds.h"
#include "pipeline/segment/noise.h"
#include "pipeline/segment/resting_epiglottis.h"
#include "pipeline/segment/throat.h"
#include "pipeline/segment/tongue.h"
#include "pipeline/segment/tube.h"
#include "pipeline/segment/upright.h"

namespace vallecula::pipeline {
namespace {

/// The mesh of tongue and epiglottis is cut on the throat's box, so all of a given one must lie within.
Box throat_of(const Segmentation& s, const Given& given) {
  auto box = throat_of(s);
  for (const auto label : {kTongue, kEpiglottis}) {
    if (given.replaces(label)) box = united(box, bounds_of(given.mask(label), 5.0 * s.frame.scale));
  }
  return box;
}

void put(const Mask& mask, std::uint8_t label, Labels& labels) {
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    if (mask.voxels[i] != 0) labels.voxels[i] = label;
  }
}

/// What is found inside mouth and throat, on a grid of its own.
void label_throat(Segmentation& s, const Given& given, const std::function<void(const char*, double)>& progress) {
  s.throat = throat_of(s, given);
  const auto crop = [&](const auto& v) { return cropped(v, s.throat); };
  const auto hu = crop(s.hu);
  const auto body = crop(s.head.body);
  const auto inside = crop(s.head.inside);
  const auto lumen = crop(s.airway.lumen);
  const auto skull = crop(s.bones.skull);
  const auto mandible = crop(s.bones.mandible);
  const auto spine = crop(s.bones.spine);
  const auto hyoid = crop(s.bones.hyoid);
  auto labels = crop(s.labels);
  const auto claimed = given.any() ? crop(given.claimed()) : Mask(hu.grid);
  const auto tongue_seed = given.seed("tongue");
  /// A structure as given, or as `find` finds it, without what others given claim and within its thresholds.
  const auto structure = [&](std::uint8_t label, const char* name, const auto& find) {
    if (given.replaces(label)) return crop(given.mask(label));
    Mask found = find();
    given.trim(name, hu, claimed, s.frame.scale, found);
    return found;
  };

  if (given.replaces(kEpiglottis)) {
    s.epiglottis = measured_epiglottis(crop(given.mask(kEpiglottis)), lumen, s.frame);
  } else {
    s.epiglottis = find_epiglottis(body, lumen, s.airway, s.frame, given.seed("epiglottis"));
    if (!s.epiglottis.seen) {
      s.epiglottis = rest_epiglottis(hu, body, lumen, hyoid, s.airway, s.frame);
      if (s.epiglottis.seen) {
        const Finding resting{
            Origin::inferred,
            "its leaf lies against the tongue: taken as 1.7 mm (term) of the airway's front wall, from the "
            "cords to 10 mm (term) above the lowest gas in the vallecula, or above the hyoid"};
        for (const auto* name : {"epiglottis", "epiglottis_tip", "vallecula"}) s.findings[name] = resting;
      }
    }
    given.trim("epiglottis", hu, claimed, s.frame.scale, s.epiglottis.mask);
  }
  s.epiglottis.tip = given.landmark("epiglottis_tip").value_or(s.epiglottis.tip);
  s.epiglottis.vallecula = given.landmark("vallecula").value_or(s.epiglottis.vallecula);
  progress("tongue", 0.2);
  const auto bounds = bound_mouth(body, lumen, skull, mandible, hyoid, s.airway, s.epiglottis, s.frame);
  bool resting = false;  // does the tongue fill the mouth, with no air over it?
  const auto tongue = structure(kTongue, "tongue", [&] {
    auto found = find_tongue({hu, body, inside, lumen, skull, mandible, hyoid, s.epiglottis, s.airway, s.thresholds,
                              s.frame, tongue_seed, s.head.lips.empty()},
                             bounds);
    resting = found.mouth_closed;
    return std::move(found.mask);
  });
  if (count(tongue) == 0) {
    throw std::runtime_error(
        tongue_seed
            ? "no tongue could be grown from the seed given; is it inside the tongue (x to the left, y to the back, z "
              "to "
              "the head, mm)?"
            : "the tongue was not found: no air lies over it and no jaw or palate bounds it; give a point inside it: "
              "--seed tongue=x,y,z (LPS mm)");
  }
  if (resting) {
    s.findings["tongue"] = {Origin::inferred,
                            bounds.found ? "the mouth is closed: bounded by palate, jaws, hyoid and throat; where the "
                                           "grey values show no border, by the usual course of the muscles of the floor"
                                         : "the mouth is closed: grown from the point given, to half way to bone"};
  }
  progress("soft palate and larynx", 0.7);
  const bool against = resting && bounds.found;
  const auto palate = structure(kSoftPalate, "soft_palate", [&] {
    if (against) return without(bounds.soft_palate, any_of(tongue, s.epiglottis.mask));
    return find_soft_palate(body, lumen, skull, s.epiglottis, s.airway, s.frame, given.seed("soft_palate"));
  });
  if (against) {
    s.findings["soft_palate"] = {Origin::inferred,
                                 "it lies against the tongue: taken as 3.6 mm (term) of what lies before the airway"};
  }
  auto taken = any_of(any_of(tongue, s.epiglottis.mask), any_of(palate, any_of(skull, any_of(mandible, spine))));
  const auto larynx =
      structure(kLarynx, "larynx", [&] { return find_larynx(body, lumen, taken, s.airway, s.frame); });
  taken = any_of(taken, larynx);
  const auto oesophagus = structure(kOesophagus, "oesophagus", [&] {
    return find_oesophagus(body, crop(s.airway.other_gas), spine, taken, s.airway, s.frame);
  });
  put(oesophagus, kOesophagus, labels);
  put(larynx, kLarynx, labels);
  put(palate, kSoftPalate, labels);
  put(tongue, kTongue, labels);
  put(s.epiglottis.mask, kEpiglottis, labels);
  paste(labels, s.throat, s.labels);
  progress("soft palate and larynx", 1.0);
}

/// The airway from its hints, and the glottis and the carina where a person put them.
Airway airway_of(const Segmentation& s, const Given& given, const std::optional<Vector3>& cords_at) {
  AirwayHints hints;
  hints.cords_at = cords_at;
  hints.seed = given.seed("airway");
  hints.cords_near = given.seed("larynx");
  auto air = air_field(s.hu, s.thresholds);
  if (given.replaces(kAirway)) {
    hints.lumen = given.mask(kAirway);
    air = with_border_of(air, *hints.lumen);
  }
  auto airway = find_airway(air, s.head, s.frame, hints);
  if (const auto range = given.threshold("airway"); range && !hints.lumen) {
    for (std::size_t i = 0; i < s.hu.voxels.size(); ++i) {
      if (s.hu.voxels[i] < (*range)[0]) airway.lumen.voxels[i] = 0;
    }
  }
  const auto centre = given.landmark("glottis_centre");
  const auto normal = given.landmark("glottis_normal");
  if (centre || normal) {
    place_glottis(airway, air, centre.value_or(airway.glottis.centre), normal.value_or(airway.glottis.normal),
                  s.frame.scale);
  }
  if (const auto carina = given.landmark("carina")) {
    airway.carina = *carina;
    airway.carina_seen = true;
  }
  return airway;
}

Bones bones_of(Segmentation& s, const Given& given) {
  auto thresholds = s.thresholds;
  thresholds.bone = lowest_bone(given.edits(), thresholds.bone);
  auto bones = find_bones(s.hu, thresholds, s.frame, s.head, s.airway,
                          {given.seed("bone_skull"), given.seed("bone_mandible"), given.seed("spine"),
                           given.seed("hyoid")});
  given.put_into(bones, s.hu, s.thresholds);
  for (const auto& [label, name] : {std::pair{kSkull, "bone_skull"}, std::pair{kMandible, "bone_mandible"}}) {
    if (const auto range = given.threshold(name)) s.bone_hu[label] = (*range)[0];
  }
  return bones;
}

/// What nothing else was said of was read off the scan.
void name_measured(Segmentation& s) {
  for (const auto& label : kLabelNames) {
    if (std::find(s.labels.voxels.begin(), s.labels.voxels.end(), label.value) != s.labels.voxels.end())
      s.findings.emplace(label.name, Finding{});
  }
  for (const auto& [name, point] : s.landmarks) s.findings.emplace(name, Finding{});
}

}  // namespace

Box throat_of(const Segmentation& s) {
  const auto& g = s.labels.grid;
  const double k = s.frame.scale;
  const auto lumen = bounds_of(s.airway.lumen);
  const auto jaw = bounds_of(s.bones.mandible);
  double front = g.origin[1] + lumen.low[1] * g.spacing[1];
  const auto& c = s.airway.glottis.centre;
  double high = c[2] + 66.0 * k;
  if (!jaw.empty()) front = std::min(front, g.origin[1] + jaw.low[1] * g.spacing[1]);
  // A grown-up's larynx lies lower under the roof of the mouth than an infant's.
  if (const auto roof = find_roof(s.bones.skull, s.bones.mandible, s.frame); roof.seen)
    high = std::max(high, roof.front[2] + 11.0 * k);
  return box_between(g, {s.frame.mid_x - 34.0 * k, front - 4.0 * k, c[2] - 60.0 * k},
                     {s.frame.mid_x + 34.0 * k, c[1] + 22.0 * k, high});
}

Segmentation segment(const Hounsfield& series, const Edits& edits_on_scan,
                     const std::function<void(const std::string&, double)>& progress) {
  const auto say = [&](const char* what, double fraction) {
    if (progress) progress(what, fraction);
  };
  check_edits(edits_on_scan);
  check_edits_in(edits_on_scan, series.grid);
  Segmentation s;
  say("head", 0.0);
  s.thresholds = with_given(thresholds_of(series), edits_on_scan);
  std::vector<Tube> tubes;
  {
    auto body = find_body(series, s.thresholds);
    s.box = united(bounds_of(body, 6.0), box_of_given(edits_on_scan, series.grid));
    s.hu = cropped(series, s.box);
    auto here = cropped(body, s.box);
    body = Mask();
    s.frame = frame_of(s.hu, here, s.thresholds);
    say("head", 0.1);
    s.pose = find_pose(s.hu, here, s.frame);
    if (s.pose.moved()) {
      // From here on all lies in the package's frame.
      s.hu = put_upright(s.hu, here, s.thresholds, s.pose);
      s.box = whole(s.hu.grid);
      here = find_body(s.hu, s.thresholds);
      s.frame = frame_of(s.hu, here, s.thresholds);
    }
    s.thresholds.noise = noise_of(s.hu, here, s.thresholds);
    say("head", 0.25);
    tubes = take_out_tubes(s.hu, s.thresholds, s.frame);
    if (!tubes.empty()) here = find_body(s.hu, s.thresholds);
    s.head = find_head(s.hu, here, s.thresholds, s.frame);
  }
  const auto edits = put_upright(edits_on_scan, s.pose, s.hu.grid);
  const Given given(edits, s.hu.grid);
  given.put_into(s.head, s.hu, s.thresholds.air);
  s.replaced = given.edits().replaced;
  say("airway", 0.5);
  const auto cords_at = cords_around(tubes, s.frame.scale);
  s.airway = airway_of(s, given, cords_at);
  if (!tubes.empty()) s.findings["airway"] = {Origin::inferred, describe(tubes, s.head, s.airway, s.frame.scale)};
  if (cords_at) {
    const Finding held{Origin::inferred,
                       "a tube held the cords apart: half way between where it came free above them and where the "
                       "windpipe lay all around it"};
    for (const auto* name : {"glottis_centre", "glottis_normal"}) s.findings[name] = held;
  }
  say("bones", 0.55);
  s.bones = bones_of(s, given);

  if (s.bones.mandible_free) {
    // The head may be turned on the neck: for mouth and throat the middle is that of the jaw.
    const auto jaw = bounds_of(s.bones.mandible);
    s.frame.mid_x = s.hu.grid.origin[0] + 0.5 * (jaw.low[0] + jaw.high[0]) * s.hu.grid.spacing[0];
  }

  s.labels = Labels(s.hu.grid);
  put(s.head.inside, kSkin, s.labels);
  put(s.bones.spine, kSpine, s.labels);
  put(s.bones.skull, kSkull, s.labels);
  put(s.bones.mandible, kMandible, s.labels);
  put(s.airway.lumen, kAirway, s.labels);
  say("epiglottis", 0.72);
  if (const auto tongue_seed = given.seed("tongue")) {
    const auto c = s.hu.grid.nearest(*tongue_seed);
    if (!s.hu.grid.contains(c[0], c[1], c[2]) || s.head.inside.at(c[0], c[1], c[2]) == 0) {
      throw std::runtime_error(
          "the tongue's seed lies outside the head; coordinates are LPS mm (x to the left, y to the back, z to the "
          "head)");
    }
  }
  label_throat(s, given, [&](const char* what, double f) { say(what, 0.72 + 0.25 * f); });
  if (!s.bones.mandible_free)
    s.findings["bone_mandible"] = {Origin::inferred, "could not be parted from the skull; it is labelled bone_skull"};
  given.put_into(s.labels, s.head.inside);
  say("landmarks", 0.97);
  find_landmarks(s, edits.landmarks);
  given.name_origins(s.findings);
  name_measured(s);
  say("landmarks", 1.0);
  return s;
}

Labels on_series_grid(const Segmentation& s, const Grid& series) {
  if (s.pose.moved()) return read_onto(series, s.pose.scan_to_package, s.labels, s.hu, s.thresholds);
  Labels out(series);
  paste(s.labels, s.box, out);
  return out;
}

}  // namespace vallecula::pipeline

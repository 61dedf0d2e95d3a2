#include "pipeline/segment/given.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vallecula::pipeline {
namespace {

/// Half of the epiglottis of the smallest infant.
constexpr double kSmallestStructureMm3 = 15.0;

/// The label of `from` at each voxel of `onto`, of the replaced ones only.
Labels replaced_on(const Edits& edits, const Grid& onto) {
  Labels out(onto);
  if (!edits.labels) return out;
  const auto& from = *edits.labels;
  std::array<std::vector<int>, 3> source;  // both grids lie along the patient's axes
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < onto.size[a]; ++i) {
      const double v = (onto.origin[a] + i * onto.spacing[a] - from.grid.origin[a]) / from.grid.spacing[a];
      source[a].push_back(v > -0.5 && v < from.grid.size[a] - 0.5 ? static_cast<int>(std::floor(v + 0.5)) : -1);
    }
  }
  std::size_t at = 0;
  for (const int z : source[2]) {
    for (const int y : source[1]) {
      for (const int x : source[0]) {
        const std::uint8_t label = x < 0 || y < 0 || z < 0 ? std::uint8_t{kBackground} : from.at(x, y, z);
        out.voxels[at++] = edits.replaced.count(label) != 0 ? label : std::uint8_t{kBackground};
      }
    }
  }
  return out;
}

/// Holes large enough for a structure that the map does not have; a hole of a few voxels is as it was drawn.
Mask structures_left_out(const Mask& drawn) {
  auto holes = without(with_holes_filled(drawn), drawn);
  const auto parts = components(holes);
  for (std::size_t i = 0; i < holes.voxels.size(); ++i) {
    const auto voxels = parts.sizes[static_cast<std::size_t>(parts.id.voxels[i])];
    if (static_cast<double>(voxels) * drawn.grid.voxel_mm3() < kSmallestStructureMm3) holes.voxels[i] = 0;
  }
  return holes;
}

std::string in_words(const std::array<double, 2>& hu) {
  std::ostringstream text;
  if (hu[1] == kNoHighest)
    text << hu[0] << " HU and above";
  else
    text << hu[0] << " to " << hu[1] << " HU";
  return text.str();
}

bool is_bone(const char* name) {
  const std::string text = name;
  return text == "bone_skull" || text == "bone_mandible" || text == "spine";
}

/// Grey values without their noise, for tissue; bone and air are told apart by far more than noise.
Volume<float> judged_values(const char* name, const Hounsfield& hu, double scale) {
  const auto grey = to_float(hu);
  return is_bone(name) || std::string(name) == "airway" ? grey : smoothed(grey, 0.5 * scale);
}

}  // namespace

Given::Given(const Edits& edits, const Grid& grid) : edits_(edits) {
  if (!edits_.replaced.empty()) map_ = replaced_on(edits_, grid);
  edits_.labels.reset();
  // A label that has no voxel here replaces nothing.
  for (auto label = edits_.replaced.begin(); label != edits_.replaced.end();) {
    const bool there = std::find(map_.voxels.begin(), map_.voxels.end(), *label) != map_.voxels.end();
    label = there ? std::next(label) : edits_.replaced.erase(label);
  }
}

Mask Given::mask(std::uint8_t label) const {
  return where(map_, [label](std::uint8_t v) { return v == label; });
}

Mask Given::claimed() const {
  return where(map_, [](std::uint8_t v) { return v != kBackground && v != kSkin; });
}

std::optional<Vector3> Given::seed(const char* name) const {
  const auto found = edits_.seeds.find(name);
  return found == edits_.seeds.end() ? std::nullopt : std::optional<Vector3>(found->second);
}

std::optional<std::array<double, 2>> Given::threshold(const char* name) const {
  const auto found = edits_.thresholds.find(name);
  return found == edits_.thresholds.end() ? std::nullopt : std::optional<std::array<double, 2>>(found->second);
}

std::optional<Vector3> Given::landmark(const char* name) const {
  const auto found = edits_.landmarks.find(name);
  if (found == edits_.landmarks.end()) return std::nullopt;
  return std::string(name) == "glottis_normal" ? unit(found->second) : found->second;
}

void Given::put_into(Head& head, const Hounsfield& hu, double air) const {
  if (edits_.replaced.empty()) return;
  if (replaces(kSkin)) {
    const auto gas = without(head.inside, head.body);
    const auto drawn = where(map_, [](std::uint8_t v) { return v != kBackground; });
    head.inside = any_of(drawn, structures_left_out(drawn));
    // Mouth and nose open to the outside: their air is no hole of the skin.
    if (!replaces(kAirway)) head.inside = any_of(head.inside, gas);
    for (std::size_t i = 0; i < hu.voxels.size(); ++i)
      head.body.voxels[i] = head.inside.voxels[i] != 0 && hu.voxels[i] > air ? 1 : 0;
  }
  for (std::size_t i = 0; i < map_.voxels.size(); ++i) {
    const auto label = map_.voxels[i];
    if (label == kBackground || label == kSkin) continue;
    head.inside.voxels[i] = 1;
    head.body.voxels[i] = label == kAirway ? 0 : 1;
  }
}

void Given::put_into(Bones& bones, const Hounsfield& hu, const Thresholds& usual) const {
  if (!any() && edits_.thresholds.empty()) return;
  const auto claims = any() ? claimed() : Mask(hu.grid);
  for (const auto& [label, name, bone] :
       {std::tuple{kSkull, "bone_skull", &bones.skull}, std::tuple{kMandible, "bone_mandible", &bones.mandible},
        std::tuple{kSpine, "spine", &bones.spine}}) {
    if (replaces(label)) {
      *bone = mask(label);
      continue;
    }
    const auto range = threshold(name).value_or(std::array<double, 2>{usual.bone, 1e9});
    for (std::size_t i = 0; i < bone->voxels.size(); ++i) {
      const double v = hu.voxels[i];
      if (claims.voxels[i] != 0 || v < range[0] || v > range[1]) bone->voxels[i] = 0;
    }
  }
  if (replaces(kMandible)) bones.mandible_free = true;
}

void Given::trim(const char* name, const Hounsfield& hu, const Mask& claimed, double scale, Mask& found) const {
  found = without(found, claimed);
  const auto range = threshold(name);
  if (!range || count(found) == 0) return;
  const auto values = judged_values(name, hu, scale);
  for (std::size_t i = 0; i < found.voxels.size(); ++i) {
    if (values.voxels[i] < (*range)[0] || values.voxels[i] > (*range)[1]) found.voxels[i] = 0;
  }
  const auto parts = components(found);
  if (parts.sizes.size() < 2)
    throw EditError(std::string("threshold ") + name + ": nothing of it lies within " + in_words(*range));
  int piece = 1;
  if (const auto point = seed(name)) piece = std::max(1, piece_at(parts, *point, 3.0 * scale));
  found = with_holes_filled(parts.mask(piece));
}

void Given::put_into(Labels& labels, const Mask& inside) const {
  if (edits_.replaced.empty()) return;
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    auto& label = labels.voxels[i];
    const auto given = map_.voxels[i];
    if (given != kBackground && given != kSkin) {
      label = given;
    } else if (label != kSkin && replaces(label)) {
      label = inside.voxels[i] != 0 ? kSkin : kBackground;
    }
  }
}

void Given::name_origins(std::map<std::string, Finding>& findings) const {
  for (const auto& [name, point] : edits_.seeds) {
    (void)point;
    findings[name] = {Origin::given, name == "larynx" ? "about the glottis that is nearest to the point given"
                                                      : "grown from the point given"};
  }
  for (const auto& [name, hu] : edits_.thresholds) {
    auto& finding = findings[name];
    finding.how = (finding.how.empty() || finding.origin != Origin::given ? "" : finding.how + ", ") +
                  std::string("within the threshold given, ") + in_words(hu);
    finding.origin = Origin::given;
  }
  for (const auto& label : kLabelNames) {
    if (replaces(label.value)) findings[label.name] = {Origin::given, "from the label map given"};
  }
  for (const auto& [name, point] : edits_.landmarks) {
    (void)point;
    findings[name] = {Origin::given, "placed by a person"};
  }
}

double lowest_bone(const Edits& edits, double usual) {
  double bone = usual;
  for (const auto* name : {"bone_skull", "bone_mandible", "spine"}) {
    if (const auto found = edits.thresholds.find(name); found != edits.thresholds.end())
      bone = std::min(bone, found->second[0]);
  }
  return bone;
}

Thresholds with_given(Thresholds t, const Edits& edits) {
  if (const auto skin = edits.thresholds.find("skin"); skin != edits.thresholds.end()) t.air = skin->second[0];
  if (const auto airway = edits.thresholds.find("airway"); airway != edits.thresholds.end()) t.air = airway->second[1];
  return t;
}

Box box_of_given(const Edits& edits, const Grid& grid) {
  if (edits.replaced.empty()) return {};
  return bounds_of(where(replaced_on(edits, grid), [](std::uint8_t v) { return v != kBackground; }));
}

Box united(const Box& a, const Box& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  Box out;
  for (int i = 0; i < 3; ++i) {
    out.low[i] = std::min(a.low[i], b.low[i]);
    out.high[i] = std::max(a.high[i], b.high[i]);
  }
  return out;
}

}  // namespace vallecula::pipeline

#include "gui/session/play_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>

#include "curricula/scenario.h"
#include "device/haptic_device.h"
#include "engine/haptics/runner.h"
#include "engine/sight/line_of_sight.h"
#include "engine/tool/miller_blade.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/device_choice.h"
#include "gui/session/hands_port.h"
#include "gui/session/scene_from_package.h"
#include "gui/session/scripted_hands.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;
using pipeline::PatientPackage;
using pipeline::QualityItem;

constexpr double kHiddenAtRest = 0.05;  ///< ANATOMY: nothing is seen before the lift; a sliver is forgiven
/// What is tried in turn, mm (term) along the sight and the lift from the plan: whether the epiglottis comes up hangs
/// on half a millimetre of the tip, as a person finds out by feeling for it.
constexpr std::array<std::array<double, 2>, 6> kApproaches = {
    {{0.0, 0.0}, {0.75, 1.5}, {-0.75, 0.0}, {0.75, 0.0}, {-0.75, 1.5}, {1.5, 0.75}}};
// Shares of the progress, as the times lie: the scene is built first, and most glottises are seen in the first try
// before its end.
constexpr double kSceneShare = 0.25, kFirstShare = 0.9, kUsuallySeen = 0.85;
const std::string kNotReady = "not ready for practice: ";
constexpr double kLiftIsOver_s = 11.5;  ///< of the expert's plan: from here on the blade goes out
constexpr std::int64_t kTicksBetweenSights = 20;

/// The usual blade for a patient of this size. CLINICAL has it by weight: below 1 kg 00, below 3 kg 0; the manikin's
/// lengths go with the cube root of the weight over 3.2 kg. Above an infant's size the blade must reach from the
/// vallecula past the gum by 25 mm (assumed), for lip and heel.
const char* blade_for(double size) {
  if (size < std::cbrt(1.0 / 3.2)) return "miller-00";
  if (size < std::cbrt(3.0 / 3.2)) return "miller-0";
  const double reach_m = 0.0503 * size + 0.025;
  for (const char* name : {"miller-1", "miller-2"})
    if (reach_m < engine::miller_blade(name).length) return name;
  return "miller-3";
}

struct Played {
  double at_rest = 0.0;  ///< share of the glottis
  double lifted = 0.0;   ///< the most that was seen
  double time_s = 0.0;   ///< when that was
  double peak_n = 0.0;   ///< model force on the blade until then
  bool limited = false;  ///< the device's limit ended it
  bool fault = false;
};

Played play(const PatientPackage& package, const std::shared_ptr<const engine::Scene>& scene,
            const curricula::Scenario& scenario, const std::function<void(double)>& progress) {
  const auto device = make_device("scripted:expert", {package, scenario, nullptr});
  device::GuardedDevice guard(*device, device::guard_for(device->info()));
  HandsPort port(guard);
  engine::Runner runner(scene, port);
  Played played;
  bool first = true;
  bool over = false;
  double now_s = 0.0;
  while (!over) {
    if (progress) progress(now_s / kLiftIsOver_s);
    runner.run(kTicksBetweenSights, [&](const engine::TickRecord& tick) {
      now_s = tick.time_s;
      played.fault = played.fault || (tick.faults & (engine::kFaultTissue | engine::kFaultForce)) != 0;
      played.limited = played.limited || tick.state == engine::HapticState::lost;
      played.peak_n = std::max(played.peak_n, tick.model_force_n.norm());
      over = over || played.fault || played.limited || tick.time_s > kLiftIsOver_s || device->finished(tick.time_s);
      if (!tick.has_sight) return;
      if (first) played.at_rest = tick.glottis_visible;
      first = false;
      if (tick.glottis_visible <= played.lifted) return;
      played.lifted = tick.glottis_visible;
      played.time_s = tick.time_s;
      over = over || played.lifted >= kSeenEnough;
    });
  }
  return played;
}

/// Where the way from a to b first meets the triangle, as a share of it; nothing when it does not (Moeller and Trumbore
/// 1997).
std::optional<double> crossing(const Vec3& a, const Vec3& way, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 u = q - p, v = r - p, across = way.cross(v);
  const double det = u.dot(across);
  if (std::abs(det) < 1e-12) return {};
  const Vec3 from = a - p;
  const double s = from.dot(across) / det;
  if (s < 0.0 || s > 1.0) return {};
  const Vec3 w = from.cross(u);
  const double t = way.dot(w) / det;
  if (t < 0.0 || s + t > 1.0) return {};
  const double along = v.dot(w) / det;
  if (along <= 0.0 || along >= 1.0) return {};
  return along;
}

const char* words_for(pipeline::Tissue tissue) {
  switch (tissue) {
    case pipeline::Tissue::lip:
      return "a lip";
    case pipeline::Tissue::gum:
      return "a gum";
    case pipeline::Tissue::palate:
      return "the palate";
    case pipeline::Tissue::mucosa:
      return "the wall of the mouth or throat";
    case pipeline::Tissue::larynx:
      return "the larynx";
    case pipeline::Tissue::skin:
      break;
  }
  return "the face";
}

/// What fixed anatomy most lines from the operator's eye to the glottis meet first, and where; empty when none does.
std::string in_the_way(const PatientPackage& package) {
  const auto& face = package.surfaces.at("face");
  const auto& p = package.landmarks.at("operator_eye");
  const Vec3 eye(p[0], p[1], p[2]);
  std::map<pipeline::Tissue, std::pair<int, Vec3>> met;
  for (const auto& target : package.surfaces.at("glottis").points) {
    const Vec3 way = Vec3(target[0], target[1], target[2]) - eye;
    double nearest = 1.0;
    std::size_t hit = face.triangles.size();
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      const auto at = [&](int corner) {
        const auto& q = face.points[static_cast<std::size_t>(face.triangles[t][static_cast<std::size_t>(corner)])];
        return Vec3(q[0], q[1], q[2]);
      };
      const auto along = crossing(eye, way, at(0), at(1), at(2));
      if (!along || *along >= nearest) continue;
      nearest = *along;
      hit = t;
    }
    if (hit == face.triangles.size()) continue;
    auto& [count, where] = met[static_cast<pipeline::Tissue>(face.tissue[hit])];
    ++count;
    where = eye + nearest * way;
  }
  const auto most = std::max_element(met.begin(), met.end(),
                                     [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
  if (most == met.end()) return "";
  char text[160];
  const Vec3& where = most->second.second;
  std::snprintf(text, sizeof text, "%s stands in the line of sight at %.0f, %.0f, %.0f mm (package frame, LPS)",
                words_for(most->first), where.x(), where.y(), where.z());
  return text;
}

/// Why the glottis could not be brought into sight, in the order in which a person would look.
std::string reason(const PatientPackage& package, const engine::SceneDescription& description,
                   const curricula::Scenario& scenario, const Played& played, double past_anatomy) {
  const auto& upper = package.landmarks.at("upper_gum_midline");
  const auto& lower = package.landmarks.at("lower_gum_midline");
  const double gap = std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
  double low = 1e9, high = -1e9;
  for (const auto& p : description.tool.surface.points) {
    low = std::min(low, 1e3 * p.z());
    high = std::max(high, 1e3 * p.z());
  }
  char text[240];
  if (gap < high - low) {
    std::snprintf(text, sizeof text,
                  "the mouth is too narrow: %.1f mm between the gums, and the blade (%s) is %.1f mm high", gap,
                  scenario.blade.c_str(), high - low);
    return text;
  }
  if (past_anatomy < kSeenEnough) {
    std::snprintf(text, sizeof text,
                  "only %.0f %% of the glottis could be seen past the fixed anatomy, even without a tongue",
                  100.0 * past_anatomy);
    const std::string what = in_the_way(package);
    return text + (what.empty() ? std::string() : ": " + what);
  }
  if (played.fault) return "the soft tissue's state became unusable under the blade; look at the tongue's mesh";
  if (played.limited) {
    std::snprintf(text, sizeof text,
                  "tongue or epiglottis still hide it when the lift has reached the %.1f N that the device gives (%.1f N "
                  "at most); a grown-up's tongue asks for more",
                  description.haptics.device_limit_n, played.peak_n);
    return text;
  }
  return "tongue or epiglottis still hide it when lifted; check the labels of the tongue, the epiglottis and the "
         "vallecula";
}

}  // namespace

std::vector<QualityItem> check_by_playing(PatientPackage& package, const std::function<void(double)>& progress) {
  curricula::Scenario scenario;
  engine::SceneDescription description;
  std::shared_ptr<const engine::Scene> scene;
  try {
    scenario.blade = blade_for(size_of(package));
    description = scene_from_package(package, scenario);
    scene = engine::build_scene(description);
  } catch (const std::exception& error) {
    return {
        {"check by playing", std::nullopt, "", false, kNotReady + "no scene can be built from it: " + error.what()}};
  }
  if (progress) progress(kSceneShare);
  const double past_anatomy = engine::LineOfSight(description.sight, description.soft.bodies).unobstructed();
  const auto planned = usual_approach(package);
  Played played;
  bool first = true;
  double tried = 0.0;
  for (const auto& [along, lift] : kApproaches) {
    auto candidate = package;
    candidate.approach = {planned.along_mm + along, planned.lift_mm + lift};
    const auto now = play(candidate, scene, scenario, [&](double f) {
      if (progress)
        progress(tried == 0.0 ? kSceneShare + (kFirstShare - kSceneShare) * std::min(1.0, f / kUsuallySeen)
                              : kFirstShare + (1.0 - kFirstShare) * (tried - 1.0 + f) / (kApproaches.size() - 1.0));
    });
    tried += 1.0;
    if (first || now.lifted > played.lifted) {
      played = now;
      package.approach = candidate.approach;
    }
    first = false;
    // Where bone or lips stand in the way, the mesh fails or the device gives up, another millimetre of the tip does
    // not help.
    if (played.lifted >= kSeenEnough || now.fault || past_anatomy < kSeenEnough) break;
    if (now.limited && now.lifted == 0.0) break;
  }
  const bool hidden = played.at_rest <= kHiddenAtRest;
  const bool seen = played.lifted >= kSeenEnough;
  char when[80];
  std::snprintf(when, sizeof when, "by the scripted expert with a %s blade, at %.1f s", scenario.blade.c_str(),
                played.time_s);
  const QualityItem at_rest{
      "glottis in sight at rest", 100.0 * played.at_rest, "%", hidden,
      hidden ? "hidden by tongue and epiglottis, as it should be" : "expected to be hidden before the lift"};
  const QualityItem lifted{"glottis in sight when lifted", 100.0 * played.lifted, "%", seen,
                           seen ? when : kNotReady + reason(package, description, scenario, played, past_anatomy)};
  if (seen) return {at_rest, lifted};
  return {lifted, at_rest};  // the verdict first
}

}  // namespace vallecula::gui

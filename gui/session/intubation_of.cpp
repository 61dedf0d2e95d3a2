#include "gui/session/intubation_of.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "gui/session/airway_course.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/package_parts.h"

namespace vallecula::gui {

namespace {

using curricula::InfantCourse;
using engine::Vec3;

constexpr double kFrench = 0.001 / 3;   // m
constexpr double kThroatArea = 250e-6;  // m2, term: what secretions spread over (assumed)
// Of the throat's floor, mm term: from the cords' level up, to either side of the middle.
constexpr double kFloorBelow = 2.0, kFloorAbove = 8.0, kFloorAside = 3.0;
constexpr double kMiddleOfLip = 5e-3;  // m term, to either side

engine::Course course_of(InfantCourse course) {
  switch (course) {
    case InfantCourse::premedicated_preterm:
      return engine::Course::premedicated_preterm;
    case InfantCourse::term:
      return engine::Course::term;
    case InfantCourse::preoxygenated:
      return engine::Course::preoxygenated;
    case InfantCourse::delivery_room:
      return engine::Course::delivery_room;
  }
  throw std::logic_error("a course that has no name");
}

/// Where fluid gathers in the throat of a child on its back: the hindmost of its wall about the larynx' inlet.
Vec3 throat_floor(const pipeline::PatientPackage& package, double size) {
  const pipeline::Point& glottis = package.landmarks.at("glottis_centre");
  Vec3 floor(glottis[0], glottis[1], glottis[2]);
  for (const pipeline::Point& p : package.surfaces.at("airway").points) {
    const double up = p[2] - glottis[2];
    if (up < -kFloorBelow * size || up > kFloorAbove * size || std::abs(p[0] - glottis[0]) > kFloorAside * size)
      continue;
    if (p[1] > floor.y()) floor = Vec3(p[0], p[1], p[2]);
  }
  return kMetres * floor;
}

/// Between the midlines of the gums, m.
double gap_between_gums(const pipeline::PatientPackage& package) {
  const pipeline::Point &upper = package.landmarks.at("upper_gum_midline"),
                        &lower = package.landmarks.at("lower_gum_midline");
  return kMetres * std::hypot(std::hypot(upper[0] - lower[0], upper[1] - lower[1]), upper[2] - lower[2]);
}

/// Points of the lips' surface, m; none: the package tells no lips.
std::vector<Vec3> lips_of(const pipeline::PatientPackage& package) {
  const pipeline::Surface& face = surface(package, "face");
  std::vector<Vec3> lips;
  for (std::size_t t = 0; t < std::min(face.tissue.size(), face.triangles.size()); ++t) {
    if (static_cast<pipeline::Tissue>(face.tissue[t]) != pipeline::Tissue::lip) continue;
    for (const int v : face.triangles[t]) {
      const pipeline::Point& p = face.points[static_cast<std::size_t>(v)];
      lips.push_back(kMetres * Vec3(p[0], p[1], p[2]));
    }
  }
  return lips;
}

/// What the lips tell about the mouth: how far they reach to the side, and how far the upper one, at which a tube's
/// mark is read, stands before the gums in its middle.
void set_lips(const std::vector<Vec3>& lips, const Vec3& upwards, double size, engine::IntubationDescription& d) {
  double half_width = 0.0;
  for (const Vec3& p : lips) {
    const double aside = std::abs(p.x() - d.mouth.x());
    half_width = std::max(half_width, aside);
    if (aside < kMiddleOfLip * size && upwards.dot(p - d.mouth) > 0.0)
      d.lips_before_gums_m = std::max(d.lips_before_gums_m, -d.mouth_inward.dot(p - d.mouth));
  }
  d.mouth_half_width_m = static_cast<float>(half_width);
}

void set_mouth(const pipeline::PatientPackage& package, engine::IntubationDescription& d) {
  const auto mouth = mouth_of(package);
  if (!mouth)
    throw std::runtime_error("patient '" + package.name + "': its gums and vallecula span no mouth; import it again");
  d.mouth = Vec3(mouth->gum_middle_m[0], mouth->gum_middle_m[1], mouth->gum_middle_m[2]);
  d.mouth_inward = Vec3(mouth->inward[0], mouth->inward[1], mouth->inward[2]);
  d.mouth_axis = Vec3(mouth->axis[0], mouth->axis[1], mouth->axis[2]);
  d.mouth_radius_m = mouth->radius_m;
  const pipeline::Point &upper = package.landmarks.at("upper_gum_midline"),
                        &lower = package.landmarks.at("lower_gum_midline");
  set_lips(lips_of(package), Vec3(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]), size_of(package), d);
  d.mouth_gap_m = gap_between_gums(package);
  if (d.tube.outer_diameter < d.mouth_gap_m) return;
  char text[256];
  std::snprintf(text, sizeof text,
                "': a tube of %.1f mm outside does not go between its gums, which are %.1f mm apart; choose a patient "
                "whose mouth is open, or a scenario with a smaller tube",
                1e3 * d.tube.outer_diameter, 1e3 * d.mouth_gap_m);
  throw std::runtime_error("patient '" + package.name + text);
}

}  // namespace

engine::IntubationDescription intubation_of(const pipeline::PatientPackage& package,
                                            const curricula::Scenario& scenario) {
  const curricula::IntubationSpec& spec = scenario.intubation.value();
  PatientAirway airway = airway_of(package);
  const double size = size_of(package);
  engine::IntubationDescription d;
  d.tube = engine::tube_design(spec.tube);
  if (spec.stylet) {
    d.stylet.emplace();
    d.stylet->diameter = kMetres * spec.stylet_mm;
  }
  d.catheter_outer_m = kFrench * spec.catheter_f;
  d.course = std::move(airway.course);
  d.glottis.length_m = airway.glottis_length_m;
  d.glottis.relaxed = spec.premedicated;
  d.glottis.closure_s = spec.cord_closure_s;
  d.glottis.spasm_s = spec.laryngospasm_s;
  d.glottis.spasm_from_start = spec.laryngospasm_from_start;
  d.glottis.seed = spec.infant_seed;
  d.infant.course = course_of(spec.course);
  d.infant.weight_kg = scenario.manikin.weight_kg;
  d.infant.gestation_weeks = spec.gestation_weeks;
  d.infant.premedicated = spec.premedicated;
  d.infant.added_oxygen = spec.added_oxygen_percent / 100.0;
  d.infant.seed = spec.infant_seed;
  d.breathes = spec.breathes;
  d.secretions.volume_m3 = 1e-6 * spec.secretions_ml;
  d.secretions.area_m2 = kThroatArea * size * size;
  d.secretions.floor = throat_floor(package, size);
  d.press_n = spec.laryngeal_pressure_n;
  set_mouth(package, d);
  return d;
}

}  // namespace vallecula::gui

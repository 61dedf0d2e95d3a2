// What the tube's contacts press with, once its step has found their forces.
#include <cmath>

#include "engine/tube/passage.h"

namespace vallecula::engine {

namespace {

bool of_glottis(std::uint8_t load) {
  return load == static_cast<std::uint8_t>(AirwayPart::vestibule) ||
         load == static_cast<std::uint8_t>(AirwayPart::cords);
}

}  // namespace

PassageLoads read_loads(const RigidField* rigid, const RodState& tube, const Vec3& blade_tip,
                        const TubeContacts& contacts) noexcept {
  PassageLoads loads;
  std::array<double, kTubeLoads> before_tip{};
  const Vec3 backwards = tube.rotation[0] * Vec3::UnitX();
  for (int n = 0; n < contacts.count; ++n) {
    const RodContact& c = contacts.contact[static_cast<std::size_t>(n)];
    const ContactTag& tag = contacts.tag[static_cast<std::size_t>(n)];
    if (c.force.isZero(0) || tag.load == kLoadOfNothing) continue;
    const double force = c.force.norm(), push = c.force.dot(c.normal);
    loads.loads_n[tag.load] += force;
    if (tag.before_tip) before_tip[tag.load] += push * c.normal.dot(backwards);
    if (tag.larynx_share > 0) {
      loads.on_larynx -= tag.larynx_share * c.force;
      loads.on_larynx_stiffness +=
          tag.larynx_share * tag.larynx_share * c.stiffness_n_m * c.normal * c.normal.transpose();
    }
    if (tag.load == kLoadBlade) {
      const Vec3 arm = tag.at - blade_tip;
      loads.on_blade.force -= c.force;
      loads.on_blade.torque -= arm.cross(c.force);
      Vec6 direction;
      direction << c.normal, arm.cross(c.normal);
      loads.on_blade_stiffness += c.stiffness_n_m * direction * direction.transpose();
    }
    if (tag.part >= 0 && rigid) {
      const std::size_t part = static_cast<std::size_t>(tag.part);
      loads.on_part[part] -= force * rigid->lever(tag.part, tag.at, c.force / force);
      loads.on_part_stiffness[part] += c.stiffness_n_m * rigid->lever(tag.part, tag.at, c.normal).squaredNorm();
    }
  }
  double most = 0.0;
  for (std::uint8_t of = 0; of < kTubeLoads; ++of) {
    loads.tip_load_n += std::max(0.0, before_tip[of]);
    if (of_glottis(of) || of == kLoadEpiglottis) loads.vagal_n += loads.loads_n[of];
    if (of_glottis(of)) loads.glottis_n += loads.loads_n[of];
    if (before_tip[of] > most) {
      most = before_tip[of];
      loads.tip_against = of;
    }
  }
  return loads;
}

void write_loads(const PassageLoads& loads, IntubationRecord& record) noexcept {
  record.loads_n = loads.loads_n;
  record.tip_load_n = loads.tip_load_n;
  record.tip_against = loads.tip_against;
}

}  // namespace vallecula::engine

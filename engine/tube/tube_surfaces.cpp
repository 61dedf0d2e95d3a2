#include "engine/tube/tube_surfaces.h"

#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

/// Springs of a surface per length of tube, N/m per m; the second begins after `give` m. All assumed.
struct Surface {
  double soft, give, hard;
};
constexpr Surface kBone{3e6, 1e-3, 3e7};      // gum, palate, teeth
constexpr Surface kLarynx{8e5, 1.5e-3, 1e7};  // the larynx from above: arytenoids, folds
constexpr Surface kMucosa{4e5, 2e-3, 1e7};    // cheek, pharynx, what else there is
constexpr Surface kLip{8e4, 4e-3, 5e6};       // at and before the mouth's front
constexpr Surface kSkin{4e5, 2e-3, 1e7};      // face and neck: as a cheek from within
constexpr Surface kBlade{5e6, 1.0, 0.0};      // metal: what gives is the tube's wall
constexpr double kLipDepth = 4e-3;            // m behind the mouth's front

constexpr double kNear = 3e-4;         // m: contacts are given from here on, besides what a point does in a tick
constexpr double kFineFrom = 1e-3;     // m: nearer to the blade its fine field is asked
constexpr double kCoarseError = 1e-3;  // m, of the coarse one near edges

const Surface& surface_of(Structure s, bool at_lips) {
  switch (s) {
    case Structure::gum:
    case Structure::palate:
    case Structure::teeth:
      return kBone;
    case Structure::larynx:
      return kLarynx;
    case Structure::tongue:
    case Structure::epiglottis:
    case Structure::other:
      break;
  }
  return at_lips ? kLip : kMucosa;
}

std::uint8_t load_of(Structure s) {
  switch (s) {
    case Structure::larynx:
      return static_cast<std::uint8_t>(AirwayPart::vestibule);
    case Structure::tongue:
      return kLoadTongue;
    case Structure::epiglottis:
      return kLoadEpiglottis;
    case Structure::gum:
    case Structure::palate:
    case Structure::teeth:
    case Structure::other:
      break;
  }
  return kLoadPharynx;
}

/// A ball along the tube.
struct Sample {
  RodContact contact;  ///< its node and weight
  double from_tip_m, radius_m, reach_m;
  Vec3 point, velocity;
};

void add(const Sample& s, double distance, const Vec3& normal, const Surface& surface, double length,
         const ContactTag& tag, TubeContacts& contacts) {
  for (int stage = 0; stage < 2; ++stage) {
    RodContact c = s.contact;
    c.normal = normal;
    c.depth_m = s.radius_m - distance - (stage == 0 ? 0.0 : surface.give);
    c.stiffness_n_m = length * (stage == 0 ? surface.soft : surface.hard);
    if (s.radius_m - c.depth_m > s.reach_m || !(c.stiffness_n_m > 0)) return;
    contacts.add(c, tag);
  }
}

class Surfaces {
 public:
  Surfaces(const Passage& passage, const TubeOutside& outside, const PassageInput& input, double length,
           TubeContacts& contacts)
      : passage_(passage), outside_(outside), input_(input), length_(length), contacts_(contacts) {}

  /// Returns how far the sample is from all of it at least.
  double meet_anatomy(const Sample& s) const {
    if (!input_.rigid) return 1.0;
    const bool lips = passage_.mouth_inward().dot(s.point - passage_.mouth()) < kLipDepth;
    return input_.rigid->look(
        s.point, *input_.parts, s.reach_m,
        [&](const RigidField::Touch& touch) {
          if (touch.normal.squaredNorm() < 0.5) return;
          Sample at = s;
          at.contact.surface_velocity =
              touch.part < 0 ? Vec3(Vec3::Zero())
                             : (*input_.parts)[static_cast<std::size_t>(touch.part)].velocity_at(touch.rest);
          ContactTag tag;
          tag.load = load_of(touch.structure);
          tag.before_tip = outside_.before_tip(s.from_tip_m, length_);
          tag.part = static_cast<std::int8_t>(touch.part);
          tag.at = touch.rest;
          add(at, touch.distance, touch.normal.normalized(), surface_of(touch.structure, lips), length_, tag,
              contacts_);
        },
        [](int, double) {});
  }

  /// Returns how far the sample is from the skin at least.
  double meet_skin(const Sample& s, float& met) const {
    if (!input_.skin) return 1.0;
    const SignedDistanceGrid::Sample skin = input_.skin->sample(s.point);
    if (skin.distance < -SkinField::kDeepest) {
      met = PassageState::kNotMet;
      return 0.0;
    }
    const float depth = static_cast<float>(s.radius_m - skin.distance);
    met = std::max(0.0f, std::min(met, depth));
    if (input_.rigid && input_.rigid->covers(s.point)) {
      // The anatomy's own field meets it. What is pressed in there and comes out over the box' border is no blow.
      met = std::max(met, depth - static_cast<float>(kSkin.give));
      return skin.distance;
    }
    if (!(skin.distance < s.reach_m) || skin.gradient.squaredNorm() < 0.5) return skin.distance;
    ContactTag tag;
    tag.load = kLoadOfNothing;
    add(s, skin.distance + met, skin.gradient, kSkin, length_, tag, contacts_);
    return skin.distance;
  }

  double meet_blade(const Sample& s) const {
    if (!input_.blade) return 1.0;
    const ToolField& blade = *input_.blade;
    const Vec3 local = input_.blade_pose.to_local(s.point);
    const SignedDistanceGrid::Sample coarse = blade.coarse.sample(local);
    if (coarse.distance > s.reach_m + kCoarseError) return coarse.distance - kCoarseError;
    // The tube's radius is more than the fine field's band: it is asked from a point nearer to the surface.
    const Vec3 foot = local - std::max(0.0, coarse.distance - kFineFrom) * coarse.gradient;
    const SignedDistanceGrid::Sample fine = blade.fine.sample(foot);
    double distance = coarse.distance;
    Vec3 normal = coarse.gradient;
    if (std::abs(fine.distance) < blade.fine.band() && fine.gradient.squaredNorm() > 0.5) {
      const Vec3 way = local - (foot - fine.distance * fine.gradient.normalized());
      const double outside = way.dot(fine.gradient) < 0 ? -1.0 : 1.0;
      distance = outside * way.norm();
      normal = way.norm() > 1e-6 ? Vec3(outside * way) : fine.gradient;
    }
    if (normal.squaredNorm() < 1e-14) return 0.0;
    normal = input_.blade_pose.rotation * normal.normalized();
    Sample at = s;
    ContactTag tag;
    tag.load = kLoadBlade;
    tag.before_tip = outside_.before_tip(s.from_tip_m, length_);
    tag.at = s.point - distance * normal;
    at.contact.surface_velocity = input_.blade_velocity + input_.blade_spin.cross(tag.at - input_.blade_pose.position);
    add(at, distance, normal, kBlade, length_, tag, contacts_);
    return distance;
  }

 private:
  const Passage& passage_;
  const TubeOutside& outside_;
  const PassageInput& input_;
  double length_;
  TubeContacts& contacts_;
};

}  // namespace

void add_surface_contacts(const Passage& passage, PassageState& state, const TubeOutside& outside, const Rod& rod,
                          const RodState& tube, const PassageInput& input, double dt, TubeContacts& contacts) noexcept {
  const double step = rod.segment_m() / 2;
  const Surfaces surfaces(passage, outside, input, step, contacts);
  // m along the tube: nearer the tip it cannot touch. The skin has its own, or the mouth's contacts would depend on it.
  double anatomy_from = 0.0, skin_from = 0.0, blade_from = 0.0;
  for (int n = 0; n < std::min(2 * state.inside, kTubeBalls); ++n) state.met_by_skin[n] = PassageState::kNotMet;
  for (int n = 2 * state.inside; n < kTubeBalls; ++n) {
    const double s = n * step;
    if (s < skin_from) state.met_by_skin[n] = 0.0f;
    if (s < anatomy_from && s < skin_from && s < blade_from) continue;
    Sample sample;
    const int node = std::min(n / 2, kTubeSegments - 1);
    const std::size_t i = static_cast<std::size_t>(node);
    sample.contact.node = node;
    sample.contact.weight = n / 2.0 - node;
    sample.contact.friction = input.friction;
    const TubeOutside::Ball ball = outside.ball(s);
    const double w = sample.contact.weight;
    sample.from_tip_m = s;
    sample.radius_m = ball.radius_m;
    sample.point = (1 - w) * tube.position[i] + w * tube.position[i + 1] +
                   ball.aside_m * (tube.rotation[i] * outside.point_side());
    sample.velocity = (1 - w) * tube.velocity[i] + w * tube.velocity[i + 1];
    const double near = kNear + sample.velocity.norm() * dt;
    sample.reach_m = ball.radius_m + near;
    const double reach = outside.radius() + near;
    if (s >= anatomy_from) anatomy_from = s + surfaces.meet_anatomy(sample) - reach;
    if (s >= skin_from) skin_from = s + surfaces.meet_skin(sample, state.met_by_skin[n]) - reach;
    if (s >= blade_from) blade_from = s + surfaces.meet_blade(sample) - reach;
  }
}

}  // namespace vallecula::engine

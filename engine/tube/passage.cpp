#include "engine/tube/passage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/tube/airway_walls.h"
#include "engine/tube/canals.h"
#include "engine/tube/tube_surfaces.h"

namespace vallecula::engine {

namespace {

constexpr double kLeastSpacing = 0.0005, kMostSpacing = 0.004;
constexpr std::size_t kMostRings = 400;
constexpr double kMostBranch = 0.010;          // m, from the carina to a bronchus' first ring: it begins aside
constexpr double kCordsHalfThickness = 0.001;  // m (assumed)
constexpr double kRim = 0.002;                 // m, of the fold about an entrance (assumed)

[[noreturn]] void fault(const std::string& what) { throw std::invalid_argument("airway: " + what); }

std::string mm(double m) { return std::to_string(1e3 * m) + " mm"; }

void check_ring(const AirwayRing& r, const std::string& name) {
  if (!r.centre.allFinite()) fault("the centre of " + name + " is not finite");
  for (const Vec3* axis : {&r.along, &r.left})
    if (!(std::abs(axis->norm() - 1) < 1e-3))
      fault("an axis of " + name + " has a length of " + std::to_string(axis->norm()) + "; it must be 1");
  if (!(std::abs(r.along.dot(r.left)) < 0.01))
    fault("the axes of " + name + " are not at right angles: their product is " + std::to_string(r.along.dot(r.left)));
  for (double width : {r.to_left_m, r.to_right_m, r.to_front_m, r.to_back_m})
    if (!(width > 0) || !(width < 0.05))
      fault("a half width of " + name + " is " + mm(width) + "; it must be above 0 and below 50 mm");
  if (!(r.larynx_share >= 0 && r.larynx_share <= 1))
    fault(name + " follows the larynx by a share of " + std::to_string(r.larynx_share) + "; 0 to 1 is possible");
}

void check_way(const AirwayRing& before, const AirwayRing& after, double most, const std::string& name) {
  const Vec3 way = after.centre - before.centre;
  constexpr double kRounding = 1e-6;  // m
  if (!(way.norm() >= kLeastSpacing - kRounding && way.norm() <= most + kRounding))
    fault(name + " lies " + mm(way.norm()) + " from the one before it; " + mm(kLeastSpacing) + " to " + mm(most) +
          " are possible");
  if (!(way.dot(before.along) > 0) || !(way.dot(after.along) > 0))
    fault(name + " does not lie beyond the one before it");
}

std::string ring_name(const char* chain, std::size_t n) { return std::string(chain) + "'s ring " + std::to_string(n); }

void check_chain(const std::vector<AirwayRing>& rings, const char* name) {
  if (rings.size() > kMostRings)
    fault(std::string(name) + " has " + std::to_string(rings.size()) + " rings; at most " + std::to_string(kMostRings) +
          " work");
  if (rings.size() < 2)
    fault(std::string(name) + " has " + std::to_string(rings.size()) + " rings; it needs two at least");
  for (std::size_t n = 0; n < rings.size(); ++n) {
    check_ring(rings[n], ring_name(name, n));
    if (n > 0) check_way(rings[n - 1], rings[n], kMostSpacing, ring_name(name, n));
  }
}

void check(const AirwayCourse& c) {
  constexpr const char* kBronchus[2] = {"the right main bronchus", "the left main bronchus"};
  check_chain(c.airway, "the airway");
  check_chain(c.oesophagus, "the oesophagus");
  int cords = 0, trachea = 0;
  for (std::size_t n = 0; n < c.airway.size(); ++n) {
    const AirwayPart part = c.airway[n].part;
    cords += part == AirwayPart::cords;
    trachea += part == AirwayPart::trachea;
    if (part > AirwayPart::trachea || (n > 0 && part < c.airway[n - 1].part))
      fault("the part of " + ring_name("the airway", n) +
            " is out of order: from the inlet to the carina there are "
            "vestibule, cords, subglottis, cricoid, trachea");
  }
  if (cords != 1) fault("it has " + std::to_string(cords) + " rings at the cords; it needs one");
  if (trachea < 1) fault("it has no ring in the trachea");
  if (c.airway.front().part == AirwayPart::trachea) fault("it begins in the trachea");
  for (int side = 0; side < 2; ++side) {
    const auto& rings = c.bronchi[static_cast<std::size_t>(side)];
    check_chain(rings, kBronchus[side]);
    check_way(c.airway.back(), rings.front(), kMostBranch, ring_name(kBronchus[side], 0));
    for (const AirwayRing& r : rings)
      if (r.part != AirwayPart::main_bronchus) fault(std::string(kBronchus[side]) + " has a ring of another part");
  }
  for (const AirwayRing& r : c.oesophagus)
    if (r.part != AirwayPart::oesophagus) fault("the oesophagus has a ring of another part");
}

Passage::Chain made_chain(const std::vector<AirwayRing>& first, const std::vector<AirwayRing>& then) {
  Passage::Chain all;
  for (const auto* rings : {&first, &then})
    for (const AirwayRing& cut : *rings) {
      Passage::Ring r;
      r.cut = cut;
      r.cut.along.normalize();
      r.cut.left = (cut.left - cut.left.dot(r.cut.along) * r.cut.along).normalized();
      r.front = r.cut.along.cross(r.cut.left);
      if (!all.empty()) {
        const double way = (cut.centre - all.back().cut.centre).norm();
        r.from_start_m = all.back().from_start_m + way;
        all.back().after_m = r.before_m = way / 2;
      }
      all.push_back(r);
    }
  all.front().before_m = kRim;
  for (Passage::Ring& r : all)
    if (r.cut.part == AirwayPart::cords) r.before_m = r.after_m = kCordsHalfThickness;
  return all;
}

/// m along a chain from its first ring to the tip, which may have gone on since it had passed that ring.
double along_chain(const Passage::Chain& chain, int passed, const Vec3& tip, const Vec3& larynx_way) {
  passed = std::max(0, last_passed(tip, chain, static_cast<int>(chain.size()), larynx_way, passed));
  const Passage::Ring& r = chain[static_cast<std::size_t>(passed)];
  const double here = std::max(0.0, r.beyond(tip, larynx_way));
  if (passed + 1 == static_cast<int>(chain.size())) return r.from_start_m + here;
  const Passage::Ring& next = chain[static_cast<std::size_t>(passed) + 1];
  const double there = next.beyond(tip, larynx_way);
  const double share = std::min(1.0, here / std::max(here - there, 1e-9));
  return r.from_start_m + share * (next.from_start_m - r.from_start_m);
}

}  // namespace

TubeOutside::TubeOutside(const TubeDesign& d) noexcept
    : radius_(d.outer_diameter / 2),
      bevel_length_(0.0),
      steepness_(std::tan(d.bevel_rad)),
      rounding_((d.outer_diameter - d.inner_diameter) / 4),  // the rim is as round as the wall is thick
      point_side_(-d.bevel_faces.normalized()) {
  if (d.bevel_rad > 0.05 && d.bevel_rad < 1.5) bevel_length_ = d.outer_diameter / steepness_;
}

TubeOutside::Reach TubeOutside::reach(const Vec3& u, double s) const noexcept {
  constexpr double kSteepest = 3.0;  // a chord's ends part infinitely fast at the very point
  Reach reach{radius_, 0.0};
  if (s < bevel_length_) {
    // Disc with what lies short of the chord `towards` cut off: where u's own point of the rim is gone, a corner
    // reaches farthest.
    const double along = u.dot(point_side_), towards = radius_ - std::max(0.0, s) * steepness_;
    if (radius_ * along < towards) {
      const double across = std::sqrt(std::max(0.0, 1 - along * along - u.x() * u.x()));
      const double half = std::sqrt(std::max(0.0, radius_ * radius_ - towards * towards));
      reach.m = towards * along + half * across;
      reach.slope = half > 0 ? steepness_ * (towards / half * across - along) : kSteepest;
      reach.slope = std::min(reach.slope, kSteepest);
    }
  }
  const double round = 2 * rounding_;  // m behind the tip
  if (s < round) {
    const double left = 1 - std::max(0.0, s) / round;
    reach.m -= rounding_ * left * left;
    reach.slope += left;
  }
  return reach;
}

TubeOutside::Ball TubeOutside::ball(double s) const noexcept {
  const double least = std::max(rounding_, 1e-4);
  double radius = s < bevel_length_ ? std::max(least, s * steepness_ / 2) : radius_;
  // Cut square it is round at its end; the ball must not stand out before it.
  if (bevel_length_ == 0 && s < radius_) radius = std::max(least, s);
  radius = std::min(radius, radius_);
  return {bevel_length_ > 0 ? radius_ - radius : 0.0, radius};
}

Passage::Passage(const AirwayCourse& course, const Glottis& glottis, const Vec3& mouth, const Vec3& mouth_inward,
                 const Vec3& mouth_axis, double mouth_radius_m, double mouth_half_width_m)
    : larynx_body_(course.larynx_body),
      glottis_(checked(glottis)),
      mouth_(mouth),
      mouth_inward_(mouth_inward),
      mouth_axis_(mouth_axis),
      mouth_radius_m_(mouth_radius_m),
      mouth_half_width_m_(mouth_half_width_m) {
  check(course);
  if (!mouth.allFinite() || !(std::abs(mouth_inward.norm() - 1) < 1e-3))
    fault("the mouth's front plane needs a point and a unit normal; the normal's length is " +
          std::to_string(mouth_inward.norm()));
  if (!(mouth_radius_m >= 0) || !std::isfinite(mouth_radius_m))
    fault("the mouth's radius is " + mm(mouth_radius_m) + "; it must be above 0, or 0 for a mouth without bound");
  if (!(std::abs(mouth_axis.norm() - 1) < 1e-3))
    fault("the mouth's axis has a length of " + std::to_string(mouth_axis.norm()) + "; it must be 1");
  mouth_inward_.normalize();
  mouth_axis_.normalize();
  for (int side = 0; side < 2; ++side)
    airway_[static_cast<std::size_t>(side)] = made_chain(course.airway, course.bronchi[static_cast<std::size_t>(side)]);
  oesophagus_ = made_chain(course.oesophagus, {});
  carina_ = static_cast<int>(course.airway.size()) - 1;
  for (int n = carina_; n >= 0; --n) {
    const AirwayPart part = course.airway[static_cast<std::size_t>(n)].part;
    if (part == AirwayPart::trachea) trachea_ = n - 1;
    if (part == AirwayPart::cords) cords_ = n;
  }
}

double Passage::cords_to_carina_m() const noexcept {
  return airway_[0][static_cast<std::size_t>(carina_)].from_start_m -
         airway_[0][static_cast<std::size_t>(cords_)].from_start_m;
}

void PassageState::set_rest() noexcept {
  canal = Canal::none;
  inside = 0;
  side = -1;
  passed.fill(-1);
  met_by_skin.fill(kNotMet);
}

void TubeContacts::add(const RodContact& c, const ContactTag& t) noexcept {
  if (count == kMostTubeContacts) {
    ++left_out;
    return;
  }
  contact[static_cast<std::size_t>(count)] = c;
  tag[static_cast<std::size_t>(count++)] = t;
}

std::uint32_t find_contacts(const Passage& passage, PassageState& state, const TubeOutside& outside, const Rod& rod,
                            const RodState& tube, const PassageInput& given, double dt_s,
                            TubeContacts& contacts) noexcept {
  contacts.clear();
  std::uint32_t faults = kPassageFaultNone;
  double sum = 0.0;
  for (const Vec3& x : tube.position) sum += x.sum();
  for (const Vec3& v : tube.velocity) sum += v.sum();
  for (const Quat& q : tube.rotation) sum += q.coeffs().sum();
  if (!std::isfinite(sum)) {
    state.set_rest();
    return kPassageFaultTube;
  }
  PassageInput input = given;
  if (!input.larynx_way.allFinite() || !input.larynx_velocity.allFinite() || !std::isfinite(input.glottis_opening)) {
    input.larynx_way = input.larynx_velocity = Vec3::Zero();
    input.glottis_opening = 1.0;
    faults |= kPassageFaultLarynx;
  }
  if (input.blade &&
      (!usable(input.blade_pose) || !input.blade_velocity.allFinite() || !input.blade_spin.allFinite())) {
    input.blade = nullptr;
    faults |= kPassageFaultBlade;
  }
  if (!(input.friction >= 0 && input.friction <= 2)) input.friction = PassageInput().friction;
  const double dt = dt_s >= 0 ? std::min(dt_s, 0.01) : 0.0;
  follow_canals(passage, input.larynx_way, outside, tube, dt, state);
  add_wall_contacts(passage, state, outside, rod, tube, input, dt, contacts);
  add_surface_contacts(passage, state, outside, rod, tube, input, dt, contacts);
  if (contacts.left_out > 0) faults |= kPassageFaultFull;
  return faults;
}

double inside_canal_m(const Passage& passage, const PassageState& state, const Rod& rod, const RodState& tube,
                      const Vec3& larynx_way) noexcept {
  if (state.inside == 0) return 0.0;
  const Passage::Ring& first = passage.chain(state.canal, state.side).front();
  const auto beyond = [&](int node) { return first.beyond(tube.position[static_cast<std::size_t>(node)], larynx_way); };
  int out = state.inside;  // what has come in or gone out since then is taken along
  while (out > 0 && beyond(out - 1) < 0) --out;
  while (out < kTubeNodes && beyond(out) >= 0) ++out;
  if (out == 0) return 0.0;
  if (out == kTubeNodes) return rod.description().length_m;
  const double in_m = beyond(out - 1), out_m = -beyond(out);
  return rod.segment_m() * (out - 1 + in_m / (in_m + out_m));
}

bool came_by_mouth(const Passage& passage, const RodState& tube) noexcept {
  const auto within = [&](int node) {
    return passage.mouth_inward().dot(tube.position[static_cast<std::size_t>(node)] - passage.mouth());
  };
  double before = within(0);
  if (!(before > 0)) return true;
  for (int i = 1; i < kTubeNodes; ++i) {
    const double here = within(i);
    if (here <= 0) {
      const std::size_t node = static_cast<std::size_t>(i);
      const double share = before / (before - here);
      return passage.between_corners((1 - share) * tube.position[node - 1] + share * tube.position[node]);
    }
    before = here;
  }
  return true;
}

TipPlace place(const Passage& passage, const PassageState& state, const RodState& tube) noexcept {
  if (state.inside == 0)
    return passage.mouth_holds(tube.position[0]) && came_by_mouth(passage, tube) ? TipPlace::mouth : TipPlace::outside;
  if (state.canal == Canal::oesophagus) return TipPlace::oesophagus;
  if (state.passed[0] >= passage.carina()) return TipPlace::main_bronchus;
  return state.passed[0] >= passage.trachea() ? TipPlace::trachea : TipPlace::larynx;
}

double past_cords_m(const Passage& passage, const PassageState& state, const RodState& tube,
                    const Vec3& larynx_way) noexcept {
  const double cords = passage.airway(0)[static_cast<std::size_t>(passage.cords())].from_start_m;
  if (state.inside == 0) return -cords;
  const Passage::Chain& chain = passage.chain(state.canal, state.side);
  const double way = along_chain(chain, state.passed[0], tube.position[0], larynx_way);
  return state.canal == Canal::oesophagus ? way : way - cords;
}

double at_mouth_m(const Passage& passage, const Rod& rod, const RodState& tube, double lips_m) noexcept {
  const auto within = [&](int node) {
    return passage.mouth_inward().dot(tube.position[static_cast<std::size_t>(node)] - passage.mouth()) + lips_m;
  };
  double before = within(0);
  if (!(before > 0)) return 0.0;
  for (int i = 1; i < kTubeNodes; ++i) {
    const double here = within(i);
    if (here <= 0) return rod.segment_m() * (i - 1 + before / (before - here));
    before = here;
  }
  return rod.description().length_m;
}

}  // namespace vallecula::engine

#include "engine/tube/airway_walls.h"

#include <algorithm>
#include <cmath>

namespace vallecula::engine {

namespace {

using Ring = Passage::Ring;
using Chain = Passage::Chain;

/// Springs of a wall per length of canal, N/m per m; the second begins after `give` m. All assumed, and set so that the
/// tubes of CLINICAL's table pass a cricoid of 5.0 mm, or do not, at pushes a hand makes.
struct Wall {
  double soft, give, hard;
};
constexpr Wall kVestibule{4e5, 1.5e-3, 3e7};
constexpr Wall kCommissure{1e6, 5e-4, 3e7};   // the cords' front, and the arytenoids behind
constexpr Wall kCricoid{1.5e6, 3e-4, 1.5e8};  // and the subglottis within it: a closed ring of cartilage
constexpr Wall kTrachea{3e5, 3e-4, 3e7};      // horseshoes, and between them membrane
constexpr Wall kMembrane{1.5e5, 1e-3, 3e7};   // the trachea's back
constexpr Wall kOesophagus{4e3, 5e-3, 1e6};   // presses with about 4 kPa on a 3.5 tube

// The cords, per side: a soft edge, and muscles that hold them shut. Once parted by the tube's full width they are held
// apart against the muscles' tone alone.
constexpr double kSlackCord = 100.0, kShutCord = 3000.0, kPartedCord = 300.0;  // N/m
constexpr double kCordsThickness = 2e-3;                                       // m, of Ring::before_m and after_m
constexpr double kCordGive = 3e-3, kBesideCords = 2e4;                         // m, N/m: then cartilage
constexpr double kShutBelow = 0.4;  // of the opening: no breath narrows them to this, muscles do

constexpr double kNear = 3e-4;          // m: contacts are given from here on, besides what a point does in a tick
constexpr double kLeastAlong = 0.3;     // cosine of the tilt to which a ring's edge is reckoned with
constexpr double kMostStiffness = 1e6;  // N/m, RodContact's bound

constexpr int kDirections = 8;
constexpr double kDiagonal = 0.70710678118654752440;
constexpr double kLeftward[kDirections] = {1, kDiagonal, 0, -kDiagonal, -1, -kDiagonal, 0, kDiagonal};
constexpr double kFrontward[kDirections] = {0, kDiagonal, 1, kDiagonal, 0, -kDiagonal, -1, -kDiagonal};

/// The outline's farthest point in a direction: four quarters of ellipses.
double reach_of(const AirwayRing& r, int direction) {
  const double x = kLeftward[direction] * (kLeftward[direction] > 0 ? r.to_left_m : r.to_right_m);
  const double y = kFrontward[direction] * (kFrontward[direction] > 0 ? r.to_front_m : r.to_back_m);
  return std::sqrt(x * x + y * y);
}

/// Where the tube's axis meets a wall.
struct At {
  int node;
  double weight;
  double from_tip_m;
  Vec3 point;
  Vec3 towards;  ///< the tip, unit
  double near;   ///< m
};

/// What a wall there is: unit direction outwards, how far the tube is pressed into it, and how that changes as the
/// axis' point moves.
struct Press {
  Vec3 outward;
  double depth;
  Vec3 gradient;
  Wall spring;  ///< N/m, m, N/m
};

class Walls {
 public:
  Walls(const Passage& passage, const PassageState& state, const TubeOutside& outside, const Rod& rod,
        const RodState& tube, const PassageInput& input, double dt, TubeContacts& contacts)
      : passage_(passage),
        chain_(passage.chain(state.canal, state.side)),
        state_(state),
        outside_(outside),
        rod_(rod),
        tube_(tube),
        input_(input),
        dt_(dt),
        contacts_(contacts) {}

  void add_all() {
    const int tip_ring = state_.passed[0];
    const bool last = tip_ring + 1 == static_cast<int>(chain_.size());
    const double share = last ? 1.0 : share_of_interval(tip_ring);
    for (int i = 0; i + 1 < kTubeNodes && i < state_.inside; ++i) {
      const int here = state_.passed[i], after = i + 1 < state_.inside ? state_.passed[i + 1] : -1;
      for (int k = std::min(here, after) + 1; k <= std::max(here, after); ++k)
        add_ring(k, i, k == tip_ring ? share : 1.0);
    }
    if (last)
      add_end();
    else
      add_tip(tip_ring, share);
  }

 private:
  const Ring& ring(int k) const { return chain_[static_cast<std::size_t>(k)]; }
  Vec3 centre(int k) const { return ring(k).centre(input_.larynx_way); }
  double beyond(int k, int node) const {
    return ring(k).beyond(tube_.position[static_cast<std::size_t>(node)], input_.larynx_way);
  }

  double share_of_interval(int k) const {
    const double here = beyond(k, 0), there = beyond(k + 1, 0);
    return std::clamp(here / std::max(here - there, 1e-9), 0.0, 1.0);
  }

  At at(int node, double weight) const {
    const std::size_t i = static_cast<std::size_t>(node);
    const Vec3 way = tube_.position[i] - tube_.position[i + 1];
    const double speed = std::max(tube_.velocity[i].norm(), tube_.velocity[i + 1].norm());
    return {node,
            weight,
            (node + weight) * rod_.segment_m(),
            tube_.position[i] - weight * way,
            way / std::max(way.norm(), 1e-9),
            kNear + speed * dt_};
  }

  TubeOutside::Reach reach(const At& a, const Vec3& u) const {
    if (a.from_tip_m >= outside_.end_length()) return {outside_.radius(), 0.0};
    return outside_.reach(tube_.rotation[static_cast<std::size_t>(a.node)].conjugate() * u, a.from_tip_m);
  }

  /// Where on the way from front to back of the gap the tube's middle is: the cords' half width there, and by how much
  /// it grows to the front (it narrows: below 0).
  struct Gap {
    double half_m, slope;
  };
  Gap gap(const Ring& r, double frontward) const {
    const Glottis& g = passage_.glottis();
    const double scale = g.length_m / (r.cut.to_front_m + r.cut.to_back_m);
    const double behind = std::clamp((r.cut.to_front_m - frontward) * scale, 0.0, g.length_m);
    const bool narrowing = behind < g.front_share * g.length_m;
    return {half_width(g, input_.glottis_opening, behind),
            narrowing ? -input_.glottis_opening * g.widest_half_slope * scale : 0.0};
  }

  /// Of the cords' sides, per length of canal: for a tube that parts them, or has.
  Wall cord(double from_tip_m) const {
    const double shut = std::clamp(1 - input_.glottis_opening / kShutBelow, 0.0, 1.0);
    const double parting = std::clamp(3 - 2 * from_tip_m / outside_.end_length(), 0.0, 1.0);
    const double held = kPartedCord + parting * (kShutCord - kPartedCord);
    return {(kSlackCord + shut * (held - kSlackCord)) / kCordsThickness, kCordGive, kBesideCords / kCordsThickness};
  }

  Wall wall(const Ring& r, int direction, double from_tip_m) const {
    const bool back = kFrontward[direction] < 0;
    switch (r.cut.part) {
      case AirwayPart::vestibule:
        return kVestibule;
      case AirwayPart::cords:
        return kFrontward[direction] == 0 ? cord(from_tip_m) : kCommissure;
      case AirwayPart::subglottis:
      case AirwayPart::cricoid:
        return kCricoid;
      case AirwayPart::trachea:
      case AirwayPart::main_bronchus:
        return back ? kMembrane : kTrachea;
      case AirwayPart::oesophagus:
        return kOesophagus;
    }
    return kTrachea;
  }

  double half_width_of(const Ring& r, int direction, double frontward) const {
    if (r.cut.part == AirwayPart::cords && kFrontward[direction] == 0) return gap(r, frontward).half_m;
    return reach_of(r.cut, direction);
  }

  void add_ring(int k, int node, double share) {
    const Ring& r = ring(k);
    const double here = beyond(k, node), there = beyond(k, node + 1), whole = here - there;
    const At a = at(node, std::abs(whole) > 1e-9 ? std::clamp(here / whole, 0.0, 1.0) : 0.0);
    const Vec3 offset = a.point - centre(k);
    const double frontward = offset.dot(r.front);
    // Of the entrance's rim no more than what of the tube is in.
    const double length = (k == 0 ? std::min(r.before_m, a.from_tip_m) : r.before_m) + share * r.after_m;
    const double cosine = a.towards.dot(r.cut.along);
    const double along = std::copysign(std::max(std::abs(cosine), kLeastAlong), cosine);
    const bool cords = r.cut.part == AirwayPart::cords;
    for (int d = 0; d < kDirections; d += cords ? 2 : 1) {
      const Vec3 u = kLeftward[d] * r.cut.left + kFrontward[d] * r.front;
      const TubeOutside::Reach tube = reach(a, u);
      const double room = half_width_of(r, d, frontward);
      // A point of the tube's side: as the tube goes along itself it stays as far from the wall as it is.
      Vec3 gradient = u - u.dot(a.towards) / along * r.cut.along;
      if (cords && kFrontward[d] == 0) gradient -= gap(r, frontward).slope * r.front;
      const double tilt = std::min(gradient.norm(), 1.3);
      const double depth = offset.dot(u) + tilt * tube.m - room;
      if (cosine > 0) gradient += tilt * tube.slope / along * r.cut.along;
      const Wall w = wall(r, d, a.from_tip_m);
      add(a, {u, depth, gradient, {w.soft * length, w.give, w.hard * length}}, r.cut.part, r.cut.larynx_share);
    }
  }

  /// The ring at the tip itself, between the last it has passed and the next.
  void add_tip(int k, double share) {
    const Ring &r = ring(k), &next = ring(k + 1);
    const At a = at(0, 0.0);
    const double length = share * ((1 - share) * r.after_m + share * next.before_m);
    const Vec3 way = centre(k + 1) - centre(k);
    const Vec3 along = ((1 - share) * r.cut.along + share * next.cut.along).normalized();
    Vec3 left = (1 - share) * r.cut.left + share * next.cut.left;
    left = (left - left.dot(along) * along).normalized();
    const Vec3 front = along.cross(left), offset = a.point - centre(k) - share * way;
    const double spacing = std::max(way.dot(along), 1e-4);
    const double larynx = (1 - share) * r.cut.larynx_share + share * next.cut.larynx_share;
    const bool cords = r.cut.part == AirwayPart::cords || next.cut.part == AirwayPart::cords;
    for (int d = 0; d < kDirections; d += cords ? 2 : 1) {
      const Vec3 u = kLeftward[d] * left + kFrontward[d] * front;
      const double frontward = offset.dot(front);
      const double room = half_width_of(r, d, frontward), room_next = half_width_of(next, d, frontward);
      const double depth = offset.dot(u) + reach(a, u).m - (1 - share) * room - share * room_next;
      const Vec3 gradient = u + std::clamp((room - room_next - way.dot(u)) / spacing, -3.0, 3.0) * along;
      const Wall w = wall(r, d, 0.0), w_next = wall(next, d, 0.0);
      const auto mixed = [share](double here, double there) { return (1 - share) * here + share * there; };
      add(a,
          {u,
           depth,
           gradient,
           {length * mixed(w.soft, w_next.soft), mixed(w.give, w_next.give), length * mixed(w.hard, w_next.hard)}},
          share < 0.5 ? r.cut.part : next.cut.part, larynx);
    }
  }

  /// Beyond the last ring the canal goes on no farther.
  void add_end() {
    const int k = static_cast<int>(chain_.size()) - 1;
    const Ring& r = ring(k);
    const Wall w = wall(r, 0, 0.0);
    const double length = r.before_m;
    add(at(0, 0.0), {r.cut.along, beyond(k, 0), r.cut.along, {w.soft * length, w.give, w.hard * length}}, r.cut.part,
        r.cut.larynx_share);
  }

  void add(const At& a, const Press& press, AirwayPart part, double larynx_share) {
    const double steep = press.gradient.norm();
    for (int stage = 0; stage < 2; ++stage) {
      const double depth = press.depth - (stage == 0 ? 0.0 : press.spring.give);
      const double stiffness = stage == 0 ? press.spring.soft : press.spring.hard;
      if (depth < -a.near || !(stiffness > 0)) return;
      RodContact c;
      c.node = a.node;
      c.weight = a.weight;
      c.normal = press.gradient / -steep;
      c.depth_m = depth / steep;
      c.stiffness_n_m = std::min(stiffness * steep * steep, kMostStiffness);
      c.friction = input_.friction;
      c.surface_velocity = larynx_share * input_.larynx_velocity;
      ContactTag tag;
      tag.load = static_cast<std::uint8_t>(part);
      tag.before_tip = outside_.before_tip(a.from_tip_m, 0.0);
      tag.larynx_share = static_cast<float>(larynx_share);
      tag.at = a.point + (outside_.radius()) * press.outward;
      contacts_.add(c, tag);
    }
  }

  const Passage& passage_;
  const Chain& chain_;
  const PassageState& state_;
  const TubeOutside& outside_;
  const Rod& rod_;
  const RodState& tube_;
  const PassageInput& input_;
  double dt_;
  TubeContacts& contacts_;
};

}  // namespace

void add_wall_contacts(const Passage& passage, const PassageState& state, const TubeOutside& outside, const Rod& rod,
                       const RodState& tube, const PassageInput& input, double dt, TubeContacts& contacts) noexcept {
  if (state.inside > 0) Walls(passage, state, outside, rod, tube, input, dt, contacts).add_all();
}

}  // namespace vallecula::engine

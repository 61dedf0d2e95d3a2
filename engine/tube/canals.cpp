#include "engine/tube/canals.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

using Ring = Passage::Ring;
using Chain = Passage::Chain;

constexpr double kWayIn = 2e-3;      // m beyond a first ring's plane within which a tip that comes from aside is let in
constexpr double kMouthGive = 3e-3;  // m: the oesophagus' mouth opens by this before a tip (assumed)
constexpr double kRightFavoured = 1e-3;  // m: the left bronchus has to be nearer by this (assumed)

bool within_outline(const Ring& ring, const Vec3& offset, double wider) {
  const AirwayRing& r = ring.cut;
  const double x = offset.dot(r.left), y = offset.dot(ring.front);
  const double a = x / (wider + (x > 0 ? r.to_left_m : r.to_right_m));
  const double b = y / (wider + (y > 0 ? r.to_front_m : r.to_back_m));
  return a * a + b * b <= 1;
}

void enter(const Passage& p, const Vec3& larynx_way, const RodState& tube, double dt, PassageState& s) {
  const Vec3& tip = tube.position[0];
  const double far = kWayIn + tube.velocity[0].norm() * dt;
  for (const Canal canal : {Canal::airway, Canal::oesophagus}) {
    const Ring& first = p.chain(canal, -1).front();
    const double beyond = first.beyond(tip, larynx_way);
    if (!(beyond >= 0 && beyond < far)) continue;
    if (!within_outline(first, tip - first.centre(larynx_way), canal == Canal::oesophagus ? kMouthGive : 0.0)) continue;
    if (!came_by_mouth(p, tube)) continue;
    s.canal = canal;
    s.inside = 1;
    s.passed[0] = -1;
    return;
  }
}

int side_at_carina(const Passage& p, const Vec3& point) {
  const std::size_t carina = static_cast<std::size_t>(p.carina());
  const Vec3& along = p.airway(0)[carina].cut.along;
  double aside[2];
  for (int side = 0; side < 2; ++side) {
    const Vec3 way = point - p.airway(side)[carina + 1].cut.centre;
    aside[side] = (way - way.dot(along) * along).norm();
  }
  return aside[1] + kRightFavoured < aside[0] ? 1 : 0;
}

}  // namespace

int last_passed(const Vec3& x, const Chain& chain, int rings, const Vec3& larynx_way, int before) noexcept {
  int k = std::min(before, rings - 1);
  while (k + 1 < rings && chain[static_cast<std::size_t>(k) + 1].beyond(x, larynx_way) >= 0) ++k;
  while (k >= 0 && chain[static_cast<std::size_t>(k)].beyond(x, larynx_way) < 0) --k;
  return k;
}

void follow_canals(const Passage& p, const Vec3& larynx_way, const TubeOutside& outside, const RodState& tube,
                   double dt, PassageState& s) noexcept {
  if (s.inside == 0) enter(p, larynx_way, tube, dt, s);
  if (s.inside == 0) return;
  const int before_carina = p.carina() + 1;
  const auto rings = [&] {
    const bool branching = s.canal == Canal::airway && s.side < 0;
    return branching ? before_carina : static_cast<int>(p.chain(s.canal, s.side).size());
  };
  const auto follow = [&](std::size_t node) {
    const int before = static_cast<int>(node) < s.inside ? s.passed[node] : -1;
    s.passed[node] = static_cast<std::int16_t>(
        last_passed(tube.position[node], p.chain(s.canal, s.side), rings(), larynx_way, before));
  };
  follow(0);
  if (s.canal == Canal::airway && s.side < 0 && s.passed[0] == p.carina()) {
    const Vec3 point = tube.position[0] + outside.radius() * (tube.rotation[0] * outside.point_side());
    s.side = side_at_carina(p, point);
    follow(0);
  } else if (s.passed[0] < p.carina()) {
    s.side = -1;
  }
  if (s.passed[0] < 0) {
    s.set_rest();
    return;
  }
  int inside = 1;
  for (; inside < kTubeNodes; ++inside) {
    follow(static_cast<std::size_t>(inside));
    if (s.passed[static_cast<std::size_t>(inside)] < 0) break;
  }
  s.inside = inside;
}

}  // namespace vallecula::engine

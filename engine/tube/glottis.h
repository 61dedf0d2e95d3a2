// The opening between the vocal cords: it widens and narrows with breathing, closes when it is touched, and stays shut
// in laryngospasm. How the cords push back against a tube between them is the passage's concern.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/physiology/draw.h"

namespace vallecula::engine {

/// Fixed in a trial.
struct Glottis {
  double length_m = 0.007;  ///< from the front commissure to the back wall, at term (CLINICAL, assumed)
  /// Share of the length, from the front, over which the cords part like a V; behind it, between the arytenoids, the
  /// gap is as wide throughout. Newborn: 0.43 to 0.45 (Sato 2015, Laryngoscope 125:E186).
  double front_share = 0.44;
  double widest_half_slope = 0.58;  ///< half the gap over the distance from the commissure: 30 degrees a side (assumed)
  bool relaxed = false;             ///< by a muscle relaxant: neither breath nor touch moves the cords
  double closure_s = 1.0;           ///< median time they stay closed after a touch, s (assumed)
  double spasm_s = 0.0;             ///< laryngospasm after a touch, or from the start; 0: none
  bool spasm_from_start = false;
  std::uint64_t seed = 1;
};

/// Returns `glottis` as it is. Throws std::invalid_argument with the number at fault, or with what contradicts what.
Glottis checked(const Glottis& glottis);

struct GlottisInput {
  bool breathing = false;
  double breath_phase = 0.0;  ///< of the infant's own breathing, 0..1 from the begin of a breath in
  bool held_closed = false;   ///< from outside, as by a laryngospasm; relaxed cords cannot be
  bool touched = false;       ///< by blade, tube or catheter, at the cords or above them within the larynx
};

enum GlottisFault : std::uint32_t {
  kGlottisFaultNone = 0,
  kGlottisFaultInput = 1u << 0,  ///< phase or time was not a number: taken as none
  kGlottisFaultState = 1u << 1,  ///< the state was not a number; the cords are back at their start
};

struct GlottisState {
  double opening = 0.0;   ///< 0 closed .. 1 as wide as at the height of a deep breath
  double closed_s = 0.0;  ///< that they will yet hold themselves closed
  double weary_s = 0.0;   ///< after a closure: time in which touch closes them no more
  bool touched = false;   ///< in the last step
  bool spasm = false;     ///< the present closure is a laryngospasm
  Draw draw;
  std::uint32_t faults = kGlottisFaultNone;  ///< of the last step
};

GlottisState start(const Glottis& glottis) noexcept;

/// dt_s (s, up to 0.1) of the cords' life.
void step(const Glottis& glottis, GlottisState& state, const GlottisInput& input, double dt_s) noexcept;

/// Half the width of the gap, m, at distance_m behind the front commissure, in the plane of the cords; 0 outside.
inline double half_width(const Glottis& g, double opening, double distance_m) noexcept {
  if (!(distance_m > 0) || distance_m > g.length_m) return 0.0;
  return opening * g.widest_half_slope * std::min(distance_m, g.front_share * g.length_m);
}

/// Area of the gap, m^2.
inline double area(const Glottis& g, double opening) noexcept {
  const double front = g.front_share * g.length_m;
  return opening * g.widest_half_slope * front * (front + 2.0 * (g.length_m - front));
}

}  // namespace vallecula::engine

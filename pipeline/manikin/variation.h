// How one manikin differs from the next: a handful of numbers drawn from the seed, each within the range CLINICAL
// sources give (or a modest assumed one), all at term scale.
#pragma once

#include <cstdint>

#include "pipeline/manikin/field.h"

namespace vallecula::pipeline::manikin {

struct Variation {
  double mouth_opening = 22.0;     ///< mm between the gums; 20.4-23.6 (radiographic series, < 1 month)
  double gonial_width = 63.6;      ///< mm; +- 6.8 is one standard deviation (neonate CT)
  double tongue_bulk = 0.0;        ///< mm the dorsum is raised in the middle; -0.5 .. 1.5 (the design allows 2)
  double tongue_width = 1.0;       ///< factor; 0.96-1.04 (assumed)
  double epiglottis_length = 1.0;  ///< factor; 0.94-1.06 (assumed)
  double epiglottis_turn = 0.0;    ///< degrees forward; -4 .. 3 (assumed)
  double epiglottis_curl = 2.5;    ///< mm the edges lie behind the middle; 2.0-2.8 (assumed)
  double uvula_length = 0.0;       ///< mm; -1 .. 0.8 (assumed)
  double lumen = 1.0;              ///< factor on the cricoid's and trachea's radii; 0.95-1.05 (assumed)
  double trachea_length = 1.0;     ///< factor; 0.95-1.05 (assumed)
  double head_length = 1.0;        ///< factor; 0.96-1.04
  double head_width = 1.0;         ///< factor; 0.96-1.04
  double nose_size = 1.0;          ///< factor; 0.9-1.1
  double cheek = 0.0;              ///< mm of fullness; -1.5 .. 1.5
  double chin = 0.0;               ///< mm forward; -0.8 .. 0.8
  double ear_size = 1.0;           ///< factor; 0.9-1.1
  double larynx_rise = 0.0;        ///< mm to the head, of the larynx and all that hangs on it; not drawn
};

/// Seed 0 is the unvaried design; any other seed draws every number of Variation afresh.
Variation vary(std::uint64_t seed);

/// Where a point (y, z) that moves with the jaw goes when the mouth opening differs from 22 mm: a turn about the
/// condyles; `share` 1 for the jaw itself, less for what follows it partly.
Flat with_jaw(const Variation& v, Flat p, double share = 1.0);
/// Growth of the rami's distance from the middle with the gonial width; the front of the arch keeps its width.
double with_gonia(const Variation& v, double x, double y);

/// Where a point goes when the larynx lies higher than the design's by `larynx_rise`: everything from the tip of the
/// epiglottis down and behind the floor of the mouth moves with it, the space up to the soft palate gives or takes.
Vec with_larynx(const Variation& v, const Vec& p);
/// Where it came from.
Vec without_larynx(const Variation& v, const Vec& p);
/// No distance grows by more than this on the way back, for rises from kDeepestLarynx to kHighestLarynx.
constexpr double kLarynxStretch = 1.5;
constexpr double kDeepestLarynx = -3.0;
constexpr double kHighestLarynx = 1.5;  // a larynx higher than that is not seen by any lift

constexpr Flat kCondyle{46.7, -6.3};
constexpr double kCondyleX = 30.0;

}  // namespace vallecula::pipeline::manikin

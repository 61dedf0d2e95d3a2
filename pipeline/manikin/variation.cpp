#include "pipeline/manikin/variation.h"

namespace vallecula::pipeline::manikin {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers on every platform, unlike std's distributions.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 0x632BE59BD9B4E019ull) {}
  double between(double low, double high) {
    state_ += 0x9E3779B97F4A7C15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    z ^= z >> 31;
    return low + (high - low) * static_cast<double>(z >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace

Variation vary(std::uint64_t seed) {
  Variation v;
  if (seed == 0) return v;
  Draw draw(seed);
  v.mouth_opening = draw.between(20.4, 23.6);
  v.gonial_width = draw.between(63.6 - 6.8, 63.6 + 6.8);
  v.tongue_bulk = draw.between(-0.5, 1.5);
  v.tongue_width = draw.between(0.96, 1.04);
  v.epiglottis_length = draw.between(0.94, 1.06);
  v.epiglottis_turn = draw.between(-4.0, 3.0);
  v.epiglottis_curl = draw.between(2.0, 2.8);
  v.uvula_length = draw.between(-1.0, 0.8);
  v.lumen = draw.between(0.95, 1.05);
  v.trachea_length = draw.between(0.95, 1.05);
  v.head_length = draw.between(0.96, 1.04);
  v.head_width = draw.between(0.96, 1.04);
  v.nose_size = draw.between(0.9, 1.1);
  v.cheek = draw.between(-1.5, 1.5);
  v.chin = draw.between(-0.8, 0.8);
  v.ear_size = draw.between(0.9, 1.1);
  return v;
}

Flat with_jaw(const Variation& v, Flat p, double share) {
  // The lower gum lies 45.9 mm from the hinge; opening by one millimetre there turns the jaw by 1/45.9 rad.
  const double angle = share * (v.mouth_opening - 22.0) / 45.9;
  const double u = p.u - kCondyle.u;
  const double w = p.v - kCondyle.v;
  return {kCondyle.u + std::cos(angle) * u - std::sin(angle) * w,
          kCondyle.v + std::sin(angle) * u + std::cos(angle) * w};
}

Vec without_larynx(const Variation& v, const Vec& p) {
  if (v.larynx_rise == 0.0) return p;
  const double share = ramp(-17.0, -32.0, p.z) * ramp(8.0, 24.0, p.y) * ramp(30.0, 16.0, std::abs(p.x));
  return {p.x, p.y, p.z - v.larynx_rise * share};
}

Vec with_larynx(const Variation& v, const Vec& p) {
  Vec moved =
      p;  // the way back is given; it is at most 0.3 steep along z, so this halves its error three times a round
  for (int i = 0; i < 24 && v.larynx_rise != 0.0; ++i) moved.z += p.z - without_larynx(v, moved).z;
  return moved;
}

double with_gonia(const Variation& v, double x, double y) {
  return x * (1.0 + (v.gonial_width / 63.6 - 1.0) * ramp(12.0, 34.0, y));
}

}  // namespace vallecula::pipeline::manikin

#include "engine/physiology/oxygen.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr double kAdultP50 = 26.86;    // mmHg: where Severinghaus' equation gives one half
constexpr double kBtpsToStpd = 863.0;  // mmHg: ml BTPS times a pressure, over this, is ml STPD (760 * 310 / 273)
constexpr double kScarce = 0.15;       // venous saturation below which tissue gets less than it would use (assumed)

constexpr double kLeastDriven = 0.05, kMostDriven = 1.0;  // arterial, by drive()

double end_capillary(const Oxygen& o, const OxygenState& s) noexcept {
  double sum = 0.0;
  for (int i = 0; i < kLungUnits; ++i) sum += o.flow_share[i] * saturation(s.alveolar_mmhg[i], o.p50_mmhg);
  return sum;
}

}  // namespace

double saturation(double po2_mmhg, double p50_mmhg) noexcept {
  const double p = std::max(0.0, po2_mmhg) * kAdultP50 / p50_mmhg;
  const double q = p * (p * p + 150.0);
  return q / (q + 23400.0);
}

OxygenState start(const Oxygen& o) noexcept {
  OxygenState s;
  s.alveolar_mmhg = o.first_mmhg;
  s.shunt = o.first_shunt;
  // Fick: venous = arterial - used; arterial = (1 - shunt) * end-capillary + shunt * venous.
  const double used = o.consumption_ml_s / (o.flow_ml_s * o.capacity);
  s.arterial = std::clamp(end_capillary(o, s) - s.shunt / (1.0 - s.shunt) * used, 0.0, 1.0);
  s.venous = std::max(0.0, s.arterial - used);
  return s;
}

void breathe(const Oxygen& o, OxygenState& s, double share, double gas_mmhg) noexcept {
  for (int i = 0; i < kLungUnits; ++i)
    s.alveolar_mmhg[i] += share * o.breath_share[i] * (gas_mmhg - s.alveolar_mmhg[i]);
  s.shunt = std::max(o.shunt, s.shunt / (1.0 + share * o.shunt_closing * s.shunt));
}

void use(const Oxygen& o, OxygenState& s, double flow, double dt_s) noexcept {
  const double blood_ml = o.flow_ml_s * flow * dt_s, through = 1.0 - s.shunt;
  // What lungs, arteries and tissue exchange in this step, each by the state at its begin: what one loses another gets.
  double taken = 0.0;
  for (int i = 0; i < kLungUnits; ++i) {
    const double flow_ml = blood_ml * through * o.flow_share[i];
    const double ml = flow_ml * o.capacity * (saturation(s.alveolar_mmhg[i], o.p50_mmhg) - s.venous);
    s.alveolar_mmhg[i] -= ml * kBtpsToStpd / o.volume_ml[i];
    taken += ml / o.capacity;
  }
  const double used = o.consumption_ml_s * dt_s / o.capacity * std::min(1.0, s.venous / kScarce);
  const double arterial = s.arterial + (taken + blood_ml * (s.venous - s.arterial)) / o.arterial_ml;
  s.venous += (blood_ml * (s.arterial - s.venous) - used) / o.venous_ml;
  s.arterial = arterial;
}

double drive(const Oxygen& o, OxygenState& s, double by, double most_mmhg) noexcept {
  const double before = s.arterial, arterial = std::clamp(s.arterial + by, kLeastDriven, kMostDriven);
  const double way = arterial - before;
  if (by * way < 0.0) return 0.0;  // below the least already: "down" does not lift it there
  for (int i = 0; i < kLungUnits; ++i) {
    const double wanted = saturation(s.alveolar_mmhg[i], o.p50_mmhg) + way;
    double low = 0.0, high = most_mmhg;
    for (int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2;
      (saturation(middle, o.p50_mmhg) < wanted ? low : high) = middle;
    }
    // A saturation near 1 stands for any pressure: the lung is not emptied by a rise, nor filled by a fall.
    s.alveolar_mmhg[i] = way > 0 ? std::max(s.alveolar_mmhg[i], high) : std::min(s.alveolar_mmhg[i], low);
  }
  s.arterial = arterial;
  s.venous = std::clamp(s.venous + way, 0.0, arterial);
  const double full = end_capillary(o, s);
  if (way > 0 && full - s.venous > 1e-6)
    s.shunt = std::clamp((full - arterial) / (full - s.venous), std::min(o.shunt, s.shunt), s.shunt);
  return way;
}

double store_ml(const Oxygen& o, const OxygenState& s) noexcept {
  double ml = o.capacity * (o.arterial_ml * s.arterial + o.venous_ml * s.venous);
  for (int i = 0; i < kLungUnits; ++i) ml += o.volume_ml[i] * s.alveolar_mmhg[i] / kBtpsToStpd;
  return ml;
}

}  // namespace vallecula::engine

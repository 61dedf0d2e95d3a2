// Where an infant's oxygen is, and how it is used up: two units of lung (one ventilated well, one badly), arterial and
// venous blood, consumption. The parts and their order of importance are those of Sands et al. 2009 (PLoS Comput Biol
// 5:e1000588) and of their paper on uneven ventilation (2010); the numbers are in infant.cpp.
#pragma once

#include <array>

namespace vallecula::engine {

/// Fraction of haemoglobin that carries oxygen at a partial pressure (mmHg): Severinghaus 1979 (J Appl Physiol 46:599,
/// equation 1, adult blood), the pressure scaled so that half is reached at p50_mmhg. Fetal haemoglobin's lower p50 is
/// the whole of its difference here.
double saturation(double po2_mmhg, double p50_mmhg) noexcept;

constexpr double kReferenceBreaths = 40.0;  ///< breaths/min at which the resting state is kept up
constexpr int kLungUnits = 2;

/// Fixed for an infant.
struct Oxygen {
  double consumption_ml_s = 0.0;  ///< oxygen, STPD
  double flow_ml_s = 0.0;         ///< blood, at the resting heart rate
  double capacity = 0.0;          ///< ml of oxygen that a ml of blood holds; what is dissolved is left out
  double arterial_ml = 0.0, venous_ml = 0.0;
  double p50_mmhg = 0.0;
  double inspired_mmhg = 0.0;  ///< of the gas it had at the start, and has for breaths of its own
  double given_mmhg = 0.0;     ///< of the gas of breaths given
  double shunt = 0.0;          ///< share of the flow that passes no lung, once the lungs are aerated
  double first_shunt = 0.0;    ///< and at the start: far more at birth
  double shunt_closing = 0.0;  ///< what a breath adds to 1 / shunt: the shunt falls fast at first, then slowly
  std::array<double, kLungUnits> volume_ml{};     ///< at the end of a breath out, BTPS
  std::array<double, kLungUnits> flow_share{};    ///< of the flow that passes lung; sum 1
  std::array<double, kLungUnits> first_mmhg{};    ///< alveolar pressure at the start
  std::array<double, kLungUnits> breath_share{};  ///< of the way to the inspired pressure that a breath goes
};

struct OxygenState {
  std::array<double, kLungUnits> alveolar_mmhg{};
  double arterial = 0.0, venous = 0.0;  ///< saturation, 0..1
  double shunt = 0.0;
};

/// What a steady start needs, from the pressures, volumes and flows: arterial and venous saturation.
OxygenState start(const Oxygen& o) noexcept;

/// A breath that reaches `share` (0..1) of the lungs' ventilation with gas of this oxygen pressure.
void breathe(const Oxygen& o, OxygenState& s, double share, double gas_mmhg) noexcept;

/// dt_s (s) without a breath, blood flowing at `flow` times its resting rate.
void use(const Oxygen& o, OxygenState& s, double flow, double dt_s) noexcept;

/// From outside, as an instructor does: all saturations change by `by` together, lungs, arteries and veins, within what
/// gas of `most_mmhg` and an empty store allow; where the shunt stands in the way of a rise it gives way, down to the
/// infant's own. Returns by how much the arterial one changed. What breaths and blood do to it afterwards is theirs.
double drive(const Oxygen& o, OxygenState& s, double by, double most_mmhg) noexcept;

/// All oxygen in lungs and blood, ml STPD.
double store_ml(const Oxygen& o, const OxygenState& s) noexcept;

}  // namespace vallecula::engine

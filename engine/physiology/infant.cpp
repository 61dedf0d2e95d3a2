#include "engine/physiology/infant.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/physiology/draw.h"

namespace vallecula::engine {

namespace {

/// Medians of a body and the spread (sigma of the logarithm) of what an infant has of its own. The preterm's are
/// calibrated, together with its Start, so that 200 seeds give the course of Kothari 2021 (Arch Dis Child 106:603);
/// each lies within what textbooks give for ventilated preterm infants. The term's are such textbook values: assumed.
struct Body {
  double consumption_ml_kg_min, consumption_spread;
  double lung_ml_kg, lung_spread;
  double flow_ml_kg_min, blood_ml_kg, arterial_share;
  double haemoglobin_g_dl, shunt;
  double resting_per_min;
};
constexpr Body kPreterm = {7.4, 0.19, 17.0, 0.05, 220.0, 94.0, 0.21, 12.0, 0.076, 155.0};
constexpr Body kTerm = {6.5, 0.15, 27.0, 0.10, 240.0, 85.0, 0.25, 17.0, 0.05, 140.0};
constexpr double kPretermWeeks = 32.0, kTermWeeks = 37.0;  // between them a mixture

/// The lungs at the start: alveolar pressure of the well ventilated unit with its spread, the badly ventilated unit's
/// share of lung and flow and its pressure as a part of the other's. Uneven lungs desaturate early (Sands 2010).
struct Start {
  double well_mmhg, spread, badly_share, badly_part;
};
constexpr Start kStarts[] = {
    {174.0, 0.52, 0.53, 0.38},  // premedicated_preterm: calibrated
    {105.0, 0.10, 0.35, 0.75},  // term: assumed
    {450.0, 0.20, 0.35, 0.75},  // preoxygenated: assumed
    {105.0, 0.10, 0.35, 0.75},  // delivery_room: assumed
};

constexpr double kP50 = 20.5;               // mmHg: newborn blood, "slightly above 20" (Tosetti 1985)
constexpr double kHaemoglobinHolds = 1.34;  // ml of oxygen a gram (Huefner)
constexpr double kAirMmhg = 0.21 * 713.0, kPureMmhg = 713.0;
constexpr double kHardestLung = 0.5;                      // of the way to the inspired pressure: no breath does more
constexpr double kLeastStart = 0.901;                     // arterial, but at birth: nobody starts an attempt below 90 %
constexpr double kLag = 5.0, kMostLag = 20.0;             // s: of the displayed saturation (CLINICAL)
constexpr double kHalfLoad = 2.0, kHalfLoadSpread = 0.5;  // N: of the vagal reflex (assumed)
constexpr double kAtropineLeaves = 0.1;                   // of the reflexes: Kothari saw no bradycardia at all
constexpr double kRestingSpread = 0.06;
constexpr double kDetectorHeart = 60.0;  // 1/min (assumed)
// At birth: saturation 60 to 65 %, heart 96/min (65 to 127) at one minute, 163 at five (Dawson 2010). The shunt closes
// so that 40 breaths a minute bring about the medians of Dawson 2010 (Pediatrics 125:e1340): 73, 89, 96 % at 2, 5 and
// 10 minutes.
constexpr double kBirthLow = 0.60, kBirthHigh = 0.65, kBirthHeart = 96.0, kBirthHeartSpread = 0.4, kBirthSlowest = 45.0;
constexpr double kShuntClosing = 0.0101;
constexpr double kNewbornHeart = 165.0;

constexpr double kBlocked = 0.05, kWideEnough = 0.25;  // opening of the cords: no air, all of the air
constexpr double kShortestBreath = 0.4;                // s: a breath given sooner meets a chest that has not emptied
constexpr double kRateForgotten = 10.0;                // s without a breath: there is no rate
constexpr double kRateSmoothing = 0.3;
constexpr double kMostLoad = 100.0;  // N: more slows the heart no further
constexpr double kMostStep = 0.1;    // s

double mix(double preterm, double term, double share) { return preterm + share * (term - preterm); }

Body body_at(double weeks) {
  const double m = std::clamp((weeks - kPretermWeeks) / (kTermWeeks - kPretermWeeks), 0.0, 1.0);
  const auto of = [m](double Body::*what) { return mix(kPreterm.*what, kTerm.*what, m); };
  return {of(&Body::consumption_ml_kg_min), of(&Body::consumption_spread), of(&Body::lung_ml_kg),
          of(&Body::lung_spread),           of(&Body::flow_ml_kg_min),     of(&Body::blood_ml_kg),
          of(&Body::arterial_share),        of(&Body::haemoglobin_g_dl),   of(&Body::shunt),
          of(&Body::resting_per_min)};
}

void check(const InfantDescription& d) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument("infant: " + why); };
  if (!(d.weight_kg >= 0.3 && d.weight_kg <= 6.0))
    refuse("a weight from 0.3 to 6 kg is needed, not " + std::to_string(d.weight_kg));
  if (!(d.gestation_weeks >= 22.0 && d.gestation_weeks <= 44.0))
    refuse("a gestation from 22 to 44 weeks is needed, not " + std::to_string(d.gestation_weeks));
  if (!(d.added_oxygen >= 0.0 && d.added_oxygen <= 0.79))
    refuse("from 0 to 0.79 of oxygen can be added, not " + std::to_string(d.added_oxygen));
  const std::string weeks = std::to_string(d.gestation_weeks) + " weeks";
  switch (d.course) {
    case Course::premedicated_preterm:
      if (d.gestation_weeks > kPretermWeeks) refuse("the preterm course holds up to 32 weeks, not for " + weeks);
      if (!d.premedicated) refuse("the preterm course is that of premedicated infants");
      break;
    case Course::term:
      if (d.gestation_weeks <= kPretermWeeks) refuse("the term course holds from 32 weeks on, not for " + weeks);
      break;
    case Course::preoxygenated:
      break;
    case Course::delivery_room:
      if (d.premedicated) refuse("nobody is premedicated in the delivery room");
      break;
    default:
      refuse("no such course: " + std::to_string(static_cast<int>(d.course)));
  }
}

/// Share of a breath that comes through the cords.
double through_cords(double opening) noexcept {
  return std::clamp((opening - kBlocked) / (kWideEnough - kBlocked), 0.0, 1.0);
}

bool in_airway(TubeTip tip) noexcept { return tip == TubeTip::trachea || tip == TubeTip::main_bronchus; }

/// Share of the lungs' ventilation that a breath given reaches: of one main bronchus half, of the oesophagus nothing.
double reached(const InfantInput& in, double opening) noexcept {
  if (in.breath == Breath::mask) return through_cords(opening);
  switch (in.tip) {
    case TubeTip::trachea:
      return 1.0;
    case TubeTip::main_bronchus:
      return 0.5;
    default:
      return 0.0;
  }
}

double direction(int asked) noexcept { return asked > 0 ? 1.0 : -1.0; }

double number_or(double value, double otherwise, std::uint32_t& faults) noexcept {
  if (std::isfinite(value)) return value;
  faults |= kInfantFaultInput;
  return otherwise;
}

bool sound(const InfantState& s) noexcept {
  double sum = s.oxygen.arterial + s.oxygen.venous + s.oxygen.shunt + s.heart.per_min + s.heart.awakening +
               s.heart.tissue + s.heart.inflation + s.heart.used_to_n + s.heart.getting_used_to_n + s.heart.driven_per_min + s.pending_s +
               s.pending_load_n + s.breath_phase + s.since_given_s + s.given_interval_s + s.since_breath_s;
  for (const double p : s.oxygen.alveolar_mmhg) sum += p;
  return std::isfinite(sum);
}

void reach_lungs(InfantState& s, const Infant& infant, double share, double gas_mmhg) noexcept {
  if (!(share > 0)) return;
  breathe(infant.oxygen, s.oxygen, share, gas_mmhg);
  breathe(s.heart, share);
  s.since_breath_s = 0.0;
}

void give_breath(const Infant& infant, InfantState& s, const InfantInput& in, double opening) noexcept {
  if (s.breaths_given > 0 && s.since_given_s < kShortestBreath) return;
  if (s.breaths_given > 0 && s.since_given_s < kRateForgotten)
    s.given_interval_s += (s.given_interval_s > 0 ? kRateSmoothing : 1.0) * (s.since_given_s - s.given_interval_s);
  else
    s.given_interval_s = 0.0;
  s.since_given_s = 0.0;
  ++s.breaths_given;
  reach_lungs(s, infant, reached(in, opening), infant.oxygen.given_mmhg);
  if (in.breath == Breath::tube) breathe(infant.detector, s.detector, in_airway(in.tip), s.heart.per_min);
}

}  // namespace

Infant build_infant(const InfantDescription& d) {
  check(d);
  const Body body = body_at(d.gestation_weeks);
  const Start& lungs = kStarts[static_cast<int>(d.course)];
  const bool birth = d.course == Course::delivery_room;
  Draw draw{d.seed};
  // What decides on the course of the saturation is spread evenly over the seeds.
  const auto even = [&d](int dimension, double sigma) {
    return portable_exp(sigma * normal_quantile(even_uniform(d.seed, dimension)));
  };
  Infant infant;

  Oxygen& o = infant.oxygen;
  o.p50_mmhg = kP50;
  o.consumption_ml_s = d.weight_kg * body.consumption_ml_kg_min / 60.0 * even(0, body.consumption_spread);
  o.flow_ml_s = d.weight_kg * body.flow_ml_kg_min / 60.0;
  o.capacity = kHaemoglobinHolds * body.haemoglobin_g_dl / 100.0;
  o.arterial_ml = d.weight_kg * body.blood_ml_kg * body.arterial_share;
  o.venous_ml = d.weight_kg * body.blood_ml_kg - o.arterial_ml;
  o.shunt = o.first_shunt = body.shunt;
  const double lung_ml = d.weight_kg * body.lung_ml_kg * even(3, body.lung_spread);
  o.flow_share = {1.0 - lungs.badly_share, lungs.badly_share};
  for (int i = 0; i < kLungUnits; ++i) o.volume_ml[i] = lung_ml * o.flow_share[i];

  // The pressures, raised where they would start the infant below what an attempt is begun with.
  double well = lungs.well_mmhg * even(1, lungs.spread);
  const auto at = [&](double mmhg) {
    o.first_mmhg = {mmhg, mmhg * lungs.badly_part};
    return start(o);
  };
  if (at(well).arterial < kLeastStart) {
    double low = well, high = kPureMmhg;
    for (int k = 0; k < 40; ++k) (at((low + high) / 2).arterial < kLeastStart ? low : high) = (low + high) / 2;
    well = high;
  }
  // The gas it breathes, and what a breath brings of it, so that kReferenceBreaths keep it as it starts.
  const double used = o.consumption_ml_s / (o.flow_ml_s * o.capacity);
  well = std::min(well, 0.9 * kPureMmhg);
  const OxygenState rest = at(well);
  o.inspired_mmhg = d.course == Course::preoxygenated ? kPureMmhg : std::clamp(well + 50.0, kAirMmhg, kPureMmhg);
  o.given_mmhg = std::min(kPureMmhg, o.inspired_mmhg + d.added_oxygen * kPureMmhg);
  for (int i = 0; i < kLungUnits; ++i) {
    const double taken_ml_s = o.flow_ml_s * (1.0 - o.shunt) * o.flow_share[i] * o.capacity *
                              (saturation(o.first_mmhg[i], o.p50_mmhg) - rest.venous);
    const double fall = 60.0 / kReferenceBreaths * taken_ml_s * 863.0 / o.volume_ml[i];
    o.breath_share[i] = std::clamp(fall / (o.inspired_mmhg - o.first_mmhg[i]), 0.01, kHardestLung);
  }
  if (birth) {
    const double deficit = rest.arterial + o.shunt / (1.0 - o.shunt) * used - draw.between(kBirthLow, kBirthHigh);
    o.first_shunt = deficit / (deficit + used);
    o.shunt_closing = kShuntClosing;
  }

  infant.heart.resting_per_min = (birth ? kNewbornHeart : body.resting_per_min) * draw.lognormal(kRestingSpread);
  infant.heart.first_per_min =
      birth ? std::clamp(kBirthHeart * draw.lognormal(kBirthHeartSpread), kBirthSlowest, infant.heart.resting_per_min)
            : infant.heart.resting_per_min;
  infant.heart.half_load_n = kHalfLoad * draw.lognormal(kHalfLoadSpread);
  infant.heart.reflex = d.premedicated ? kAtropineLeaves : 1.0;
  infant.detector.breaths_needed = draw.uniform() < 0.5 ? 5 : 6;  // published: within 5 or 6
  infant.detector.least_heart_per_min = kDetectorHeart;
  const double lateness = even_uniform(d.seed, 2);
  infant.delay_samples =
      static_cast<std::int32_t>((kLag + (kMostLag - kLag) * lateness * lateness) / kMonitorStep + 0.5);
  // 60 a minute at 32 weeks and before, 45 at term (assumed).
  infant.own_breaths_per_min =
      d.premedicated ? 0.0 : mix(60.0, 45.0, std::clamp((d.gestation_weeks - 32.0) / 8.0, 0.0, 1.0));
  return infant;
}

InfantState start(const Infant& infant) noexcept {
  InfantState s;
  s.oxygen = start(infant.oxygen);
  s.heart = start(infant.heart, s.oxygen.arterial);
  s.oximeter = start_oximeter(s.oxygen.arterial);
  return s;
}

InfantSigns step(const Infant& infant, InfantState& s, const InfantInput& input, double dt_s) noexcept {
  InfantSigns signs;
  const double dt = std::clamp(number_or(dt_s, 0.0, signs.faults), 0.0, kMostStep);
  const double load = std::clamp(number_or(input.blade_load_n, 0.0, signs.faults), 0.0, kMostLoad) +
                      std::clamp(number_or(input.tube_load_n, 0.0, signs.faults), 0.0, kMostLoad);
  const double opening = number_or(input.glottis_opening, 1.0, signs.faults);

  s.since_given_s += dt;
  s.since_breath_s += dt;
  if (!in_airway(input.tip) && input.tip != TubeTip::oesophagus) s.detector.breaths = 0;
  if (input.breath != Breath::none) give_breath(infant, s, input, opening);
  if (input.breathing && infant.own_breaths_per_min > 0) {
    s.breath_phase += dt * infant.own_breaths_per_min / 60.0;
    if (s.breath_phase >= 1.0) {
      s.breath_phase -= 1.0;
      // Through a tube in the airway the infant breathes as it would without.
      const double share = input.tip == TubeTip::trachea         ? 1.0
                           : input.tip == TubeTip::main_bronchus ? 0.5
                                                                 : through_cords(opening);
      reach_lungs(s, infant, share * kReferenceBreaths / infant.own_breaths_per_min, infant.oxygen.inspired_mmhg);
    }
  } else {
    s.breath_phase = 0.0;
  }

  if (input.drive_saturation != 0)
    shift(s.oximeter, drive(infant.oxygen, s.oxygen, direction(input.drive_saturation) * kDrivenSaturation * dt,
                            infant.oxygen.given_mmhg));
  if (input.drive_heart != 0) drive(s.heart, direction(input.drive_heart) * kDrivenHeart * dt);

  s.pending_load_n = std::max(s.pending_load_n, load);
  s.pending_s += dt;
  if (s.pending_s >= kMonitorStep - 1e-9) {
    beat(infant.heart, s.heart, s.oxygen.arterial, s.pending_load_n, s.pending_s);
    use(infant.oxygen, s.oxygen, flow(infant.heart, s.heart), s.pending_s);
    sample(s.oximeter, infant.delay_samples, s.oxygen.arterial);
    s.pending_s = 0.0;
    s.pending_load_n = 0.0;
  }
  if (!sound(s)) {
    s = start(infant);
    signs.faults |= kInfantFaultState;
  }

  signs.sao2 = s.oxygen.arterial;
  signs.spo2 = s.oximeter.percent / 100.0;
  signs.heart_per_min = s.heart.per_min;
  signs.detector = colour(infant.detector, s.detector);
  signs.since_breath_s = s.since_breath_s;
  const bool rate_known = s.given_interval_s > 0 && s.since_given_s < kRateForgotten;
  signs.given_per_min = rate_known ? 60.0 / std::max(s.given_interval_s, s.since_given_s) : 0.0;
  signs.breath_phase = s.breath_phase;
  return signs;
}

}  // namespace vallecula::engine

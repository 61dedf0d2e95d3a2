// The infant as the monitor shows it: oxygen, heart, oximeter and CO2 detector of one seeded infant, stepped with the
// scene. Which of its numbers are measured and which are assumed stands in infant.cpp and engine/README.md.
#pragma once

#include <cstdint>

#include "engine/physiology/heart.h"
#include "engine/physiology/monitor.h"
#include "engine/physiology/oxygen.h"

namespace vallecula::engine {

/// Where the trial begins. Only the first is calibrated to a published course; the others are assumed.
enum class Course : std::uint8_t {
  premedicated_preterm,  ///< at most 32 weeks, sedated, with atropine and a muscle relaxant (Kothari 2021)
  term,                  ///< more than 32 weeks, breathing air before
  preoxygenated,         ///< any gestation, pure oxygen before
  delivery_room,         ///< one minute old: lungs hardly aerated, saturation 60 to 65 %
};

struct InfantDescription {
  Course course = Course::premedicated_preterm;
  double weight_kg = 1.0;
  double gestation_weeks = 28.0;
  bool premedicated = true;   ///< with atropine and a muscle relaxant: no breath of its own, reflexes on the heart weak
  double added_oxygen = 0.1;  ///< to the gas it had before, as a fraction, in breaths given (assumed); 0..0.79
  std::uint64_t seed = 1;     ///< one infant of the population; 0: its median saturation and lag
};

/// What is fixed in a trial.
struct Infant {
  Oxygen oxygen;
  Heart heart;
  Co2Detector detector;
  std::int32_t delay_samples = 0;    ///< of the oximeter
  double own_breaths_per_min = 0.0;  ///< 0: premedicated
};

/// Draws the infant. Throws std::invalid_argument with the number at fault, or with what contradicts what.
Infant build_infant(const InfantDescription& description);

enum class Breath : std::uint8_t { none, mask, tube };
enum class TubeTip : std::uint8_t { none, oesophagus, trachea, main_bronchus };  ///< none: out, or above the glottis

constexpr double kDrivenSaturation = 0.05;  ///< 1/s, of an instructor's key held
constexpr double kDrivenHeart = 20.0;       ///< 1/min a second, likewise

struct InfantInput {
  Breath breath = Breath::none;  ///< given in this tick: one tick per breath
  TubeTip tip = TubeTip::none;
  double blade_load_n = 0.0;     ///< on epiglottis and larynx together
  double tube_load_n = 0.0;      ///< likewise
  double glottis_opening = 1.0;  ///< 0..1: through closed cords neither mask nor own breath comes
  bool breathing = false;        ///< tries by itself; a premedicated infant cannot
  int drive_saturation = 0, drive_heart = 0;  ///< from outside: -1 down, 1 up, by kDrivenSaturation and kDrivenHeart
};

/// Named faults of a step, bits of InfantSigns::faults.
enum InfantFault : std::uint32_t {
  kInfantFaultNone = 0,
  kInfantFaultInput = 1u << 0,  ///< a load, an opening or a time was not a number and was taken as none
  kInfantFaultState = 1u << 1,  ///< the state was not a number; the infant is back at its start
};

struct InfantState {
  OxygenState oxygen;
  HeartState heart;
  OximeterState oximeter;
  Co2DetectorState detector;
  double pending_s = 0.0;         ///< since the last inner step
  double pending_load_n = 0.0;    ///< largest load since then
  double breath_phase = 0.0;      ///< of own breathing, 0..1 from the begin of a breath in
  double since_given_s = 0.0;     ///< since the last breath given, wherever it went
  double given_interval_s = 0.0;  ///< between breaths given, smoothed; 0: fewer than two
  double since_breath_s = 0.0;    ///< since the last breath that reached a lung
  std::int32_t breaths_given = 0;
};

/// What a step leaves, as plain numbers.
struct InfantSigns {
  double sao2 = 0.0;           ///< arterial, true, 0..1
  double spo2 = 0.0;           ///< displayed, whole percent over 100
  double heart_per_min = 0.0;  ///< by ECG: at once
  DetectorColour detector = DetectorColour::purple;
  double since_breath_s = 0.0;  ///< since the last breath that reached a lung, or since the start
  double given_per_min = 0.0;   ///< rate of the breaths given lately; 0 when there were none for 10 s
  double breath_phase = 0.0;    ///< own breathing, 0..1; 0 in apnoea
  std::uint32_t faults = kInfantFaultNone;
};

InfantState start(const Infant& infant) noexcept;

/// dt_s (s; up to 0.1) of the infant's life. It takes inner steps of kMonitorStep; breaths count in their tick.
InfantSigns step(const Infant& infant, InfantState& state, const InfantInput& input, double dt_s) noexcept;

}  // namespace vallecula::engine

// One attempt at a scenario: what its variation leaves open, drawn from a seed.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "curricula/scenario.h"
#include "curricula/schema/safe_yaml.h"

namespace vallecula::curricula {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers on every machine, unlike std's distributions.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// What is drawn. Each has a number of its own, so that one more range in a file leaves the others' values as they
/// were.
enum Drawn : std::uint64_t {
  kInfant = 1,
  kManikinSeed,
  kMouthOpening,
  kTongueSize,
  kLarynxHeight,
  kEpiglottisLength,
  kTongueYoung,
  kSecretions,
  kInfantSeed,
  kDistractionDelay
};

std::uint64_t draw(std::uint64_t seed, Drawn what) { return mixed(mixed(seed) ^ what); }

/// A seed that does not stand for "unvaried".
std::uint32_t other_seed(std::uint64_t drawn) { return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(drawn)); }

/// In whole `step`s, so that a trainer can read and repeat it.
double within(const std::array<double, 2>& range, double step, std::uint64_t drawn) {
  const double value = range[0] + (range[1] - range[0]) * static_cast<double>(drawn >> 11) * 0x1.0p-53;
  return std::clamp(std::round(value / step) * step, range[0], range[1]);
}

void write(YAML::Node group, const char* field, double value) {
  std::array<char, 32> digits{};  // the shortest that reads back as the same number, but without 0.1 + 0.2's tail
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 12).ptr;
  group[field] = std::string(digits.data(), end);
}

/// Infant 0 is the scenario's own; the others are the same whatever attempt they come up in, so that each is made once.
void write_infant(YAML::Node manikin, const Scenario& scenario, std::uint64_t number) {
  if (number == 0) return;
  const Variation& v = *scenario.variation;
  const std::uint64_t of_infant = mixed(scenario.manikin.seed) + number;
  manikin["seed"] = other_seed(draw(of_infant, kManikinSeed));
  const auto shape = [&](const char* field, const Variation::Range& range, double step, Drawn what) {
    if (range) write(manikin, field, within(*range, step, draw(of_infant, what)));
  };
  shape("mouth_opening", v.mouth_opening, 0.01, kMouthOpening);
  shape("tongue_size", v.tongue_size, 0.01, kTongueSize);
  shape("larynx_height_mm", v.larynx_height_mm, 0.1, kLarynxHeight);
  shape("epiglottis_length", v.epiglottis_length, 0.01, kEpiglottisLength);
}

}  // namespace

Scenario attempt_of(const Scenario& scenario, Mode mode, std::uint32_t seed, const ToolChoice& taken) {
  if (!rules_of(mode).variation || !scenario.variation) seed = 0;
  YAML::Node node = parse_safely(scenario.yaml, "scenario " + scenario.id);
  node["attempt"] = YAML::Node();
  node["attempt"]["mode"] = name_of(mode);
  node["attempt"]["seed"] = seed;
  if (!taken.blade.empty()) node["attempt"]["blade"] = taken.blade;
  if (!taken.tube.empty()) node["attempt"]["tube"] = taken.tube;
  if (!rules_of(mode).assistance)
    for (const char* help : {"ghost_path", "glottis_highlight", "cut_view", "force_bar", "video_view", "expert_loop"})
      node["assistance"][help] = "false";
  if (seed != 0) {
    const Variation& v = *scenario.variation;
    write_infant(node["manikin"], scenario, draw(seed, kInfant) % static_cast<std::uint64_t>(v.infants));
    if (v.tongue_young_pa) write(node, "tongue_young_pa", within(*v.tongue_young_pa, 10.0, draw(seed, kTongueYoung)));
    if (v.secretions_ml)
      write(node["intubation"], "secretions_ml", within(*v.secretions_ml, 0.01, draw(seed, kSecretions)));
    if (v.infant_seed) node["intubation"]["infant_seed"] = other_seed(draw(seed, kInfantSeed));
    if (v.distraction_delay_s) {
      const double delay = within(*v.distraction_delay_s, 0.1, draw(seed, kDistractionDelay));
      for (std::size_t i = 0; i < scenario.distractions.size(); ++i)
        write(node["distractions"][i], "at_s", scenario.distractions[i].at_s + delay);
    }
  }
  return parse_scenario(YAML::Dump(node) + "\n", "attempt at " + scenario.id);
}

}  // namespace vallecula::curricula

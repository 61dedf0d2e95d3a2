// A curriculum and its scenarios, as validated from YAML.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "curricula/intubation_spec.h"

namespace vallecula::curricula {

/// file, line, field, value, what was expected.
class CurriculumError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The manikin a scenario asks for when no other patient is chosen.
struct ManikinSpec {
  double weight_kg = 3.2;
  unsigned seed = 1;
};

struct Targets {                      ///< training targets, never injury limits
  double tongue_force_n = 5.0;
  double gum_force_n = 2.0;
};

struct PassLimits {                   ///< thresholds of the rubric
  double peak_tongue_force_n = 0.0;
  double peak_gum_force_n = 0.0;
  double glottis_visible_percent = 0.0;   ///< must be reached at least once
  double attempt_time_s = 30.0;
  double time_over_target_s = 0.0;
  double time_over_device_limit_s = 0.0;
};

struct Scenario {
  std::string id;
  std::string title;
  std::string briefing;
  std::string debriefing;
  ManikinSpec manikin;
  std::string blade;                  ///< "miller-00", "miller-0", "miller-1", "miller-2", "miller-3"
  double tongue_young_pa = 0.0;       ///< 0: the package's own
  double sight_percent = 25.0;        ///< glottis counts as in sight from here on
  double max_attempt_s = 60.0;        ///< the trial ends by itself
  Targets targets;
  PassLimits pass;
  std::optional<IntubationSpec> intubation;  ///< none: laryngoscopy alone
  std::string yaml;                   ///< this scenario's own text, kept in the trial log
};

struct Curriculum {
  int schema = 1;
  std::string id;
  std::string title;
  std::filesystem::path file;
  std::vector<Scenario> scenarios;
  const Scenario* find(const std::string& id) const;
};

Curriculum load_curriculum(const std::filesystem::path& file);      ///< throws CurriculumError
Scenario parse_scenario(const std::string& yaml, const std::string& name_for_errors);  ///< throws CurriculumError

}  // namespace vallecula::curricula

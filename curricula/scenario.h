// A curriculum and its scenarios, as validated from YAML.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "curricula/intubation_spec.h"
#include "curricula/mode.h"
#include "curricula/module.h"
#include "curricula/text.h"

namespace vallecula::curricula {

/// One mistake in a curriculum's text.
struct Problem {
  int line = 0;                        ///< from 1; 0: of the whole text
  std::string field, value, allowed;   ///< empty where the text is no YAML
  std::string message;                 ///< a sentence, without the file's name
};

/// file, line, field, value, what was expected.
class CurriculumError : public std::runtime_error {
 public:
  explicit CurriculumError(const std::string& message, Problem problem = {})
      : std::runtime_error(message), problem_(std::move(problem)) {
    if (problem_.message.empty()) problem_.message = message;
  }
  const Problem& problem() const { return problem_; }

 private:
  Problem problem_;
};

/// The manikin a scenario asks for when no other patient is chosen.
struct ManikinSpec {
  double weight_kg = 3.2;
  unsigned seed = 1;
  // Not given: what the seed draws, or the usual for the weight.
  std::optional<double> gestation_weeks{};    ///< sets the way from the cords to the carina
  std::optional<double> mouth_opening{};      ///< factor on the usual, 22 mm between the gums at term
  std::optional<double> tongue_size{};        ///< factor on its width and height
  std::optional<double> larynx_height_mm{};   ///< to the head; in a term infant, a smaller one's is as much smaller
  std::optional<double> epiglottis_length{};  ///< factor
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

/// What a pass limit is worth, and where it comes from. None is validated.
struct PassMark {
  double weight = 1.0;
  std::string source;
};

/// Helps on the screen.
struct Assistance {
  bool ghost_path = false;         ///< the expert's way as a grey blade
  bool glottis_highlight = false;
  bool cut_view = true;
  bool force_bar = true;
  bool video_view = true;   ///< the camera at the blade's tip
  bool expert_loop = true;  ///< an expert's hands at this patient, while the trial waits
};

/// The dual task: what happens beside the hands.
struct Distraction {
  enum class Kind { question, alarm, talk };
  double at_s = 0.0;  ///< trial time
  Kind kind = Kind::talk;
  Text text;
  std::vector<Text> answers;   ///< of a question
  int right_answer = 0;        ///< counted from 1; 0: no question
  double time_allowed_s = 0.0; ///< to answer, or to silence the alarm; 0: talk asks for nothing
};

/// What changes from attempt to attempt; see attempt_of.
struct Variation {
  using Range = std::optional<std::array<double, 2>>;  ///< from, to
  int infants = 1;
  Range mouth_opening, tongue_size, larynx_height_mm, epiglottis_length;  ///< of the infants
  Range tongue_young_pa, secretions_ml, distraction_delay_s;
  bool infant_seed = false;
};

/// Written by a trial: what it was drawn from.
struct AttemptOrigin {
  Mode mode = Mode::practice;
  std::uint32_t seed = 0;  ///< 0: everything as written
  std::string right_blade, right_tube;  ///< where the trainee chose; then blade and tube are what was taken
};

/// What a trainee takes of what is offered; empty: the right one, without a choice.
struct ToolChoice {
  std::string blade, tube;
};

struct Scenario {
  std::string id;
  std::string title;
  Text briefing;
  Text debriefing;
  std::vector<std::string> after;     ///< modules to be mastered before this scenario opens
  ManikinSpec manikin;
  std::string blade;                  ///< "miller-00", "miller-0", "miller-1", "miller-2", "miller-3"
  std::vector<std::string> offered_blades;  ///< to choose from; none: no choice
  double tongue_young_pa = 0.0;       ///< 0: the package's own
  double sight_percent = 25.0;        ///< glottis counts as in sight from here on
  double max_attempt_s = 60.0;        ///< the trial ends by itself
  Targets targets;
  PassLimits pass;
  std::optional<IntubationSpec> intubation;  ///< none: laryngoscopy alone
  std::map<std::string, PassMark> rubric;    ///< by the name of the field in pass or intubation.pass
  Assistance assistance;
  std::vector<Distraction> distractions;     ///< by growing time
  std::optional<Variation> variation;
  AttemptOrigin attempt;
  std::string yaml;                   ///< this scenario's own text, kept in the trial log
};

struct Curriculum {
  int schema = 2;                     ///< as written in the file; a file of schema 1 is one module
  std::string id;
  std::string title;
  std::vector<Text> goals;
  std::filesystem::path file;
  std::vector<Module> modules;        ///< each scenario belongs to one
  std::vector<Scenario> scenarios;
  const Scenario* find(const std::string& id) const;
  const Module* module_of(const std::string& scenario_id) const;  ///< null: there is no such scenario
};

Curriculum load_curriculum(const std::filesystem::path& file);      ///< throws CurriculumError
/// Everything that is wrong with a curriculum's text, in the file's order; empty: it loads. What two fields have to do
/// with each other is looked at once each by itself is right.
std::vector<Problem> problems_of(const std::string& text);
Scenario parse_scenario(const std::string& yaml, const std::string& name_for_errors);  ///< throws CurriculumError

/// One attempt at a scenario: what its variation leaves open is drawn from `seed`, the same for the same seed on every
/// machine, and written into the scenario and its text; seed 0 draws nothing. In assessment nothing is drawn whatever
/// the seed, and every help is off. `taken` must be offered; throws CurriculumError where it is not.
Scenario attempt_of(const Scenario& scenario, Mode mode, std::uint32_t seed, const ToolChoice& taken = {});

}  // namespace vallecula::curricula

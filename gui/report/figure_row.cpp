#include "gui/report/figure_row.h"

#include <QString>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

/// A limit as the scenario has it.
std::string as_written(double limit) { return QString::number(limit, 'g', 6).toStdString(); }

}  // namespace

const char* verdict(const curricula::Score& score) {
  if (score.set_aside.empty()) return score.passed ? "Passed" : "Not passed";
  return score.at_vallecula ? "Practice with help: not counted for the course"
         : score.no_attempt ? "No attempt: not counted for the course"
                            : "Changed by the instructor: not counted for the course";
}

std::string escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped().toStdString(); }

std::string in_page(const std::string& text) { return in_words(text).toHtmlEscaped().toStdString(); }

std::string number(double value, int digits) {
  return QString::number(value, 'f', digits).toStdString();  // printf has 72.5 % as 72
}

Row row(const curricula::Score& score, const std::string& name, const std::string& value, const std::string& criterion,
        const std::string& demand) {
  for (const curricula::Criterion& line : score.criteria) {
    if (line.name != criterion) continue;
    return {name, value, demand + " " + as_written(line.limit) + (line.unit.empty() ? "" : " " + line.unit),
            line.met ? "met" : "missed"};
  }
  return {name, value, "", ""};
}

Row limit_row(const curricula::Score& score, const std::string& name, const std::string& value,
              const std::string& criterion, double limit, const char* unit) {
  const Row judged = row(score, name, value, criterion, "at most");
  if (!judged.verdict.empty() || score.attempt_begun) return judged;
  return {name, value, "not judged: no attempt; at most " + as_written(limit) + " " + unit, ""};
}

Row tube_force_row(const curricula::Score& score, const curricula::Scenario& scenario, const std::string& name,
                   const std::string& value) {
  const auto limit = scenario.intubation ? scenario.intubation->pass.tube_force_n : std::nullopt;
  Row line = limit ? limit_row(score, name, value, "tube_force_n", *limit, "N") : Row{name, value, "", ""};
  line.about =
      "Along the tube, against what stands before its tip: closed cords, or the cricoid, the narrowest ring below them";
  return line;
}

Row attempt_row(const curricula::Score& score, const curricula::Scenario& scenario, const std::string& name) {
  if (score.at_vallecula) return {"Times", "not counted", "begun at the vallecula", ""};
  const std::string time = number(score.attempt_time_s, 1) + " s",
                    most = "at most " + as_written(scenario.pass.attempt_time_s) + " s";
  if (score.mouth_unknown) return {name, "not timed", "where the mouth begins is not known", ""};
  if (!score.attempt_begun) return {name, no_attempt(name).value, no_attempt(name).limit + "; " + most, ""};
  return row(score, name, time, "attempt_time_s", "at most");
}

Row no_attempt(const std::string& name) { return {name, "no attempt", "the blade did not enter the mouth", ""}; }

Row attempts_row(const curricula::Score& score) {
  const std::string name = "Attempts";
  if (score.mouth_unknown) return {name, "not counted", "where the mouth begins is not known", ""};
  const std::size_t attempts = score.intubation->attempts.size();
  return attempts == 0 ? no_attempt(name) : row(score, name, std::to_string(attempts), "attempts", "at most");
}

Row lips_row(const curricula::IntubationScore& tube) {
  const std::string name = "Tube's mark at the lips",
                    rule = "scenario's weight + 6: " + number(100.0 * tube.lips_rule_m, 1) + " cm, a help";
  return {name, tube.at_lips_m ? number(100.0 * *tube.at_lips_m, 1) + " cm" : std::string("not in the mouth"), rule,
          ""};
}

std::string force(double peak_n, double at_s) {
  return number(peak_n, 2) + " N" + (peak_n > 0.0 ? ", at " + number(at_s, 1) + " s" : "");
}

}  // namespace vallecula::gui

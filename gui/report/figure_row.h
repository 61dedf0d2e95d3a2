// Figures beside what they were judged by, for the report.
#pragma once

#include <string>

#include "curricula/score/score.h"

namespace vallecula::gui {

struct Row {
  std::string name, value, limit, verdict;  ///< verdict: "met", "missed", "" where nothing was demanded
  std::string about = {};                   ///< a sentence for who wonders what it is; "": its name says it
};

/// `criterion`: the rubric's name of this figure, which says whether it was met; none: nothing is demanded of it.
Row row(const curricula::Score& score, const std::string& name, const std::string& value, const std::string& criterion,
        const std::string& demand);

/// Of a limit that the hand keeps ("at most 6.8 N"): of a trial without an attempt that nothing was judged by it.
Row limit_row(const curricula::Score& score, const std::string& name, const std::string& value,
              const std::string& criterion, double limit, const char* unit);

/// The same of the force at the tube's tip, where the scenario has a limit of it.
Row tube_force_row(const curricula::Score& score, const curricula::Scenario& scenario, const std::string& name,
                   const std::string& value);

/// The attempt's time (of several the longest) with the scenario's limit beside it. Of a trial begun at the vallecula,
/// which has no time of a whole attempt, one line that no time is counted.
Row attempt_row(const curricula::Score& score, const curricula::Scenario& scenario, const std::string& name);

/// Of a figure that only an attempt has, where there was none.
Row no_attempt(const std::string& name);
/// Of a trial with an intubation: how many, judged as the rubric does; of none it says so, and no limit is kept.
Row attempts_row(const curricula::Score& score);
/// The centimetres that a team is told, beside what the rule by weight says: a help, no limit.
Row lips_row(const curricula::IntubationScore& tube);

/// "Passed", "Not passed"; of a trial that was set aside that it is not counted, and why in a word or two.
const char* verdict(const curricula::Score& score);
std::string escaped(const std::string& text);  ///< for HTML
std::string in_page(const std::string& text);  ///< in the window's language (in_words), for HTML
/// Halves away from zero, as the window's live figures and the scores' sentences have them.
std::string number(double value, int digits);
std::string force(double peak_n, double at_s);  ///< "1.50 N, at 3.2 s"

}  // namespace vallecula::gui

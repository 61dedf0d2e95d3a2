#include "gui/report/figure_row.h"

#include <QString>
#include <cstdio>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

const char* verdict(const curricula::Score& score) {
  if (score.set_aside.empty()) return score.passed ? "Passed" : "Not passed";
  return score.at_vallecula ? "Practice with help: not counted for the course"
                            : "Changed by the instructor: not counted for the course";
}

std::string escaped(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped().toStdString(); }

std::string in_page(const std::string& text) { return in_words(text).toHtmlEscaped().toStdString(); }

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

Row row(const curricula::Score& score, const std::string& name, const std::string& value, const std::string& criterion,
        const std::string& demand) {
  for (const curricula::Criterion& line : score.criteria) {
    if (line.name != criterion) continue;
    const bool fine = line.unit == "N" || line.unit == "s";  // counts, percents and rates are whole
    return {name, value, demand + " " + number(line.limit, fine ? 2 : 0) + (line.unit.empty() ? "" : " " + line.unit),
            line.met ? "met" : "missed"};
  }
  return {name, value, "", ""};
}

Row no_attempt(const std::string& name) { return {name, "no attempt", "the blade did not enter the mouth", ""}; }

std::string force(double peak_n, double at_s) {
  return number(peak_n, 2) + " N" + (peak_n > 0.0 ? ", at " + number(at_s, 1) + " s" : "");
}

}  // namespace vallecula::gui

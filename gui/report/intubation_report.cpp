#include "gui/report/intubation_report.h"

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

namespace {

std::string seconds_or(const std::optional<double>& time_s, const char* otherwise) {
  return time_s ? number(*time_s, 1) + " s" : otherwise;
}

std::string millimetres(double m) { return number(1e3 * m, 1) + " mm"; }

std::string at(double time_s) { return ", at " + number(time_s, 1) + " s"; }

std::string count(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::string depth(const curricula::IntubationScore& i) {
  if (!i.depth_m && i.outcome == curricula::Outcome::mainstem) return "in " + curricula::bronchus_in_words(i);
  if (!i.depth_m) return "not in larynx or trachea";
  std::string text = millimetres(*i.depth_m) + " past the cords, " + number(100.0 * *i.depth_share(), 0) + " % of " +
                     millimetres(i.cords_to_carina_m) + " to the carina";
  if (i.depth_neutral_m)
    text += "; about " + millimetres(*i.depth_neutral_m) + ", " + number(100.0 * *i.depth_neutral_share(), 0) +
            " %, with the head neutral (assumed)";
  return text;
}

std::string detector(const curricula::IntubationScore& i) {
  if (i.co2_confirmed) return "yellow with breath " + std::to_string(*i.co2_breaths);
  return "not yellow, " + count(static_cast<std::size_t>(i.breaths_in_place), "breath") + " through the tube";
}

/// "cricoid 2.5 N, cords 1.7 N": what was touched at all, in the order of the way in.
std::string loads(const curricula::IntubationScore& i) {
  std::string text;
  for (int part = 0; part < curricula::kTubeLoads; ++part) {
    const curricula::Peak& peak = i.loads_n[static_cast<std::size_t>(part)];
    if (peak.value <= 0.0) continue;
    text += (text.empty() ? "" : ", ") + std::string(name_of(static_cast<curricula::LoggedTubeLoad>(part))) + " " +
            number(peak.value, 1) + " N";
  }
  return text.empty() ? "nothing touched" : text;
}

Row outcome(const curricula::Score& score, const curricula::Scenario& scenario) {
  Row line = row(score, "Outcome", words_of(score.intubation->outcome), "outcome", "");
  line.limit.clear();
  if (!scenario.intubation) return line;
  for (const curricula::Outcome accepted : scenario.intubation->pass.outcomes)
    line.limit += (line.limit.empty() ? "" : " or ") + words_of(accepted);
  return line;
}

}  // namespace

std::string intubation_sentence(const curricula::Score& score, const curricula::Scenario& scenario) {
  const curricula::IntubationScore& i = *score.intubation;
  std::string text = in_words(verdict(score)).toStdString() + " (" + course_words(scenario.title).toStdString() +
                     "): " + in_words(outcome_in_words(i)).toStdString() + ". ";
  if (i.attempts.empty()) return text + in_words("The blade never entered the mouth.").toStdString();
  text += in_words(score.at_vallecula
                       ? "Begun at the vallecula"
                       : count(i.attempts.size(), "attempt") + (i.attempts.size() == 1 ? " of " : ", the longest of ") +
                             number(score.attempt_time_s, 1) + " s")
              .toStdString();
  if (i.lowest_spo2_percent && i.lowest_heart_per_min)
    text += ", " + in_words("lowest saturation " + curricula::told_spo2(*i.lowest_spo2_percent) +
                            " %, lowest heart rate " + number(*i.lowest_heart_per_min, 0) + " per minute")
                       .toStdString();
  return text + ", " +
         in_words("with at most " + number(score.peak_tongue_force_n, 1) + " N on the tongue and " +
                  number(i.tip_load_n.value, 1) + " N along the tube.")
             .toStdString();
}

std::vector<Row> intubation_rows(const curricula::Score& score, const curricula::Scenario& scenario) {
  const curricula::IntubationScore& i = *score.intubation;
  const curricula::Attempt* decisive = i.decisive();
  const auto lowest = [&](const std::string& name, const std::optional<double>& value, const std::string& told,
                          double at_s, const std::string& criterion) {
    return value ? row(score, name, told + at(at_s), criterion, "at least") : no_attempt(name);
  };
  std::string against;
  if (i.tip_against < curricula::kTubeLoads)
    against = std::string(" (") + name_of(static_cast<curricula::LoggedTubeLoad>(i.tip_against)) + ")";
  std::vector<Row> rows = {
      outcome(score, scenario),
      {"Tip's depth", depth(i), "", ""},
      lips_row(i),
      attempts_row(score),
  };
  if (!score.at_vallecula) {
    rows.push_back({"Time to view, blade in to glottis in sight",
                    seconds_or(decisive ? decisive->time_to_view_s : std::nullopt, "never"), "", ""});
    rows.push_back(row(score, "Time to pass, view to cords passed",
                       seconds_or(decisive ? decisive->time_to_pass_s : std::nullopt,
                                  i.passed_untimed() ? "passed before the blade was in" : "never"),
                       "time_to_pass_s", "at most"));
  }
  rows.insert(rows.end(),
              {
                  lowest("Lowest saturation, displayed", i.lowest_spo2_percent,
                         curricula::told_spo2(i.lowest_spo2_percent.value_or(0.0)) + " %", i.lowest_spo2_at_s,
                         "lowest_spo2_percent"),
                  lowest("Lowest heart rate", i.lowest_heart_per_min,
                         number(i.lowest_heart_per_min.value_or(0.0), 0) + " per minute", i.lowest_heart_at_s,
                         "lowest_heart_per_min"),
                  row(score, "CO2 detector", detector(i), "co2_confirmed", "yellow by breath"),
                  tube_force_row(score, scenario, "Peak force along the tube, at its tip",
                                 force(i.tip_load_n.value, i.tip_load_n.at_s) + against),
                  {"Peak force on the tube's hand", force(i.hand_force_n.value, i.hand_force_n.at_s), "", ""},
                  {"Tube's peak push on each part, summed all round", loads(i),
                   "no limit: what presses on the tube from all sides there, together; the cricoid is the narrowest "
                   "ring, below the cords",
                   ""},
                  {"Breaths given, mask and tube", std::to_string(i.breaths_given), "", ""},
              });
  if (i.oesophagus_entries > 0)
    rows.push_back({"Tip in the oesophagus",
                    count(static_cast<std::size_t>(i.oesophagus_entries), "time") + ", " +
                        count(static_cast<std::size_t>(i.oesophagus_breaths), "breath") + " given there" +
                        (i.oesophagus_breaths > 0 ? ", " + number(i.oesophagus_s, 1) + " s until withdrawn" : "") +
                        (i.recognised_late ? ": recognised late" : ""),
                    "", ""});
  if (i.secretions_start_ml > 0.0)
    rows.push_back({"Secretions",
                    number(i.secretions_start_ml, 1) + " ml, at the end " + number(i.secretions_end_ml, 1) + " ml", "",
                    ""});
  return rows;
}

std::string attempts_html(const curricula::Score& score) {
  const std::vector<curricula::Attempt>& attempts = score.intubation->attempts;
  if (attempts.empty()) return "";
  std::string html = "<h2>" + in_page("Attempts") + "</h2>\n<table>\n<tr><th></th>";
  for (const char* column : {"From, to (s)", "Took", "Breaths before", "To view", "To pass",
                             "Saturation, before and lowest", "Lowest heart"})
    html += "<th>" + in_page(column) + "</th>";
  html += "</tr>\n";
  const auto timed = [&](const std::optional<double>& time_s) {
    return score.at_vallecula ? std::string("not counted") : seconds_or(time_s, "never");
  };
  for (std::size_t n = 0; n < attempts.size(); ++n) {
    const curricula::Attempt& a = attempts[n];
    html += "<tr><td>" + std::to_string(n + 1) + "</td><td>" + in_page(number(a.start_s, 1)) + ", " +
            in_page(number(a.end_s, 1)) + "</td><td class=\"figure\">" + in_page(timed(a.time_s)) + "</td><td>" +
            std::to_string(a.breaths_before) + "</td><td>" + in_page(timed(a.time_to_view_s)) + "</td><td>" +
            in_page(timed(a.time_to_pass_s)) + "</td><td>" +
            in_page(curricula::told_spo2(a.highest_spo2_before_percent) + " %") + ", " +
            in_page(curricula::told_spo2(a.lowest_spo2_percent) + " %") +
            (a.desaturated ? ": " + in_page("severe desaturation") : "") + "</td><td>" +
            in_page(number(a.lowest_heart_per_min, 0) + " per minute") +
            (a.bradycardia ? ": " + in_page("bradycardia") : "") + "</td></tr>\n";
  }
  return html + "</table>\n<p class=\"foot\">" +
         in_page(
             "An attempt is one way of the blade into the mouth and out. Its lowest values count until the next one "
             "begins, for the display is late. Severe desaturation: " +
             number(curricula::kSevereDesaturation, 0) + " points or more. Bradycardia: below " +
             number(curricula::kBradycardia, 0) + " per minute (both NEAR4NEOS).") +
         "</p>\n";
}

}  // namespace vallecula::gui

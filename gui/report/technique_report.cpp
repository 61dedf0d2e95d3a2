#include "gui/report/technique_report.h"

#include <cmath>

#include "curricula/score/points.h"

namespace vallecula::gui {

namespace {

std::string in_mm(double m) { return number(1e3 * m, 1) + " mm"; }
std::string at_time(double time_s) { return time_s < 0.0 ? "" : ", at " + number(time_s, 1) + " s"; }

std::string side(double left_m) { return in_mm(std::fabs(left_m)) + (left_m > 0.0 ? " to the left" : " to the right"); }

void add_view(const curricula::Score& score, std::vector<Row>& rows) {
  const curricula::ViewFigures& view = score.view;
  const auto grade = curricula::cormack_lehane(score.glottis_visible_max_percent);
  rows.push_back(
      {"Cormack-Lehane grade at best", grade ? std::to_string(*grade) : "3 or 4: nothing of the glottis seen", "", ""});
  rows.push_back({"Glottis seen on average, while in sight",
                  view.mean_percent ? number(*view.mean_percent, 0) + " %" : "never", "", ""});
  if (score.at_vallecula) return;
  rows.push_back(
      {"Time to a stable view (" + number(curricula::kStableViewS, 0) + " s in one piece)",
       view.time_to_stable_s ? number(*view.time_to_stable_s, 1) + " s" + at_time(view.stable_at_s) : "never", "", ""});
}

void add_force(const curricula::ForceFigures& force, std::vector<Row>& rows) {
  if (force.mean_tongue_n)
    rows.push_back({"Force on the tongue, mean and over time",
                    number(*force.mean_tongue_n, 1) + " N, " + number(force.tongue_integral_ns, 1) + " N s in " +
                        number(force.tongue_contact_s, 1) + " s",
                    "", ""});
  if (const auto& pressed = force.tongue_pressure_pa)
    rows.push_back({"Peak pressure on the tongue, over the contact",
                    number(1e-3 * pressed->value, 1) + " kPa" + at_time(pressed->at_s), "", ""});
  if (!force.lift_share) return;
  std::string levered = number(100.0 * *force.lift_share, 0) + " % lifted";
  if (force.levered_n.at_s >= 0.0)
    levered += ", at most " + number(force.levered_n.value, 1) + " N levered" + at_time(force.levered_n.at_s);
  rows.push_back({"Lifted, not levered on the upper jaw", levered, "", ""});
}

void add_blade(const curricula::Score& score, std::vector<Row>& rows) {
  const curricula::BladeFigures& blade = score.blade;
  if (!blade.to_vallecula_m) return;
  if (blade.entry_left_m) rows.push_back({"Blade in, from the midline", side(*blade.entry_left_m), "", ""});
  rows.push_back({"Blade's tip, nearest to the vallecula",
                  in_mm(*blade.to_vallecula_m) + at_time(blade.to_vallecula_at_s) +
                      (blade.vallecula_reached ? ": reached" : ": not reached"),
                  "", ""});
  if (blade.left_m) rows.push_back({"Blade's tip then, from the midline", side(*blade.left_m), "", ""});
  rows.push_back(
      {"Blade's tip beyond the vallecula",
       blade.past_vallecula_m > 0.0 ? in_mm(blade.past_vallecula_m) + at_time(blade.past_vallecula_at_s) : "never", "",
       ""});
  rows.push_back({"Way of the blade's tip", number(1e2 * score.motion.tip_path_m, 0) + " cm", "", ""});
}

std::string count(int n, const std::string& what) { return std::to_string(n) + " " + what; }

void add_dual_task(const curricula::DualTask& task, std::vector<Row>& rows) {
  rows.push_back({"Questions and alarms",
                  count(task.right, "right") + ", " + count(task.wrong, "wrong") + ", " + count(task.missed, "missed") +
                      (task.false_answers > 0 ? ", " + count(task.false_answers, "answered to nothing") : ""),
                  "", ""});
  if (task.mean_reaction_s)
    rows.push_back({"Reaction to them, on average", number(*task.mean_reaction_s, 1) + " s", "", ""});
}

void add_help(const char* name, const curricula::Use& use, std::vector<Row>& rows) {
  if (use.times > 0)
    rows.push_back({name, count(use.times, use.times == 1 ? "time" : "times") + ", " + number(use.for_s, 1) + " s in all, first at " +
                              number(use.first_s, 1) + " s",
                    "", ""});
}

std::string when(double at_s) { return at_s < 0.0 ? "" : in_page(number(at_s, 1) + " s"); }

}  // namespace

std::vector<Row> technique_rows(const curricula::Score& score) {
  std::vector<Row> rows;
  add_view(score, rows);
  add_force(score.force, rows);
  add_blade(score, rows);
  if (score.intubation)
    if (const auto error_m = score.intubation->depth_error_m())
      rows.push_back({"Tube's depth, from the middle of the good third",
                      in_mm(std::fabs(*error_m)) + (*error_m > 0.0 ? " deeper" : " shallower"), "", ""});
  if (score.dual_task) add_dual_task(*score.dual_task, rows);
  add_help("Own head moved aside", score.eye_moves, rows);
  add_help("Head extended by an assistant", score.extension, rows);
  add_help("Shown an expert, or told a line by the instructor", score.aided, rows);
  return rows;
}

std::string checklist_html(const curricula::Score& score) {
  std::string html = "<h2>" + in_page("Checklist") + "</h2>\n<table>\n<tr><th>" + in_page("Item") + "</th><th>" +
                     in_page("Done") + "</th><th>" + in_page("At") + "</th><th>" + in_page("Why") + "</th></tr>\n";
  for (const curricula::ChecklistItem& one : score.checklist) {
    using Done = curricula::ChecklistItem::Done;
    const char* shade = one.done == Done::yes ? "met" : one.done == Done::no ? "missed" : "";
    html += "<tr><td>" + in_page(one.text) + "</td><td class=\"" + shade + "\">" + in_page(name_of(one.done)) +
            "</td><td>" + when(one.at_s) + "</td><td>" + in_page(one.sentence) + "</td></tr>\n";
  }
  html += "</table>\n<p class=\"foot\">" +
          in_page("What the log has not seen is left to the instructor. The items are not validated.") + "</p>\n";
  html += "<p>" + in_page("Global rating, by a person:");
  for (std::size_t i = 0; i < curricula::kGlobalRatingWords.size(); ++i)
    html += " &#9744; " + std::to_string(i + 1) + " " + in_page(curricula::kGlobalRatingWords[i]);
  return html + "</p>\n";
}

std::string points_html(const curricula::Score& score, const curricula::Scenario& scenario) {
  const std::vector<curricula::MarkPoints> points = points_of(score, scenario);
  if (points.empty()) return "";
  double earned = 0.0;
  std::string lines;
  for (const curricula::MarkPoints& one : points) {
    earned += one.earned;
    lines += "<tr><td class=\"figure\">" + in_page(number(one.earned, 1) + " of " + number(one.of, 1)) + "</td><td>" +
             when(one.at_s) + "</td><td>" + in_page(one.sentence) + "</td><td>" + in_page(one.source) + "</td></tr>\n";
  }
  return "<h2>" + in_page("Points: " + number(earned, 0) + " of 100") + "</h2>\n<table>\n<tr><th>" + in_page("Points") +
         "</th><th>" + in_page("At") + "</th><th>" + in_page("Why") + "</th><th>" + in_page("Limit by") +
         "</th></tr>\n" + lines + "</table>\n<p class=\"foot\">" +
         in_page("Points inform; what fails a trial is the mark, whatever its weight.") + "</p>\n";
}

std::vector<std::string> points_lines(const curricula::Score& score, const curricula::Scenario& scenario) {
  std::vector<std::string> lines;
  double earned = 0.0;
  for (const curricula::MarkPoints& one : points_of(score, scenario)) {
    earned += one.earned;
    lines.push_back(number(one.earned, 1) + " of " + number(one.of, 1) + ": " + one.sentence + " (" + one.source + ")");
  }
  if (!lines.empty()) lines.insert(lines.begin(), "points " + number(earned, 0) + " of 100");
  return lines;
}

}  // namespace vallecula::gui

#include "gui/report/pdf_report.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>
#include <tuple>

#include "curricula/score/points.h"
#include "gui/records_pages/curve_reading.h"
#include "gui/records_pages/known_courses.h"
#include "gui/records_pages/tables.h"
#include "gui/report/advice.h"
#include "gui/report/curve_chart.h"
#include "gui/report/force_chart.h"
#include "gui/report/intubation_report.h"
#include "gui/report/monitor_chart.h"
#include "gui/report/pdf_pages.h"
#include "gui/report/report.h"
#include "gui/session/curricula_files.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

using Cells = std::vector<std::string>;

/// A table with a heading in the sources' English; cells are HTML.
std::string table(const Cells& head, const std::vector<Cells>& rows) {
  std::string html = "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"3\"><thead><tr bgcolor=\"#dfe6ea\">";
  for (const std::string& cell : head) html += "<th align=\"left\">" + in_page(cell) + "</th>";
  html += "</tr></thead>";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    html += i % 2 == 0 ? "<tr>" : "<tr bgcolor=\"#f5f7f8\">";
    for (const std::string& cell : rows[i]) html += "<td>" + cell + "</td>";
    html += "</tr>";
  }
  return html + "</table>";
}

std::string heading(const std::string& text) { return "<h3>" + in_page(text) + "</h3>"; }

std::string heading_on_new_page(const std::string& text) {
  return "<h3 style=\"page-break-before:always\">" + in_page(text) + "</h3>";
}

/// As people know it; the id where the course is not here.
std::string title_of(const KnownCourses& courses, const std::string& course, const std::string& scenario = {}) {
  return (scenario.empty() ? courses.title(course) : courses.title(course, scenario)).toHtmlEscaped().toStdString();
}

std::string verdict(const std::string& word) {
  if (word.empty()) return "";
  return word == "met" ? "<span style=\"color:#00795a\">" + in_page(word) + "</span>"
                       : "<b style=\"color:#b34f00\">" + in_page(word) + "</b>";
}

/// What was set aside has neither colour.
std::string box(const curricula::Score& score, const std::string& text) {
  const char* colour = !score.set_aside.empty() ? "#0072B2" : score.passed ? "#009E73" : "#D55E00";
  return std::string("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"7\"><tr><td width=\"6\" bgcolor=\"") +
         colour + "\"></td><td bgcolor=\"#f6f4ec\">" + text + "</td></tr></table>";
}

std::string picture(const std::string& name) {
  return "<p><img src=\"" + name + "\" width=\"" + std::to_string(kPdfWidthPx) + "\"></p>";
}

std::string points_table(const curricula::Score& score, const curricula::Scenario& scenario) {
  std::vector<Cells> rows;
  double earned = 0.0;
  for (const curricula::MarkPoints& mark : points_of(score, scenario)) {
    earned += mark.earned;
    rows.push_back(
        {in_page(mark.sentence), in_page(number(mark.earned, 0) + " of " + number(mark.of, 0)), in_page(mark.source)});
  }
  if (rows.empty()) return "";
  return heading("Points: " + number(earned, 0) + " of 100") +
         table({"Mark", "Points", "Where the mark comes from"}, rows);
}

/// "2026-05-03 10:20".
std::string minute(const std::string& utc) {
  std::string text = utc.substr(0, 16);
  std::replace(text.begin(), text.end(), 'T', ' ');
  return text;
}

std::string outcome(const curricula::RecordRow& row) {
  return row.score.intubation ? in_page(words_of(row.score.intubation->outcome)) : "";
}

/// Curriculum, scenario, device kind.
using CurveOf = std::tuple<std::string, std::string, std::string>;

}  // namespace

void write_trial_pdf(const std::filesystem::path& file, const curricula::TrialLog& log, const std::string& name) {
  const curricula::Scenario scenario = curricula::parse_scenario(log.header.scenario_yaml, file.string());
  const curricula::Score score = curricula::score_trial(log, scenario);
  PdfPages pages;
  pages.title = QCoreApplication::translate("Report", "Trial: %1").arg(course_words(scenario.title));
  pages.person = QString::fromStdString(name);
  std::string html = "<h1>" + course_words(scenario.title).toHtmlEscaped().toStdString() +
                     "</h1><p style=\"color:#555\">" +
                     QCoreApplication::translate("Report", "Scenario %1, %2, seed %3, device %4, patient %5")
                         .arg(QString::fromStdString(scenario.id), in_words(name_of(scenario.attempt.mode)),
                              QString::number(scenario.attempt.seed), hands_in_words(log.header.device_kind),
                              QString::fromStdString(log.header.package_name))
                         .toHtmlEscaped()
                         .toStdString() +
                     "</p>" + box(score, escaped(summary_sentence(score, scenario))) + "<p><b>" +
                     in_page(what_to_change(score, scenario)) + "</b></p>";
  if (!log.footer.complete)
    html +=
        "<p><b>" + in_page("This trial was cut off: what stands here is what was recorded until then.") + "</b></p>";
  html += heading("Why") + "<ul>";
  for (const std::string& reason : score.reasons) html += "<li>" + in_page(reason) + "</li>";
  html += "</ul>" + points_table(score, scenario);
  std::vector<Cells> rows;
  for (const Row& row : report_rows(score, log, scenario))
    rows.push_back({in_page(row.name), "<b>" + in_page(row.value) + "</b>", in_page(row.limit), verdict(row.verdict)});
  html += heading("Figures") + table({"Figure", "Measured", "Demanded", ""}, rows);
  if (score.intubation) html += attempts_html(score);
  html += heading_on_new_page("Over time") + picture("force.png");
  pages.pictures["force.png"] = draw_force_chart(log, scenario, score);
  if (score.intubation) {
    html += picture("monitor.png");
    pages.pictures["monitor.png"] = draw_monitor_chart(log, scenario, score);
  }
  html += heading("How it was recorded") +
          table({"", ""},
                {{in_page("Device"), escaped(hands_in_words(log.header.device_kind).toStdString()) + ", " +
                                         in_page("limit " + number(log.header.device_limit_n, 1) + " N")},
                 {in_page("Ticks"),
                  in_page(std::to_string(score.ticks) + ", " + std::to_string(score.deadline_misses) +
                          " deadline misses, " + std::to_string(score.overruns) + " simulation steps dropped")},
                 {in_page("How it ended"), in_page(log.footer.ended)},
                 {"Vallecula", escaped(log.header.software_version) + ", build " + log.header.build_hash.substr(0, 12)},
                 {in_page("Scenario"), "sha256 " + log.header.scenario_sha256.substr(0, 12)}});
  pages.html = QString::fromStdString(html);
  write_pdf(file, pages);
}

void write_trainee_pdf(const std::filesystem::path& file, long long trainee_id, const std::string& name,
                       const std::vector<curricula::ExportTrial>& trials) {
  const std::string who =
      in_words(trainee_id == 0 ? "Trials of nobody" : "Trainee " + std::to_string(trainee_id)).toStdString();
  std::map<CurveOf, std::vector<curricula::RecordRow>> curves;
  std::string first, last;
  for (const curricula::ExportTrial& trial : trials) {
    curves[{trial.row.curriculum_id, trial.row.scenario_id, trial.row.device_kind}].push_back(trial.row);
    if (first.empty() || trial.row.finished_utc < first) first = trial.row.finished_utc;
    last = std::max(last, trial.row.finished_utc);
  }
  KnownCourses courses;
  courses.set(find_curricula().curricula);
  PdfPages pages;
  pages.title = QString::fromStdString(who);
  pages.person = QString::fromStdString(name);
  std::vector<Cells> summary;
  std::string charts;
  int number_of_chart = 0;
  for (const auto& [of, rows] : curves) {
    const auto& [curriculum, scenario, device] = of;
    const CurveReading reading = read_curve(rows, courses.find(curriculum));
    const auto whole =
        std::count_if(rows.begin(), rows.end(), [](const curricula::RecordRow& row) { return row.score.counts(); });
    const auto passed = std::count_if(rows.begin(), rows.end(), [&](const curricula::RecordRow& row) {
      return row.score.counts() && succeeded(row, reading);
    });
    summary.push_back(
        {title_of(courses, curriculum), title_of(courses, curriculum, scenario),
         escaped(hands_in_words(device).toStdString()), std::to_string(whole), std::to_string(reading.interrupted),
         std::to_string(reading.set_aside), std::to_string(passed),
         in_page(reading.to_competent < 0 ? "not yet" : "at trial " + std::to_string(reading.to_competent))});
    if (whole == 0) continue;
    const std::string picture_name = "curve-" + std::to_string(++number_of_chart) + ".png";
    pages.pictures[QString::fromStdString(picture_name)] = draw_curve_chart(rows, reading);
    charts += "<p><b>" + title_of(courses, curriculum, scenario) + "</b>, " +
              escaped(hands_in_words(device).toStdString()) + "<br>" + escaped(reading.rule_in_words) +
              "<br><img src=\"" + picture_name + "\" width=\"" + std::to_string(kPdfWidthPx) + "\"></p>";
  }
  std::vector<Cells> all;
  for (const curricula::ExportTrial& trial : trials) {
    const curricula::RecordRow& row = trial.row;
    const std::string result = !row.score.complete   ? in_page("cut off")
                               : !row.score.counts() ? in_page("not counted")
                               : row.score.passed    ? in_page("passed")
                                                     : "<b>" + in_page("not passed") + "</b>";
    all.push_back({minute(row.finished_utc), title_of(courses, row.curriculum_id, row.scenario_id),
                   escaped(hands_in_words(row.device_kind).toStdString()), in_page(name_of(row.mode)), result,
                   outcome(row), row.points ? number(*row.points, 0) : "", number(row.score.attempt_time_s, 1),
                   number(row.score.peak_tongue_force_n, 1)});
  }
  pages.html = QString::fromStdString(
      "<h1>" + escaped(name.empty() ? who : name) + "</h1><p style=\"color:#555\">" +
      in_page(std::to_string(trials.size()) + (trials.size() == 1 ? " trial" : " trials")) + ", " +
      QCoreApplication::translate("Report", "%1 to %2 UTC")
          .arg(minute(first).c_str(), minute(last).c_str())
          .toStdString() +
      "</p>" + heading("By scenario and device") +
      table({"Curriculum", "Scenario", "Device", "Trials", "Cut off", "Not counted", "Passed", "CUSUM says competent"},
            summary) +
      "<p>" +
      in_page(
          "Passed: every mark met, within the attempts of the rule, which each curve names (two by the published one). "
          "Figures of different kinds of device are never put together.") +
      "</p>" + (charts.empty() ? "" : heading_on_new_page("Learning curves") + charts) +
      (charts.empty() ? heading("All trials") : heading_on_new_page("All trials")) +
      table({"Finished (UTC)", "Scenario", "Device", "Mode", "Result", "Tube", "Points", "Attempt (s)", "Tongue (N)"},
            all));
  write_pdf(file, pages);
}

}  // namespace vallecula::gui

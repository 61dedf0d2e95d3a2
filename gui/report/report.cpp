#include "gui/report/report.h"

#include <QBuffer>
#include <QByteArray>
#include <QCoreApplication>
#include <algorithm>
#include <vector>

#include "curricula/records/trial_files.h"
#include "gui/report/advice.h"
#include "gui/report/figure_row.h"
#include "gui/report/intubation_report.h"
#include "gui/report/markdown.h"
#include "gui/report/monitor_chart.h"
#include "gui/report/technique_report.h"
#include "gui/session/files.h"
#include "gui/session/languages.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

std::vector<Row> figures(const curricula::Score& score, const curricula::TrialLog& log,
                         const curricula::Scenario& scenario) {
  const bool seen = score.time_to_trachea_visible_s >= 0.0;
  const curricula::PassLimits& pass = scenario.pass;
  const auto other = [&](const std::string& name, int structure) {
    return Row{name, force(score.peak_force_n[structure], score.time_of_peak_s[structure]), "", ""};
  };
  std::vector<Row> rows = {row(score, "Glottis seen, at best", number(score.glottis_visible_max_percent, 0) + " %",
                               "glottis_visible_max_percent", "at least")};
  if (!score.at_vallecula)
    rows.push_back({"Time to glottis in sight (" + number(scenario.sight_percent, 0) + " %)",
                    seen ? number(score.time_to_trachea_visible_s, 1) + " s" : "never", "", ""});
  rows.insert(
      rows.end(),
      {
          attempt_row(score, scenario,
                      score.mouth_entries > 1 && score.intubation ? "Longest attempt, blade in to blade out"
                                                                  : "Attempt time, blade in to blade out"),
          limit_row(score, "Peak force on the tongue",
                    force(score.peak_tongue_force_n, score.time_of_peak_tongue_force_s), "peak_tongue_force_n",
                    pass.peak_tongue_force_n, "N"),
          limit_row(score, "Peak force on the gums", force(score.peak_gum_force_n, score.time_of_peak_gum_force_s),
                    "peak_gum_force_n", pass.peak_gum_force_n, "N"),
          other("Peak force on the epiglottis", curricula::kEpiglottis),
          other("Peak force on the palate", curricula::kPalate),
          other("Peak force on the larynx", curricula::kLarynx),
          limit_row(score,
                    "Time over the training target (tongue, " + number(scenario.targets.tongue_force_n, 1) + " N)",
                    number(score.time_over_target_s, 2) + " s", "time_over_target_s", pass.time_over_target_s, "s"),
          limit_row(score, "Time over the device limit (" + number(log.header.device_limit_n, 1) + " N)",
                    number(score.time_over_force_limit_s, 2) + " s", "time_over_force_limit_s",
                    pass.time_over_device_limit_s, "s"),
      });
  return rows;
}

}  // namespace

std::vector<Row> report_rows(const curricula::Score& score, const curricula::TrialLog& log,
                             const curricula::Scenario& scenario) {
  std::vector<Row> rows = figures(score, log, scenario);
  if (score.intubation) {
    const std::vector<Row> tube = intubation_rows(score, scenario);
    rows.insert(rows.begin(), tube.begin(), tube.end());
  }
  const std::vector<Row> technique = technique_rows(score);
  rows.insert(rows.end(), technique.begin(), technique.end());
  if (!score.pauses.empty())
    rows.push_back({"Paused, which counts for nothing", number(score.paused_s, 1) + " s", pauses_in_words(score), ""});
  return rows;
}

namespace {

std::string title(const std::string& text) { return "<h2>" + in_page(text) + "</h2>\n"; }

std::string picture(const std::string& png, const std::string& what) {
  const std::string base64 = QByteArray::fromRawData(png.data(), static_cast<int>(png.size())).toBase64().toStdString();
  return "<img alt=\"" + in_page(what) + "\" src=\"data:image/png;base64," + base64 + "\">\n";
}

std::string png_of(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG")) throw std::runtime_error("report.html: the monitor's chart could not be encoded");
  return bytes.toStdString();
}

std::string table(const std::vector<Row>& rows) {
  std::string html = "<table>\n<tr><th>" + in_page("Figure") + "</th><th>" + in_page("Measured") + "</th><th>" +
                     in_page("Demanded") + "</th><th></th></tr>\n";
  for (const Row& row : rows) {
    html += "<tr><td>" + in_page(row.name) + "</td><td class=\"figure\">" + in_page(row.value) + "</td><td>" +
            in_page(row.limit) + "</td><td class=\"" + row.verdict + "\">" + in_page(row.verdict) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

constexpr const char* kStyle = R"(
body { font: 16px/1.5 "DejaVu Sans", "Segoe UI", sans-serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: 0; } h2 { font-size: 1.15rem; margin-top: 2rem; }
.sub { color: #555; margin-top: .2rem; }
.summary { border-left: .5rem solid; padding: .6rem 1rem; font-size: 1.1rem; background: #f6f4ec; }
.change { font-size: 1.1rem; font-weight: bold; }
.passed { border-color: #009E73; } .failed { border-color: #D55E00; }
table { border-collapse: collapse; width: 100%; } th, td { text-align: left; padding: .35rem .6rem; border-bottom: 1px solid #ddd; }
td.figure { font-weight: bold; } td.met { color: #00795a; } td.missed { color: #b34f00; font-weight: bold; }
img { max-width: 100%; height: auto; } .shots { display: flex; flex-wrap: wrap; gap: 1rem; } .shots figure { margin: 0; flex: 1 1 26rem; }
figcaption, .foot { color: #555; font-size: .85rem; }
)";

}  // namespace

std::string pauses_in_words(const curricula::Score& score) {
  std::vector<std::string> kinds;
  for (const curricula::Pause& pause : score.pauses) {
    std::string kind = pause.fault.empty() ? "reason not recorded" : pause.fault;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  std::string words = std::to_string(score.pauses.size()) + (score.pauses.size() == 1 ? " time (" : " times (");
  for (std::size_t i = 0; i < kinds.size(); ++i) words += (i == 0 ? "" : ", ") + kinds[i];
  return words + ")";
}

std::string summary_sentence(const curricula::Score& score, const curricula::Scenario& scenario) {
  if (score.intubation) return intubation_sentence(score, scenario);
  const bool seen = score.time_to_trachea_visible_s >= 0.0;
  const std::string sight =
      seen && score.at_vallecula
          ? "the glottis came into sight (" + number(score.glottis_visible_max_percent, 0) + " % at best)"
      : seen ? "the glottis came into sight after " + number(score.time_to_trachea_visible_s, 1) + " s (" +
                   number(score.glottis_visible_max_percent, 0) + " % at best)"
             : "the glottis never came into sight (" + number(score.glottis_visible_max_percent, 0) + " % at best)";
  const std::string forces = "with at most " + number(score.peak_tongue_force_n, 1) + " N on the tongue and " +
                             number(score.peak_gum_force_n, 1) + " N on the gums";
  const std::string attempt = score.at_vallecula    ? "begun at the vallecula."
                              : score.attempt_begun ? "in an attempt of " + number(score.attempt_time_s, 1) + " s."
                              : score.mouth_unknown ? "the attempt could not be timed."
                                                    : "the blade never entered the mouth.";
  return QString("%1 (%2): %3, %4%5 %6")
      .arg(in_words(verdict(score)), course_words(scenario.title), in_words(sight), in_words(forces),
           score.attempt_begun ? "," : ";", in_words(attempt))
      .toStdString();
}

void write_report(const fs::path& folder, const curricula::TrialLog& log, const curricula::Scenario& scenario,
                  const curricula::Score& score) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"" + language().toStdString() +
                     "\"><head><meta charset=\"utf-8\"><title>Vallecula: " +
                     course_words(scenario.title).toHtmlEscaped().toStdString() +
                     "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>" + kStyle +
                     "</style></head><body>\n<h1>" + course_words(scenario.title).toHtmlEscaped().toStdString() +
                     "</h1>\n<p class=\"sub\">" +
                     QCoreApplication::translate("Report", "Patient %1, scenario %2")
                         .arg(QString::fromStdString(log.header.package_name), QString::fromStdString(scenario.id))
                         .toHtmlEscaped()
                         .toStdString() +
                     "</p>\n";
  html += std::string("<p class=\"summary ") +
          (!score.set_aside.empty() ? ""
           : score.passed           ? "passed"
                                    : "failed") +
          "\">" + escaped(summary_sentence(score, scenario)) + "</p>\n<p class=\"change\">" +
          in_page(what_to_change(score, scenario)) + "</p>\n";
  if (!score.reasons.empty()) {
    html += title(!score.set_aside.empty() ? "Why it counts neither way, and what was measured"
                  : score.passed           ? "Why it was passed"
                                           : "Why it was not passed") +
            "<ul>\n";
    for (const std::string& reason : score.reasons) html += "<li>" + in_page(reason) + "</li>\n";
    html += "</ul>\n";
  }
  html += points_html(score, scenario);
  html += title("Figures") + table(report_rows(score, log, scenario));
  if (score.intubation) {
    html += attempts_html(score);
    html += title("The monitor") + picture(png_of(draw_monitor_chart(log, scenario, score)),
                                           "Saturation, heart rate and glottis in sight over time, with attempts, "
                                           "breaths and the tube's passing marked");
  }
  html += checklist_html(score);
  html += title("Force over time") +
          picture(read_file(folder / "force.png"),
                  "Force on tongue and gum over time, with limit, target, peak and first sight marked");
  html +=
      "<p class=\"foot\">" +
      QCoreApplication::translate(
          "Report",
          "The shaded span is the attempt, blade into the mouth to blade out; grey is a pause, in which the device "
          "could "
          "not be used. Tongue and gum: force of the tissue on the blade (model force). The dotted line is what the "
          "device was told to show. A peak is the largest single tick of 1 ms, unfiltered. Time over the device limit "
          "counts until a device that was lost has taken hold again.")
          .toStdString() +
      "</p>\n";
  if (const std::string debriefing = html_of(scenario.debriefing).toStdString(); !debriefing.empty())
    html += title("Debriefing") + debriefing + "\n";
  const std::vector<fs::path> shots = curricula::screenshots_in(folder);
  if (!shots.empty()) {
    html += title("Pictures") + "<div class=\"shots\">\n";
    for (const fs::path& shot : shots) {
      const std::string name = escaped(shot.filename().string());
      html += "<figure><img alt=\"" + name + "\" src=\"" + name + "\"><figcaption>" + name + "</figcaption></figure>\n";
    }
    html += "</div>\n";
  }
  html += title("How it was recorded") + "<table>\n";
  const auto line = [&html](const std::string& name, const std::string& value) {
    html += "<tr><td>" + in_page(name) + "</td><td>" + in_page(value) + "</td></tr>\n";
  };
  line("Device", log.header.device_kind + ", limit " + number(log.header.device_limit_n, 1) + " N");
  line("Servo loop", log.header.realtime
                         ? number(score.loop_rate_hz, 1) + " Hz over " + std::to_string(score.ticks) + " ticks, " +
                               std::to_string(score.deadline_misses) + " deadline misses, " +
                               std::to_string(score.overruns) + " simulation steps dropped"
                         : std::to_string(score.ticks) + " ticks of 1 ms, not in real time");
  if (!score.real_time_setup.empty()) line("Real-time set-up", score.real_time_setup);
  line("How it ended", log.footer.ended);
  line("Vallecula", log.header.software_version + ", build " + log.header.build_hash.substr(0, 12) + ", kernels " +
                        log.header.instruction_set);
  line("Patient package", log.header.package_name + ", sha256 " + log.header.package_sha256.substr(0, 12));
  line("Scenario", scenario.id + ", sha256 " + log.header.scenario_sha256.substr(0, 12));
  if (!log.header.tool_sha256.empty())
    line("Tool", "a tool of its own, tool.ply, sha256 " + log.header.tool_sha256.substr(0, 12));
  html += "</table>\n<p class=\"foot\">" +
          QCoreApplication::translate(
              "Report",
              "Vallecula is a training tool, not a medical device. Limits and targets are training targets, not injury "
              "thresholds.")
              .toStdString() +
          "</p>\n</body></html>\n";
  write_file_whole(folder / "report.html", html);
}

}  // namespace vallecula::gui

#include "gui/report/force_chart.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/report/chart_panel.h"
#include "gui/report/judged_lines.h"
#include "gui/session/files.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {

namespace {

// Of the hues that no line which judges has.
const QColor kTongue = chart::kGreen;
const QColor kGum = chart::kPurple.darker(140);  // so that it is bright enough on the dark ground as well
const QColor kDisplayed = chart::kGrey;
const QColor kSightColour = chart::kSky;

double length(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

std::vector<std::pair<double, double>> attempt_spans(const curricula::Score& score) {
  std::vector<std::pair<double, double>> spans;
  if (score.intubation) {
    for (const curricula::Attempt& attempt : score.intubation->attempts)
      spans.emplace_back(attempt.start_s, attempt.end_s);
  } else if (score.attempt_time_s > 0.0) {
    spans.emplace_back(score.attempt_start_s, score.attempt_start_s + score.attempt_time_s + score.attempt_paused_s);
  }
  return spans;
}

QString displayed_words(const curricula::LogHeader& header) {
  const auto peak = header.settings.find("device_peak_force_n");
  const bool shows_none = peak != header.settings.end() ? peak->second <= 0.0
                                                        : header.device_kind.rfind("mouse", 0) == 0 ||
                                                              header.device_kind.rfind("spacemouse", 0) == 0;
  return shows_none
             ? QCoreApplication::translate("Charts", "as a device with force would show it (this one shows none)")
             : QCoreApplication::translate("Charts", "shown by the device");
}

std::vector<ChartLabel> paint_force_chart(QPainter& painter, const ChartForm& form, const curricula::TrialLog& log,
                                          const curricula::Scenario& scenario, const curricula::Score& score) {
  if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr) {
    throw std::logic_error("a chart needs a QGuiApplication for its fonts");
  }
  Series tongue, gum, displayed, sight;
  const curricula::PassLimits& pass = scenario.pass;
  double highest = std::max({log.header.device_limit_n, scenario.targets.tongue_force_n, scenario.targets.gum_force_n,
                             pass.peak_tongue_force_n, pass.peak_gum_force_n});
  for (const curricula::LogTick& tick : log.ticks) {
    const double forces[] = {length(tick.loads[curricula::kTongue].force_n),
                             length(tick.loads[curricula::kGum].force_n), length(tick.displayed_force_n)};
    Series* const lines[] = {&tongue, &gum, &displayed};
    for (int i = 0; i < 3; ++i) {
      lines[i]->add(tick.time_s, forces[i]);
      highest = std::max(highest, forces[i]);
    }
    if (tick.has_sight) sight.add(tick.time_s, 100.0 * tick.glottis_visible);
  }

  const double em = form.em;
  const TimeAxis axis = chart_time_axis(form, log.ticks.empty() ? 0.0 : log.ticks.back().time_s);
  const double left = axis.left, right = axis.right, end_s = axis.end_s;
  ChartLabels labels(chart_type(em), em);
  const double top =
      begin_chart(painter, labels, form, left, right,
                  QCoreApplication::translate("Charts", "Force over time: %1").arg(course_words(scenario.title)),
                  {{QCoreApplication::translate("Charts", "tongue"), QPen(kTongue, em * 0.18)},
                   {QCoreApplication::translate("Charts", "gum"), QPen(kGum, em * 0.18)},
                   {displayed_words(log.header), QPen(kDisplayed, em * 0.1, Qt::DotLine)}});
  const double sight_height = std::max(form.height * 0.16, 2.6 * em);
  const QRectF force_frame(left, top, right - left, form.height - top - sight_height - 5.8 * em);
  const QRectF sight_frame(left, force_frame.bottom() + 1.6 * em, right - left, sight_height);

  Panel force(painter, labels, force_frame, end_s, highest * 1.15, em);
  Panel view(painter, labels, sight_frame, end_s, 100.0, em);
  for (const auto& [from_s, to_s] : attempt_spans(score)) {
    force.span(from_s, to_s, chart::kAttempt);
    view.span(from_s, to_s, chart::kAttempt);
  }
  force.axes({QCoreApplication::translate("Charts", "force (N)")}, 8, false);
  view.axes(
      {QCoreApplication::translate("Charts", "glottis seen (%)"), QCoreApplication::translate("Charts", "seen (%)")}, 2,
      true);

  force.line(gum, QPen(kGum, em * 0.16));
  force.line(tongue, QPen(kTongue, em * 0.18));
  force.line(displayed, QPen(kDisplayed, em * 0.1, Qt::DotLine));
  view.line(sight, QPen(kSightColour.darker(130), em * 0.16));
  for (const curricula::Pause& pause : score.pauses) {
    force.pause(pause.at_s, pause.at_s + pause.for_s, QCoreApplication::translate("Charts", "paused"));
    view.pause(pause.at_s, pause.at_s + pause.for_s, QString());
  }
  const auto judged = [&](double force_n, const JudgedLine& look, const QString& words) {
    if (force_n > 0.0) force.level(force_n, look.on_paper, look.style, words.arg(chart::number(force_n, 1)), true);
  };
  judged(pass.peak_tongue_force_n, kPassLine, QCoreApplication::translate("Charts", "pass limit, tongue %1 N"));
  judged(scenario.targets.tongue_force_n, kTargetLine, QCoreApplication::translate("Charts", "target, tongue %1 N"));
  judged(log.header.device_limit_n, kDeviceLine, QCoreApplication::translate("Charts", "device limit %1 N"));
  judged(pass.peak_gum_force_n, kPassLine, QCoreApplication::translate("Charts", "pass limit, gum %1 N"));
  judged(scenario.targets.gum_force_n, kTargetLine, QCoreApplication::translate("Charts", "target, gum %1 N"));
  view.level(scenario.sight_percent, kSightColour, Qt::DashLine,
             QCoreApplication::translate("Charts", "counts as in sight from %1 %")
                 .arg(chart::number(scenario.sight_percent, 0)),
             true);
  if (score.time_to_trachea_visible_s >= 0.0) {
    force.moment(score.time_of_first_sight_s, kSightColour,
                 score.at_vallecula ? QCoreApplication::translate("Charts", "first sight")
                                    : QCoreApplication::translate("Charts", "first sight, %1 s into the attempt")
                                          .arg(chart::number(score.time_to_trachea_visible_s, 1)));
    view.moment(score.time_of_first_sight_s, kSightColour, QString());
  }
  if (score.peak_gum_force_n > 0.0) {
    force.peak(score.time_of_peak_gum_force_s, score.peak_gum_force_n, kGum,
               QCoreApplication::translate("Charts", "gum peak %1 N").arg(chart::number(score.peak_gum_force_n, 2)));
  }
  if (score.peak_tongue_force_n > 0.0) {
    force.peak(
        score.time_of_peak_tongue_force_s, score.peak_tongue_force_n, kTongue,
        QCoreApplication::translate("Charts", "tongue peak %1 N").arg(chart::number(score.peak_tongue_force_n, 2)));
  }
  return labels.draw(painter);
}

Chart make_force_chart(const ChartForm& form, const curricula::TrialLog& log, const curricula::Scenario& scenario,
                       const curricula::Score& score) {
  QImage image(form.width, form.height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  auto labels = paint_force_chart(painter, form, log, scenario, score);
  painter.end();
  return {image, std::move(labels)};
}

QImage draw_force_chart(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                        const curricula::Score& score, int width, int height) {
  return make_force_chart(picture_form(width, height), log, scenario, score).picture;
}

void write_force_chart(const std::filesystem::path& png, const curricula::TrialLog& log,
                       const curricula::Scenario& scenario, const curricula::Score& score) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!draw_force_chart(log, scenario, score).save(&buffer, "PNG")) {
    throw std::runtime_error(png.string() + ": the chart could not be encoded as PNG");
  }
  write_file_whole(png, bytes.toStdString());
}

}  // namespace vallecula::gui

#include "gui/report/monitor_chart.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/report/chart_panel.h"
#include "gui/report/force_chart.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {

namespace {

const QColor kSpo2 = chart::kBlue;
const QColor kSao2 = chart::kGrey;
const QColor kHeart = chart::kGreen;
const QColor kSight = chart::kSky;
const QColor kPassed = chart::kPurple;
const QColor kYellow = chart::kOrange;
const QColor kOesophagus(0xF6, 0xD5, 0xC3);  // vermillion, light

struct Recorded {
  Series spo2, sao2, heart, sight;
  std::vector<double> breaths_s;
  std::vector<double> yellow_s;                         ///< the detector turned yellow
  std::vector<std::pair<double, double>> oesophagus_s;  ///< from, to
  double fastest_per_min = 200.0;
  bool untold = false;  ///< it fell to where no monitor's figure is to be believed
};

Recorded read(const curricula::TrialLog& log) {
  Recorded r;
  int breaths = 0;
  bool yellow = false, there = false;
  for (const curricula::LogTick& tick : log.ticks) {
    const curricula::LogIntubation& i = tick.intubation;
    r.spo2.add(tick.time_s, std::max(100.0 * i.spo2, curricula::kLeastToldSpo2));
    r.untold = r.untold || 100.0 * i.spo2 < curricula::kLeastToldSpo2;
    r.sao2.add(tick.time_s, 100.0 * i.sao2);
    r.heart.add(tick.time_s, i.heart_per_min);
    r.fastest_per_min = std::max(r.fastest_per_min, i.heart_per_min);
    if (tick.has_sight) r.sight.add(tick.time_s, 100.0 * tick.glottis_visible);
    if (i.breaths_given > breaths) r.breaths_s.push_back(tick.time_s);
    if (i.detector_yellow && !yellow) r.yellow_s.push_back(tick.time_s);
    const bool now_there = curricula::tube_in_oesophagus(tick);
    if (now_there && !there) r.oesophagus_s.emplace_back(tick.time_s, tick.time_s);
    if (now_there) r.oesophagus_s.back().second = tick.time_s;
    breaths = i.breaths_given;
    yellow = i.detector_yellow;
    there = now_there;
  }
  return r;
}

}  // namespace

std::vector<ChartLabel> paint_monitor_chart(QPainter& painter, const ChartForm& form, const curricula::TrialLog& log,
                                            const curricula::Scenario& scenario, const curricula::Score& score) {
  if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr)
    throw std::logic_error("a chart needs a QGuiApplication for its fonts");
  if (!score.intubation || !log.header.has_intubation)
    throw std::logic_error("a monitor's chart needs a trial with an intubation");
  const curricula::IntubationScore& intubation = *score.intubation;
  const Recorded recorded = read(log);

  const double em = form.em;
  const TimeAxis axis = chart_time_axis(form, log.ticks.empty() ? 0.0 : log.ticks.back().time_s);
  const double left = axis.left, right = axis.right, gap = 1.6 * em;
  ChartLabels labels(chart_type(em), em);
  const double begin =
      begin_chart(painter, labels, form, left, right,
                  QCoreApplication::translate("Charts", "The monitor: %1").arg(course_words(scenario.title)),
                  {{QCoreApplication::translate("Charts", "saturation as displayed"), QPen(kSpo2, em * 0.18)},
                   {QCoreApplication::translate("Charts", "as it really was"), QPen(kSao2, em * 0.1, Qt::DotLine)},
                   {QCoreApplication::translate("Charts", "heart"), QPen(kHeart, em * 0.18)},
                   {QCoreApplication::translate("Charts", "a breath given"), QPen(chart::kInk, em * 0.12)},
                   {QCoreApplication::translate("Charts", "tip in the oesophagus"),
                    QPen(kOesophagus, em * 0.9, Qt::SolidLine, Qt::FlatCap)}});

  const double room = form.height - begin - 4.2 * em - 2.0 * gap;
  const QRectF top(left, begin, right - left, 0.45 * room);
  const QRectF middle(left, top.bottom() + gap, right - left, 0.33 * room);
  const QRectF bottom(left, middle.bottom() + gap, right - left, 0.22 * room);
  Panel saturation(painter, labels, top, axis.end_s, 110.0, em);  // room above 100 for the marks
  Panel heart(painter, labels, middle, axis.end_s, recorded.fastest_per_min * 1.05, em);
  Panel view(painter, labels, bottom, axis.end_s, 100.0, em);
  for (Panel* panel : {&saturation, &heart, &view}) {
    for (const auto& [from_s, to_s] : attempt_spans(score)) panel->span(from_s, to_s, chart::kAttempt);
    for (const auto& [from_s, to_s] : recorded.oesophagus_s) panel->span(from_s, to_s, kOesophagus);
  }
  saturation.axes({QStringLiteral("SpO2 (%)")}, 6, false);
  heart.axes(
      {QCoreApplication::translate("Charts", "heart (per minute)"), QCoreApplication::translate("Charts", "heart")}, 5,
      false);
  view.axes(
      {QCoreApplication::translate("Charts", "glottis seen (%)"), QCoreApplication::translate("Charts", "seen (%)")}, 2,
      true);

  saturation.line(recorded.sao2, QPen(kSao2, em * 0.1, Qt::DotLine));
  saturation.line(recorded.spo2, QPen(kSpo2, em * 0.18));
  heart.line(recorded.heart, QPen(kHeart, em * 0.18));
  view.line(recorded.sight, QPen(kSight.darker(130), em * 0.16));
  painter.setPen(QPen(chart::kInk, em * 0.12));
  for (const double at_s : recorded.breaths_s)
    painter.drawLine(QPointF(saturation.x(at_s), top.bottom() - 0.9 * em), QPointF(saturation.x(at_s), top.bottom()));
  for (const curricula::Pause& pause : score.pauses) {
    saturation.pause(pause.at_s, pause.at_s + pause.for_s, QCoreApplication::translate("Charts", "paused"));
    heart.pause(pause.at_s, pause.at_s + pause.for_s, QString());
    view.pause(pause.at_s, pause.at_s + pause.for_s, QString());
  }

  const curricula::IntubationPass& pass = scenario.intubation ? scenario.intubation->pass : curricula::IntubationPass{};
  if (pass.lowest_spo2_percent)
    saturation.level(
        *pass.lowest_spo2_percent, chart::kVermillion, Qt::DashLine,
        QCoreApplication::translate("Charts", "not below %1 %").arg(chart::number(*pass.lowest_spo2_percent, 0)),
        false);
  heart.level(
      curricula::kBradycardia, chart::kVermillion, Qt::DashLine,
      QCoreApplication::translate("Charts", "bradycardia below %1").arg(chart::number(curricula::kBradycardia, 0)),
      false);
  view.level(scenario.sight_percent, kSight, Qt::DashLine,
             QCoreApplication::translate("Charts", "counts as in sight from %1 %")
                 .arg(chart::number(scenario.sight_percent, 0)),
             true);
  for (const curricula::Attempt& attempt : intubation.attempts) {
    if (attempt.view_at_s) view.moment(*attempt.view_at_s, kSight, QCoreApplication::translate("Charts", "view"));
    if (attempt.passed_cords_s)
      saturation.moment(*attempt.passed_cords_s, kPassed, QCoreApplication::translate("Charts", "tube past the cords"));
  }
  for (const double at_s : recorded.yellow_s)
    heart.moment(at_s, kYellow, QCoreApplication::translate("Charts", "CO2: detector yellow"));
  const QString floor = chart::number(curricula::kLeastToldSpo2, 0);
  if (recorded.untold)
    saturation.level(curricula::kLeastToldSpo2, chart::kGrey, Qt::DotLine,
                     QCoreApplication::translate("Charts", "the display says < %1").arg(floor), false);
  if (intubation.lowest_spo2_percent) {
    const double lowest = *intubation.lowest_spo2_percent;
    saturation.peak(intubation.lowest_spo2_at_s, std::max(lowest, curricula::kLeastToldSpo2), kSpo2,
                    std::round(lowest) < curricula::kLeastToldSpo2
                        ? QCoreApplication::translate("Charts", "lowest: below %1 %").arg(floor)
                        : QCoreApplication::translate("Charts", "lowest %1 %").arg(chart::number(lowest, 0)));
  }
  if (intubation.lowest_heart_per_min)
    heart.peak(intubation.lowest_heart_at_s, *intubation.lowest_heart_per_min, kHeart,
               QCoreApplication::translate("Charts", "lowest %1 per minute")
                   .arg(chart::number(*intubation.lowest_heart_per_min, 0)));
  return labels.draw(painter);
}

Chart make_monitor_chart(const ChartForm& form, const curricula::TrialLog& log, const curricula::Scenario& scenario,
                         const curricula::Score& score) {
  QImage image(form.width, form.height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  auto labels = paint_monitor_chart(painter, form, log, scenario, score);
  painter.end();
  return {image, std::move(labels)};
}

QImage draw_monitor_chart(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                          const curricula::Score& score, int width, int height) {
  return make_monitor_chart(picture_form(width, height), log, scenario, score).picture;
}

}  // namespace vallecula::gui

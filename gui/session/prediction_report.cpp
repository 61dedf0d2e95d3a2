#include "gui/session/prediction_report.h"

#include <cstdio>

#include "gui/session/log_conversion.h"

namespace vallecula::gui {

engine::PredictionMeasurement measure_prediction(const curricula::TrialLog& log, const engine::SceneDescription& scene,
                                                 const std::function<void(double)>& progress) {
  engine::PredictionMeasurement measured(engine::build_scene(scene));
  std::size_t done = 0;
  for (const curricula::LogTick& tick : log.ticks) {
    const engine::TickRecord record = from_log(tick);
    engine::PortInput input;
    input.pose = record.device_pose;
    input.buttons = record.buttons;
    input.valid = record.device_valid;
    measured.add(input);
    if (progress && ++done % 500 == 0) progress(static_cast<double>(done) / static_cast<double>(log.ticks.size()));
  }
  return measured;
}

QJsonObject prediction_report_json(const engine::PredictionMeasurement& measured, std::int64_t ticks) {
  using engine::Prediction;
  QJsonObject kinds;
  for (const auto& [name, kind] :
       {std::pair{"contact", Prediction::contact}, {"spring", Prediction::spring}, {"hold", Prediction::hold}}) {
    QJsonObject of_kind;
    for (const int withheld : engine::kWithheldSteps) {
      const engine::ForceError error = measured.error(kind, withheld);
      of_kind[QString::number(withheld)] =
          QJsonObject{{"rms_n", error.rms_n},
                      {"p99_n", error.p99_n},
                      {"max_n", error.max_n},
                      {"ticks", static_cast<double>(error.ticks)},
                      {"rms_share", measured.peak_force_n() > 0 ? error.rms_n / measured.peak_force_n() : 0.0}};
    }
    kinds[name] = of_kind;
  }
  return {{"ticks", static_cast<double>(ticks)},
          {"peak_force_n", measured.peak_force_n()},
          {"prediction", kinds},
          {"energy", energy_json(measured.energy())}};
}

QJsonObject energy_json(const engine::PassivityObserver& energy) {
  return {{"pushed_in_j", energy.pushed_in()},
          {"given_back_j", energy.given_back()},
          {"turned_in_j", energy.turned_in()},
          {"lowest_j", energy.lowest()},
          {"lowest_of_forces_j", energy.lowest_of_forces()}};
}

std::string energy_line(const engine::PassivityObserver& energy) {
  char text[200];
  std::snprintf(text, sizeof text,
                "energy: the hand put in %.2f mJ by pushing and %.2f mJ by turning, got back %.2f mJ; the sum was %.6f "
                "mJ at its lowest",
                1e3 * energy.pushed_in(), 1e3 * energy.turned_in(), 1e3 * energy.given_back(), 1e3 * energy.lowest());
  return text;
}

}  // namespace vallecula::gui

// What a recorded hand says of the engine: how well late steps are predicted, and the energy the hand put in.
#pragma once

#include <QJsonObject>
#include <functional>

#include "curricula/trial_log.h"
#include "engine/haptics/prediction_error.h"

namespace vallecula::gui {

/// Computes the trial anew from its device poses with every step in time, withholding steps beside that. `progress`:
/// share done.
engine::PredictionMeasurement measure_prediction(const curricula::TrialLog& log, const engine::SceneDescription& scene,
                                                 const std::function<void(double)>& progress = {});

/// {"peak_force_n":..,"ticks":..,"prediction":{"contact":{"1":{"rms_n":..,"p99_n":..,"max_n":..,"rms_share":..},...},
/// "spring":..,
/// "hold":..},"energy":{"pushed_in_j":..,"given_back_j":..,"turned_in_j":..,"lowest_j":..,"lowest_of_forces_j":..}}
QJsonObject prediction_report_json(const engine::PredictionMeasurement& measured, std::int64_t ticks);
QJsonObject energy_json(const engine::PassivityObserver& energy);

/// "the hand put in 42.1 mJ by pushing and ...": one line for a person.
std::string energy_line(const engine::PassivityObserver& energy);

}  // namespace vallecula::gui

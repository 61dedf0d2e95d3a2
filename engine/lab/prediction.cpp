#include "engine/lab/prediction.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

Pose tool_of(const ExperimentStep& s) { return Pose{s.proxy_m, s.proxy_rotation}; }

/// The force of `known` once the tool has come to `tool`.
Vec3 predicted(const ExperimentStep& known, const Pose& tool, Prediction prediction) {
  if (prediction == Prediction::hold || known.stiffness_n_m <= 0) return known.model_force_n;
  PushingSprings tissue;
  add_tissue({known.model_force_n, known.torque_nm}, known.stiffness_n_m, tissue);
  tissue.follow(move_between(tool_of(known), tool));
  return tissue.force();
}

}  // namespace

ForceError prediction_error(const ExperimentResult& run, Prediction prediction, int withheld) {
  ForceErrors errors;
  for (std::size_t i = static_cast<std::size_t>(withheld); i < run.steps.size(); ++i)
    errors.add(predicted(run.steps[i - static_cast<std::size_t>(withheld)], tool_of(run.steps[i]), prediction),
               run.steps[i].model_force_n);
  return errors.summary();
}

ForceError multirate_error(const ExperimentResult& full, const ExperimentResult& coarse, int every,
                           Prediction prediction) {
  ForceErrors errors;
  const auto ticks = static_cast<std::size_t>(every);
  for (std::size_t i = ticks; i < full.steps.size() && i / ticks <= coarse.steps.size(); ++i)
    errors.add(predicted(coarse.steps[i / ticks - 1], tool_of(full.steps[i]), prediction), full.steps[i].model_force_n);
  return errors.summary();
}

}  // namespace vallecula::engine

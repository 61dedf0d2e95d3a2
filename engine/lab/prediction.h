// How well a late step's force is predicted in the laboratory, where the tool is where the trajectory has it: the
// tissue's part of what the servo does (haptics/prediction.h), held against the forces of the full steps.
#pragma once

#include "engine/haptics/prediction_error.h"
#include "engine/lab/experiment.h"

namespace vallecula::engine {

/// The model force of each step, predicted from the one `withheld` steps before; by its contact, or (Prediction::hold)
/// as it was.
ForceError prediction_error(const ExperimentResult& run, Prediction prediction, int withheld);

/// `coarse` has steps `every` times as long as those of `full`, and as many times fewer. Each of its steps is served
/// once it can be done, `every` ticks after it began, and predicted on from tick to tick: the error against the full
/// run's forces.
ForceError multirate_error(const ExperimentResult& full, const ExperimentResult& coarse, int every,
                           Prediction prediction);

}  // namespace vallecula::engine

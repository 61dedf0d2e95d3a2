// A recorded trial computed anew from the patient package and the scenario, to see whether every bit comes out the
// same.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "curricula/trial_log.h"
#include "engine/haptics/passivity.h"
#include "engine/scene.h"
#include "gui/session/log_conversion.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// The scene of a recorded trial, after its package and scenario have been proven to be the recorded ones.
struct RecordedScene {
  pipeline::PatientPackage package;
  std::filesystem::path package_folder;  ///< where it was found
  engine::SceneDescription description;
  std::vector<std::string> notices;  ///< what may keep the replay from being identical: another build, other kernels
};

/// `patient`: where the package is now; empty: where the log says, seen from here or from `log_file`'s folder. Throws
/// std::runtime_error with one message when the package is missing, is not the recorded one, or the settings are not.
RecordedScene recorded_scene(const curricula::TrialLog& log, const std::filesystem::path& log_file,
                             const std::filesystem::path& patient);

struct Verification {
  std::int64_t ticks = 0;  ///< compared, all of them identical unless `difference` says otherwise
  Difference difference;   ///< empty field: bit-identical
  std::int64_t tick = -1;  ///< where the first difference is
  double time_s = 0.0;
  engine::PassivityObserver energy;  ///< of the hand's, over the ticks compared
};

/// Feeds the log to engine::Replayer and compares each tick; stops at the first difference. `progress`: share done.
Verification verify_trial(const curricula::TrialLog& log, const engine::SceneDescription& description,
                          const std::function<void(double)>& progress = {});

}  // namespace vallecula::gui

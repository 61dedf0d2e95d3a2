#include "gui/session/replay.h"

#include <cmath>
#include <stdexcept>

#include "curricula/scenario.h"
#include "engine/haptics/runner.h"
#include "gui/session/files.h"
#include "gui/session/log_paths.h"
#include "gui/session/placed_tool.h"
#include "gui/session/scene_from_package.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

fs::path find_package(const curricula::LogHeader& header, const fs::path& log_file, const fs::path& patient) {
  if (!patient.empty()) return patient;
  const fs::path folder = fs::is_directory(log_file) ? log_file : log_file.parent_path();
  const fs::path found = package_of_log(header.package_path, folder);
  if (!found.empty()) return found;
  throw std::runtime_error(fs::path(header.package_path).filename().string() +
                           ": the patient package this trial was done on is neither where it was nor near the trial's "
                           "folder; name where it is now with --patient");
}

}  // namespace

RecordedScene recorded_scene(const curricula::TrialLog& log, const fs::path& log_file, const fs::path& patient) {
  const curricula::LogHeader& header = log.header;
  const std::string name = log_file.string();
  if (sha256_of_bytes(header.scenario_yaml) != header.scenario_sha256) {
    throw std::runtime_error(name +
                             ": the scenario in this log is not the one its hash was made of; the log was changed");
  }
  const fs::path package_path = find_package(header, log_file, patient);
  const std::string package_hash = sha256_of_file(package_path / "patient.yaml");
  if (package_hash != header.package_sha256) {
    throw std::runtime_error(package_path.string() +
                             ": is not the patient package of this trial (sha256 of patient.yaml " +
                             package_hash.substr(0, 12) + ", recorded " + header.package_sha256.substr(0, 12) +
                             "); name the right one with --patient");
  }
  const curricula::Scenario scenario = curricula::parse_scenario(header.scenario_yaml, name);
  RecordedScene scene;
  scene.package = pipeline::read_package(package_path);
  scene.package_folder = package_path;
  scene.description = scene_from_package(scene.package, scenario);
  if (const auto tool = tool_of_trial(header, log_file)) use_own_tool(*tool, scene.description);
  scene.description.haptics.device_limit_n = header.device_limit_n;  // the device's, not the scenario's
  const auto second_limit = header.settings.find("second_device_limit_n");
  if (scene.description.intubation && second_limit != header.settings.end())
    scene.description.intubation->device_limit_n = second_limit->second;
  const std::map<std::string, double> settings = settings_of(scene.description);
  for (const auto& [setting, value] : settings) {
    const auto recorded = header.settings.find(setting);
    if (recorded == header.settings.end() || recorded->second != value) {
      throw std::runtime_error(name + ": was recorded with another setting of " + setting +
                               " than this program's; replay it with "
                               "the build that wrote it (" +
                               header.software_version + ")");
    }
  }
  if (header.build_hash != sha256_of_program()) {
    scene.notices.push_back("recorded by another build (" + header.software_version + ", " +
                            header.build_hash.substr(0, 12) + "); only the same build promises the same bits");
  }
  if (header.instruction_set != engine::instruction_set()) {
    scene.notices.push_back("recorded with kernels for " + header.instruction_set + ", computed here with " +
                            engine::instruction_set());
  }
  return scene;
}

Verification verify_trial(const curricula::TrialLog& log, const engine::SceneDescription& description,
                          const std::function<void(double)>& progress) {
  engine::Replayer replayer(engine::build_scene(description));
  Verification result;
  for (const curricula::LogTick& recorded : log.ticks) {
    curricula::LogTick recomputed = to_log(replayer.replay(from_log(recorded)));
    // The count and the clock are recomputed here: the replayer takes them as given.
    recomputed.tick = result.ticks;
    recomputed.time_s = static_cast<double>(result.ticks) * log.header.servo_period_s;
    result.difference = first_difference(recorded, recomputed);
    if (!result.difference.field.empty()) {
      result.tick = recorded.tick;
      result.time_s = recorded.time_s;
      return result;
    }
    ++result.ticks;
    if (progress && result.ticks % 500 == 0) {
      progress(static_cast<double>(result.ticks) / static_cast<double>(log.ticks.size()));
    }
  }
  result.energy = replayer.energy();
  return result;
}

}  // namespace vallecula::gui

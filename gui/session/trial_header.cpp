#include "gui/session/trial_header.h"

#include "engine/haptics/runner.h"
#include "gui/session/files.h"
#include "gui/session/log_conversion.h"
#include "gui/session/package_parts.h"

namespace vallecula::gui {

curricula::LogHeader header_of(const pipeline::PatientPackage& package, const curricula::Scenario& scenario,
                               const engine::SceneDescription& scene) {
  curricula::LogHeader header;
  header.software_version = VALLECULA_VERSION;
  header.build_hash = sha256_of_program();
  header.instruction_set = engine::instruction_set();
  header.package_name = package.name;
  header.scenario_id = scenario.id;
  header.scenario_yaml = scenario.yaml;
  header.scenario_sha256 = sha256_of_bytes(scenario.yaml);
  header.has_events = !scenario.distractions.empty();
  header.has_contact_areas = true;
  header.has_intubation = scene.intubation.has_value();
  header.device_limit_n = scene.haptics.device_limit_n;
  header.settings = settings_of(scene);
  if (scene.intubation) {
    header.settings[curricula::kHeadExtension] = pipeline::kHeadExtendedDeg;
    header.settings[curricula::kLipsBeforeGums] = scene.intubation->lips_before_gums_m;
  }
  header.landmarks_m = landmarks_in_metres(package);
  return header;
}

}  // namespace vallecula::gui

// Between the engine's words and the trial log's: neither library knows the other.
#pragma once

#include <map>
#include <string>

#include "curricula/trial_log.h"
#include "device/guarded_device.h"
#include "engine/scene.h"
#include "engine/tick_record.h"

namespace vallecula::gui {

curricula::LogTick to_log(const engine::TickRecord& record);
engine::TickRecord from_log(const curricula::LogTick& tick);

/// The engine settings a trial ran with, by name with unit; what the package or the scenario determines is not
/// repeated.
std::map<std::string, double> settings_of(const engine::SceneDescription& description);

/// Of the tube, the cords, the infant and the helps likewise; part of those of its scene.
std::map<std::string, double> settings_of(const engine::IntubationDescription& intubation);

/// This infant's way from the cords to the carina, along the middle of its airway; 0 where there are no cords.
double cords_to_carina_m(const engine::AirwayCourse& course);

/// What stood between the engine and the device, likewise.
std::map<std::string, double> settings_of(const device::GuardSettings& guard);

/// A quantity that is not the same to the last bit.
struct Difference {
  std::string field;  ///< for instance "proxy_pose.position_m[2]"; empty: all fields are the same
  double recorded = 0.0, recomputed = 0.0;
};
Difference first_difference(const curricula::LogTick& recorded, const curricula::LogTick& recomputed);

}  // namespace vallecula::gui

// From a device's name on the command line to the device: whatever device/factory makes, and the hands that are planned
// from the patient.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "curricula/scenario.h"
#include "device/action_plan.h"
#include "device/guarded_device.h"
#include "device/trajectory.h"
#include "engine/tube/intubation.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// A device name that means nothing: wrong usage, not a failure.
class UnknownDevice : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The forms `name` may have, for a person: "mouse, scripted:expert, ...".
std::string device_names();
/// Nobody's hand (a script or a record): it starts by itself and ends by itself.
bool is_scripted(const std::string& name);
/// Such a hand that answers what a scenario asks meanwhile (session/dual_task.h): the planned pairs, the expert among
/// them. A file's, a record's and the novice leave it unanswered.
bool answers_distractions(const std::string& name);
/// Throws UnknownDevice when `name` is none of the forms that make_device takes. Reads no file;
/// a record is named by a file's ending or by a folder that is there.
void check_device_name(const std::string& name);

/// What a hand that is no person's is planned on. Whatever is given must outlive its use.
struct PlannedOn {
  const pipeline::PatientPackage& package;
  const curricula::Scenario& scenario;
  const engine::IntubationDescription* intubation;  ///< null: a scenario without
};

/// `name` is KIND[:ARG] with a kind of device::device_kinds(), or "scripted:" and a hand planned from the patient (of a
/// pair the blade's), or "recorded:TRIAL.vtrial", the hand of that trial. Throws UnknownDevice, or std::runtime_error
/// naming the file at fault.
std::unique_ptr<device::HapticDevice> make_device(const std::string& name, const PlannedOn& planned);

/// The tube's hand, and what is asked for besides.
struct SecondHand {
  std::unique_ptr<device::HapticDevice> device;  ///< null: the blade's device in turn
  device::ActionPlan actions;
};
/// The one device takes blade and tube in turn.
constexpr const char* kSameDevice = "same";
/// `name` as make_device's, of a script or record its second hand; or kSameDevice; or empty: that of the script or
/// record `first` where it has one, else kSameDevice. For scenarios with an intubation.
SecondHand make_second_hand(const std::string& name, const std::string& first, const PlannedOn& planned);
/// What was asked for beside the hands, where `name` is a record's; of any other nothing.
device::ActionPlan recorded_actions(const std::string& name);
/// Throws UnknownDevice when `name` is none that make_second_hand takes.
void check_second_name(const std::string& name);

/// The guard on a device; one with axes of its own begins at `start`, in the operator's view. The device must outlive
/// it. Throws std::runtime_error naming a landmark that is missing.
std::unique_ptr<device::GuardedDevice> guard_device(device::HapticDevice& device, const device::GuardSettings& settings,
                                                    const pipeline::PatientPackage& package,
                                                    const device::Keyframe& start);
/// Where a person's hand begins: as the scripted expert does, in front of the mouth, blade ready.
device::Keyframe starting_pose(const pipeline::PatientPackage& package, const curricula::Scenario& scenario);
/// And the tube's grip: to the right of it.
device::Keyframe starting_tube_pose(const pipeline::PatientPackage& package,
                                    const engine::IntubationDescription& intubation);

}  // namespace vallecula::gui

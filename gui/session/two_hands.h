// The hands of a trial: their devices made and guarded, joined to the engine's port.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "engine/scene.h"
#include "gui/session/device_choice.h"
#include "gui/session/hands_port.h"
#include "gui/session/holder.h"

namespace vallecula::gui {

struct HandsSetup {
  std::string device;  ///< KIND[:ARG]
  std::string second;  ///< of the tube's hand, or kSameDevice; empty: a script's or a record's own, else kSameDevice
  /// Devices of the caller's own, made anew where a script would be, instead of the names.
  std::function<std::unique_ptr<device::HapticDevice>()> own_device, own_second_device;
};

/// Life: construct -> begin -> (let_go -> renew_scripts -> begin) for every further attempt -> let_go.
class TwoHands {
 public:
  /// The limits of the devices are written into `scene`; hands of a scene with an intubation are planned on it. Throws
  /// UnknownDevice, or std::runtime_error with one message. What is given by reference must outlive it.
  TwoHands(const HandsSetup& setup, const pipeline::PatientPackage& package, const curricula::Scenario& scenario,
           engine::SceneDescription& scene);

  /// A script starts again from its first line, faults forgotten; a live device stays (the window holds it).
  void renew_scripts();
  /// The port of a new attempt.
  engine::HapticPort& begin();
  /// Of the attempt that was begun, before its first tick: HandsPort::lead_in.
  void lead_in(device::Trajectory way, std::int64_t ticks) { port_->lead_in(std::move(way), ticks); }
  bool led_in() const { return port_ && port_->led_in(); }
  /// No hand is left with the last force.
  void let_go();

  device::HapticDevice& device() { return *device_; }
  /// Of the tube's hand; null: the one device takes turns, or there is no tube.
  device::HapticDevice* second_device() { return second_.device.get(); }
  HandActions& actions() { return actions_; }
  bool takes_turns() const { return intubation_ && !second_.device; }
  Tool in_hand() const { return port_ ? port_->in_hand() : Tool::blade; }

  /// As LogHeader::device_kind: what is done with two devices is not pooled with what is done with one.
  std::string kind() const;
  /// What stands between the engine and the devices.
  std::map<std::string, double> settings() const;

  // --- any thread ----------------------------------------------------------------------------------------------------
  /// Why it is paused and what to do; empty: it is not.
  std::string pause() const;
  void confirm();
  /// Pauses every hand until all have let go and the hand confirms; another attempt stays held. Not while begin() or
  /// renew_scripts() runs.
  void freeze(Holder holder, bool on);
  bool frozen() const { return held_by_ != 0; }
  bool frozen_by(Holder holder) const { return (held_by_ & static_cast<std::uint32_t>(holder)) != 0; }
  /// It is a person who keeps it paused, or has and the hand has not confirmed yet: no device is away.
  bool held() const;
  /// Name of the fault of the device that pauses it, as LogFooter::pause_faults; empty: it is not known. Of a trial
  /// that somebody holds: "frozen" by an instructor, "expert_shown", "list_of_keys", or "no_picture".
  std::string pause_fault() const;
  /// Nothing more will come of the scripts.
  bool finished(double time_s) const;

 private:
  void make_device_of(bool second);
  bool first_is_scripted() const;
  bool second_is_scripted() const;

  const HandsSetup setup_;
  const pipeline::PatientPackage& package_;
  const curricula::Scenario& scenario_;
  const std::optional<engine::IntubationDescription> intubation_;
  std::unique_ptr<device::HapticDevice> device_;
  SecondHand second_;
  device::GuardSettings guarding_, second_guarding_;
  std::unique_ptr<device::GuardedDevice> guard_, second_guard_;
  std::unique_ptr<HandsPort> port_;
  HandActions actions_;
  std::mutex holding_;                       ///< by two at once
  std::atomic<std::uint32_t> held_by_{0};    ///< bits of Holder
  std::atomic<std::uint32_t> last_held_{0};  ///< as held_by_ was when somebody last began to hold it
};

}  // namespace vallecula::gui

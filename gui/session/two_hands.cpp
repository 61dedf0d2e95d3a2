#include "gui/session/two_hands.h"

#include "gui/session/fault_report.h"
#include "gui/session/log_conversion.h"
#include "gui/session/user_settings.h"

namespace vallecula::gui {

namespace {

bool pauses(const device::GuardedDevice& guard) {
  return guard.state() == device::GuardState::paused || guard.state() == device::GuardState::confirming;
}

/// The first button that is not the clutch.
std::uint32_t change_button(const device::GuardSettings& guarding) { return guarding.clutch_button == 1u ? 2u : 1u; }

}  // namespace

TwoHands::TwoHands(const HandsSetup& setup, const pipeline::PatientPackage& package,
                   const curricula::Scenario& scenario, engine::SceneDescription& scene)
    : setup_(setup), package_(package), scenario_(scenario), intubation_(scene.intubation) {
  if (!intubation_ && (!setup_.second.empty() || setup_.own_second_device))
    throw std::runtime_error("scenario '" + scenario.id + "' has no tube, and so no second hand: leave out --second");
  make_device_of(false);
  make_device_of(true);
  guarding_ = guard_settings(device_->info());
  if (guarding_.limits.peak_force_n > 0.0) scene.haptics.device_limit_n = device::largest_model_force_n(guarding_);
  if (!intubation_) return;
  second_guarding_ = second_.device ? guard_settings(second_.device->info()) : guarding_;
  if (second_guarding_.limits.peak_force_n > 0.0)
    scene.intubation->device_limit_n = device::largest_model_force_n(second_guarding_);
}

bool TwoHands::first_is_scripted() const { return setup_.own_device || is_scripted(setup_.device); }
bool TwoHands::second_is_scripted() const {
  return setup_.own_second_device || is_scripted(setup_.second.empty() ? setup_.device : setup_.second);
}

void TwoHands::make_device_of(bool second) {
  const PlannedOn planned{package_, scenario_, intubation_ ? &*intubation_ : nullptr};
  if (!second)
    device_ = setup_.own_device ? setup_.own_device() : make_device(setup_.device, planned);
  else if (setup_.own_second_device)
    second_ = {setup_.own_second_device(), {}};
  else if (intubation_)
    second_ = make_second_hand(setup_.second, setup_.device, planned);
  else
    second_ = {nullptr, recorded_actions(setup_.device)};
}

void TwoHands::renew_scripts() {
  port_.reset();
  if (first_is_scripted()) {
    guard_.reset();
    make_device_of(false);
  }
  if (second_is_scripted()) {
    second_guard_.reset();
    make_device_of(true);
  }
}

engine::HapticPort& TwoHands::begin() {
  port_.reset();
  actions_.release_all();
  if (guard_)
    guard_->begin_anew();
  else
    guard_ = guard_device(*device_, guarding_, package_, starting_pose(package_, scenario_));
  guard_->freeze(frozen());
  if (!intubation_) {
    port_ = std::make_unique<HandsPort>(*guard_, second_.actions, actions_);
    return *port_;
  }
  const device::Keyframe start = starting_tube_pose(package_, *intubation_);
  if (!second_.device) {
    port_ = std::make_unique<HandsPort>(*guard_, pose_of(start), change_button(guarding_), second_.actions, actions_);
    return *port_;
  }
  if (second_guard_)
    second_guard_->begin_anew();
  else
    second_guard_ = guard_device(*second_.device, second_guarding_, package_, start);
  second_guard_->freeze(frozen());
  port_ = std::make_unique<HandsPort>(*guard_, *second_guard_, second_.actions, actions_);
  return *port_;
}

void TwoHands::let_go() {
  if (guard_) guard_->let_go();
  if (second_guard_) second_guard_->let_go();
}

std::string TwoHands::kind() const {
  const std::string kind = device_->info().kind;
  if (!second_.device) return kind;
  // Of one script or record both hands.
  return setup_.second.empty() && !setup_.own_second_device ? kind : kind + "+" + second_.device->info().kind;
}

std::map<std::string, double> TwoHands::settings() const {
  std::map<std::string, double> settings = settings_of(guarding_);
  if (!second_.device) return settings;
  for (const auto& [name, value] : settings_of(second_guarding_)) settings["second_" + name] = value;
  return settings;
}

std::string TwoHands::pause() const {
  if (!guard_) return "";
  // Whoever waits should know for whom.
  if (guard_->state() == device::GuardState::paused && guard_->fault() == device::DeviceFault::frozen) {
    if (frozen_by(Holder::instructor)) return "The trial is held by the instructor: it goes on when they let it go.";
    if (frozen_by(Holder::expert)) return "The trial is held by you for as long as you look at the expert (G).";
    if (frozen_by(Holder::reader)) return "The trial is held by you for as long as the list of keys is open.";
    if (frozen_by(Holder::picture)) return "No picture comes to the screen: the trial waits.";
  }
  if (guard_->state() == device::GuardState::confirming && guard_->fault() == device::DeviceFault::frozen &&
      last_held_ == static_cast<std::uint32_t>(Holder::picture))
    return "The picture is back. To go on press Enter or a button of the device, or hold the grey blade on the steel "
           "one for half a second.";
  const std::string words = pause_words(guard_->state(), guard_->fault(), device_->confirms_itself());
  if (!words.empty() || !second_guard_) return words;
  const std::string of_second =
      pause_words(second_guard_->state(), second_guard_->fault(), second_.device->confirms_itself());
  return of_second.empty() ? "" : "The tube's hand: " + of_second;
}

void TwoHands::confirm() {
  guard_->confirm();
  if (second_guard_) second_guard_->confirm();
}

void TwoHands::freeze(Holder holder, bool on) {
  const auto bit = static_cast<std::uint32_t>(holder);
  const std::lock_guard<std::mutex> lock(holding_);
  on ? held_by_ |= bit : held_by_ &= ~bit;
  if (on) last_held_ = held_by_.load();
  guard_->freeze(frozen());
  if (second_guard_) second_guard_->freeze(frozen());
}

bool TwoHands::held() const {
  constexpr auto kPicture = static_cast<std::uint32_t>(Holder::picture);
  if ((held_by_ & ~kPicture) != 0) return true;
  if (frozen()) return false;  // nobody may be there any more
  bool waits = false;
  for (const device::GuardedDevice* guard : {guard_.get(), second_guard_.get()}) {
    if (guard == nullptr || !pauses(*guard)) continue;
    if (guard->fault() != device::DeviceFault::frozen) return false;
    waits = true;
  }
  return waits;
}

std::string TwoHands::pause_fault() const {
  const bool second = second_guard_ && pauses(*second_guard_) && !pauses(*guard_);
  const device::HapticDevice& device = second ? *second_.device : *device_;
  const device::DeviceFault fault = (second ? second_guard_ : guard_)->fault();
  if (fault != device::DeviceFault::frozen) return device.confirms_itself() ? "" : device::name_of(fault);
  const std::uint32_t held_by = last_held_;  // whoever it was may have let go again already
  const auto is = [&](Holder holder) { return (held_by & static_cast<std::uint32_t>(holder)) != 0; };
  if (is(Holder::instructor)) return device::name_of(fault);
  return is(Holder::expert) ? "expert_shown" : is(Holder::reader) ? "list_of_keys" : "no_picture";
}

bool TwoHands::finished(double time_s) const {
  const double played_s = time_s - (port_ ? port_->waited_s() : 0.0);
  return device_->finished(played_s) &&
         (!second_.device || !second_is_scripted() || second_.device->finished(played_s));
}

}  // namespace vallecula::gui

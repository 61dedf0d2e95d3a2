#include "gui/session/hands_port.h"

#include <utility>

#include "engine/haptics/coupling.h"

namespace vallecula::gui {

namespace {

constexpr std::uint32_t kDeviceButtons = 0xffff;  // the bits above are engine::Action's
/// A bond that a pause has cut is whole again after engine::kRecoveryTime; until then the tissue pushes the blade off.
constexpr double kReturnS = 1.0;
/// A pause leaves these as they are; the others are asked for in time, which stands.
constexpr std::uint32_t kStandingActions = engine::kActionStyletOut | engine::kActionCatheter | engine::kEyeActions |
                                           engine::kActionExtend | engine::kActionAided;

static_assert(engine::kActionBreath == 1u << device::kFirstActionBit &&
                  (engine::kAllActions & ~engine::kInstructorActions) == ((1u << device::kActionWords) - 1)
                                                                             << device::kFirstActionBit &&
                  engine::kActionSuction == engine::kActionBreath << 1 &&
                  engine::kActionPress == engine::kActionBreath << 2 &&
                  engine::kActionStyletOut == engine::kActionBreath << 3 &&
                  engine::kActionCatheter == engine::kActionBreath << 4 &&
                  engine::kActionEyeRight == engine::kActionBreath << 5 &&
                  engine::kActionEyeLeft == engine::kActionBreath << 6 &&
                  engine::kActionEyeUp == engine::kActionBreath << 7 &&
                  engine::kActionEyeDown == engine::kActionBreath << 8 &&
                  engine::kActionExtend == engine::kActionBreath << 9,
              "a script's words are the engine's actions");

engine::Pose pose_of(const device::DeviceReading& reading) {
  const auto& p = reading.position_m;
  const auto& q = reading.rotation_wxyz;
  return {engine::Vec3(p[0], p[1], p[2]), engine::Quat(q[0], q[1], q[2], q[3])};
}

void see(device::GuardedDevice& device, const engine::Pose& tool) {
  const engine::Vec3& p = tool.position;
  const engine::Quat& q = tool.rotation;
  device.see_tool({p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()});
}

}  // namespace

engine::Pose pose_of(const device::Keyframe& at) {
  device::DeviceReading reading;
  reading.position_m = at.position_m;
  reading.rotation_wxyz = at.rotation_wxyz;
  return pose_of(reading);
}

HandsPort::HandsPort(device::GuardedDevice& device, const engine::Pose& tube, std::uint32_t change_button,
                     const device::ActionPlan& plan, const HandActions& actions)
    : first_(device),
      held_(tube),
      takes_turns_(true),
      plan_(&plan),
      actions_(&actions),
      change_button_(change_button),
      changes_(actions.changes()),
      holds_(actions.holds()) {}

void HandsPort::lead_in(device::Trajectory way, std::int64_t ticks) {
  way_ = std::move(way);
  led_ticks_ = 0;
  lead_ticks_ = ticks;
  led_in_ = ticks > 0;
}

engine::PortInput HandsPort::read(double time_s) noexcept {
  double waited_s = waited_s_.load(std::memory_order_relaxed);
  if (first_.waits() || (second_ != nullptr && second_->waits())) waited_s += time_s - now_s_;
  waited_s_.store(waited_s, std::memory_order_relaxed);
  now_s_ = time_s;
  const std::uint32_t holds = actions_ != nullptr ? actions_->holds() : 0;  // before the reading: the device is there
  const device::DeviceReading reading = first_.read(time_s, waited_s);
  const engine::Pose device = pose_of(reading);
  engine::PortInput input;
  input.pose = device;
  input.buttons = reading.buttons;
  input.valid = reading.valid;
  if (second_ != nullptr) {
    const device::DeviceReading other = second_->read(time_s, waited_s);
    input.second_pose = pose_of(other);
    input.valid = input.second_valid = reading.valid && other.valid;
  }
  take_hold(holds, device);
  if (led_in()) {
    lead(device, input);
  } else if (takes_turns_) {
    take_turns(reading, input);
  } else {
    HeldTools shown = held_;
    shown.follow(device);
    input.pose = shown.blade();
  }
  if (plan_ == nullptr) return input;
  std::uint32_t asked = plan_->at(time_s - waited_s) | actions_->bits();
  if (!input.valid) asked &= kStandingActions;
  input.buttons = (reading.buttons & kDeviceButtons) | asked;
  return input;
}

void HandsPort::take_hold(std::uint32_t holds, const engine::Pose& device) noexcept {
  if (holds == holds_) return;
  holds_ = holds;
  if (held_.in_hand() == Tool::blade && seen_ && !led_in() && engine::usable(device)) held_.take_blade(*seen_, device);
}

void HandsPort::lead(const engine::Pose& device, engine::PortInput& input) noexcept {
  const bool works = input.valid && engine::usable(device);
  if (works) ++led_ticks_;
  const double share = static_cast<double>(led_ticks_) / static_cast<double>(lead_ticks_);
  input.pose = pose_of(way_->at(way_->start_s() + share * (way_->end_s() - way_->start_s())));
  if (takes_turns_) {
    input.second_pose = held_.tube();
    input.second_valid = input.valid;
  }
  changes_ = actions_ != nullptr ? actions_->changes() : 0;
  buttons_ = input.buttons;  // held at the hand-over, a button is no new press
  if (works) device_ = device;
  valid_ = works;
  if (led_ticks_ < lead_ticks_) return;
  held_.take_blade(input.pose, device);
  led_in_.store(false, std::memory_order_relaxed);
}

/// A lifted blade that no hand has would be asked for more than the device's limit, for ever, if it were held where it
/// was left while its bond is weak: it sets out from where the scene has it.
engine::Pose HandsPort::back_in_place(const engine::Pose& blade) noexcept {
  if (!returns_from_) return blade;
  const double share = (now_s_ - returns_at_s_) / kReturnS;
  if (share >= 1.0) {
    returns_from_.reset();
    return blade;
  }
  return {returns_from_->position + share * (blade.position - returns_from_->position),
          returns_from_->rotation.slerp(share, blade.rotation)};
}

void HandsPort::take_turns(const device::DeviceReading& reading, engine::PortInput& input) noexcept {
  const std::uint32_t changes = actions_->changes();
  // The press that ends a pause changes nothing.
  const bool pressed = (reading.buttons & ~buttons_ & change_button_) != 0 && valid_;
  const bool works = reading.valid && engine::usable(input.pose);
  if (works && (pressed || ((changes - changes_) & 1u) != 0)) {
    held_.follow(input.pose);
    held_.change(input.pose);
  }
  // Through a pause the tool in the hand is shown where the hand is; a pose that is none comes through to be recorded.
  HeldTools shown = held_;
  shown.follow(input.pose);
  if (works) {
    held_ = shown;
    device_ = input.pose;
  }
  if (works && !valid_ && seen_ && held_.in_hand() == Tool::tube) {
    returns_from_ = seen_;
    returns_at_s_ = now_s_;
  }
  if (held_.in_hand() == Tool::blade) returns_from_.reset();
  changes_ = changes;
  buttons_ = reading.buttons;
  valid_ = works;
  in_hand_.store(held_.in_hand(), std::memory_order_relaxed);
  input.pose = works ? back_in_place(shown.blade()) : shown.blade();
  input.second_pose = shown.tube();
  input.second_valid = reading.valid;
}

void HandsPort::see_tool(const engine::Pose& tool) noexcept {
  seen_ = tool;
  if (held_.in_hand() == Tool::blade && !led_in())
    see(first_, held_.device_for(tool));
  else if (valid_)
    see(first_, device_);  // where the tube's grip is, no port tells: the hand goes on from where it was
}

void HandsPort::write(const engine::Vec3& force_n) noexcept {
  if (held_.in_hand() != Tool::blade) return;
  const engine::Vec3 felt = led_in() ? engine::Vec3(engine::Vec3::Zero()) : force_n;
  first_.write({felt.x(), felt.y(), felt.z()});
}

void HandsPort::write_second(const engine::Vec3& force_n) noexcept {
  if (second_ != nullptr)
    second_->write({force_n.x(), force_n.y(), force_n.z()});
  else if (takes_turns_ && held_.in_hand() == Tool::tube)
    first_.write({force_n.x(), force_n.y(), force_n.z()});
}

}  // namespace vallecula::gui

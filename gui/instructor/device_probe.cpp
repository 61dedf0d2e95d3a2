#include "gui/instructor/device_probe.h"

#include <pthread.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "device/rotation.h"

namespace vallecula::gui {
namespace {

using Clock = std::chrono::steady_clock;
using device::Vector;

constexpr std::chrono::milliseconds kPeriod{1};
/// After a stand this long the ticks that were missed are left out, not made up for in a burst.
constexpr std::chrono::milliseconds kLongestCatchUp{20};
constexpr int kServoPriority = 80;
constexpr double kRampS = 0.15;  ///< in which a push grows and falls

double push_for(const device::DeviceInfo& info) {
  const double bears_n = info.continuous_force_n > 0.0 ? info.continuous_force_n : info.peak_force_n;
  return std::min(kPushN, 0.5 * bears_n);
}

/// The operator's axes in the patient as the guard has them: right -x, up -y, towards the person +z.
Vector seen_by_operator(const Vector& patient) { return {-patient[0], -patient[1], patient[2]}; }

double seconds_of(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

DeviceProbe::DeviceProbe(std::unique_ptr<device::HapticDevice> device, const device::GuardSettings& settings)
    : device_(std::move(device)),
      info_(device_->info()),
      push_n_(push_for(info_)),
      model_push_n_(push_n_ / (settings.limits.force_scale * (info_.own_axes ? settings.map.motion_scale : 1.0))),
      guard_(*device_, settings) {
  guard_.set_view_axes({-1, 0, 0}, {0, -1, 0});
  guard_.begin_at({0, 0, 0}, {1, 0, 0, 0});
  thread_ = std::thread([this] { run(); });
}

DeviceProbe::~DeviceProbe() {
  stop_ = true;
  thread_.join();
  guard_.let_go();
}

int DeviceProbe::centre() {
  ++wanted_.centre;
  asked_.publish(wanted_);
  return wanted_.centre;
}

int DeviceProbe::measure() {
  ++wanted_.measure;
  asked_.publish(wanted_);
  return wanted_.measure;
}

void DeviceProbe::push(int axis, int sign) {
  ++wanted_.push;
  wanted_.axis = axis;
  wanted_.sign = sign;
  asked_.publish(wanted_);
}

double DeviceProbe::push_at(double seconds) const noexcept {
  const double grown = std::clamp(std::min(seconds, kPushS - seconds) / kRampS, 0.0, 1.0);
  return model_push_n_ * grown * grown * (3.0 - 2.0 * grown);
}

void DeviceProbe::run() {
  ProbeState state;
  sched_param priority{};  // as a trial's servo has it, so that the rate is that of a trial
  priority.sched_priority = kServoPriority;
  state.real_time = pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0;
  Asked heard;
  Vector centre{0, 0, 0}, push_began{0, 0, 0};
  bool pushing_now = false, centred = false;
  const auto began = Clock::now();
  auto due = began, measured_from = began, push_from = began;
  while (!stop_) {
    due += kPeriod;
    std::this_thread::sleep_until(due);
    const auto now = Clock::now();
    const device::DeviceReading tool = guard_.read(seconds_of(now - began));
    const Vector seen = seen_by_operator(tool.position_m);
    const Asked asked = asked_.newest();
    if (asked.centre != heard.centre || !centred) {
      centre = seen;
      centred = tool.valid;
    }
    if (asked.measure != heard.measure) {
      measured_from = now;
      state.ticks = state.late = 0;
    }
    if (asked.push != heard.push) {
      pushing_now = true;
      push_from = now;
      push_began = seen;
      state.pushed_n = 0.0;
      state.pushed_away = false;
    }
    heard = asked;

    Vector force{0, 0, 0};
    if (pushing_now) {
      const double seconds = seconds_of(now - push_from);
      state.pushed_away = device::length(device::subtract(seen, push_began)) > kPushedAwayM;
      if (state.pushed_away || seconds >= kPushS || guard_.state() != device::GuardState::working) {
        pushing_now = false;
        ++state.pushes;
      } else {
        force[static_cast<std::size_t>(asked.axis)] = asked.sign * push_at(seconds);
        force = seen_by_operator(force);  // the same change of signs both ways
      }
    }
    const Vector sent = guard_.write(force);
    if (pushing_now) state.pushed_n = std::max(state.pushed_n, device::length(sent));

    const auto written = Clock::now();
    ++state.ticks;
    if (written - due > kPeriod) ++state.late;
    if (written - due > kLongestCatchUp) due = written;
    state.measured_s = seconds_of(written - measured_from);
    state.centres = asked.centre;
    state.measures = asked.measure;
    state.tool_m = device::subtract(seen, centre);
    state.buttons = tool.buttons;
    state.guard = guard_.state();
    const bool away = state.guard == device::GuardState::paused || state.guard == device::GuardState::confirming;
    state.fault = away ? guard_.fault() : device::DeviceFault::none;
    state.calibration = device_->calibration();
    published_.publish(state);
  }
}

}  // namespace vallecula::gui

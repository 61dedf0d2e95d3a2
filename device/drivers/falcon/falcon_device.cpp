#include "device/drivers/falcon/falcon_device.h"

#include <pthread.h>
#include <sys/prctl.h>

#include <algorithm>

#include "device/trajectory.h"

namespace vallecula::device {
namespace {

using namespace std::chrono_literals;

constexpr auto kPeriod = 1ms;
constexpr int kExchangeMs = 10;
/// Without a new force for so long the servo is not there: no force.
constexpr auto kWishHolds = 50ms;
/// So many turns it takes until force is whole again after it was withheld: a turn is a millisecond, on a busy bus
/// longer.
constexpr int kRampTurns = 100;
/// Without a report for so long the fault is told; after the second time the Falcon is opened anew.
constexpr auto kSilent = 50ms, kGiveUp = 1000ms;
constexpr auto kLookAgain = 500ms;
/// The driver's thread has not come round for so long.
constexpr auto kLate = 50ms;

DeviceInfo falcon_info(const std::string& serial) {
  DeviceInfo info;
  info.kind = "falcon";
  info.model = "Novint Falcon";
  info.serial = serial;
  info.driver = "libusb";
  info.peak_force_n = falcon::kPeakForce;
  info.workspace_m = {falcon::kWorkspace, falcon::kWorkspace, falcon::kWorkspace};
  info.sensed_dof = 3;
  info.actuated_dof = 3;
  info.own_axes = true;
  return info;
}

}  // namespace

std::vector<FoundDevice> find_falcon() {
  std::vector<FoundDevice> found;
  try {
    falcon::FalconUsb usb;
    for (const falcon::UsbFalcon& one : usb.list()) {
      FoundDevice device;
      device.info = falcon_info(one.serial);
      device.calibration = Calibration::needs_hand;
      device.problem = one.problem.what;
      device.mend = one.problem.mend;
      if (device.problem.empty() || one.problem.ours) device.name = "falcon";
      if (device.problem.empty()) {
        try {
          if (falcon::read_firmware("").empty()) {
            device.problem =
                "no firmware file was found: it works only while it still runs the firmware another "
                "program gave it";
            device.mend = falcon::kFirmwareAdvice;
          }
        } catch (const DeviceError& error) {
          device.problem = error.what();
          device.mend = falcon::kFirmwareAdvice;
        }
      }
      found.push_back(device);
    }
  } catch (const DeviceError&) {
    // Without libusb no Falcon is seen; that is no fault of a device.
  }
  return found;
}

FalconDevice::FalconDevice(const std::string& firmware)
    : firmware_(falcon::read_firmware(firmware)), wish_(Wish{}), reading_(DeviceReading{}) {
  if (const falcon::OpenProblem problem = usb_.open(); !problem.what.empty())
    throw DeviceError("device falcon: " + problem.what + "; " + problem.mend);
  falcon::start(usb_, firmware_, stop_);
  info_ = falcon_info(usb_.serial());
  good_at_ = Clock::now();
  beat(good_at_);
  thread_ = std::thread([this] { run(); });
}

FalconDevice::~FalconDevice() {
  {
    const std::lock_guard<std::mutex> lock(waiting_);
    stop_.store(true);
  }
  stopped_.notify_all();
  thread_.join();
}

// --- the servo's thread ----------------------------------------------------------------------------------------------

DeviceReading FalconDevice::read(double) noexcept {
  DeviceReading reading = reading_.newest();
  reading.valid = fault() == DeviceFault::none;
  return reading;
}

void FalconDevice::write(const std::array<double, 3>& force_n) noexcept {
  not_finite_.store(!std::isfinite(length(force_n)), std::memory_order_relaxed);
  wished_.force_n = force_n;
  ++wished_.count;
  wish_.publish(wished_);
}

DeviceFault FalconDevice::fault() const noexcept {
  const DeviceFault link = link_fault_.load(std::memory_order_relaxed);
  if (link != DeviceFault::none) return link;
  const Clock::time_point beat{Clock::duration(beat_.load(std::memory_order_relaxed))};
  if (Clock::now() - beat > kLate) return DeviceFault::servo_late;
  if (!homed_.load(std::memory_order_relaxed)) return DeviceFault::not_calibrated;
  if (overdue_.load(std::memory_order_relaxed)) return DeviceFault::servo_late;
  return not_finite_.load(std::memory_order_relaxed) ? DeviceFault::non_finite_command : DeviceFault::none;
}

// --- the driver's thread ---------------------------------------------------------------------------------------------

void FalconDevice::run() noexcept {
  prctl(PR_SET_TIMERSLACK, 1);
  const sched_param priority{50};  // below the servo's; where it is not permitted, a late thread is told as a fault
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
  auto next = Clock::now();
  while (!stop_.load(std::memory_order_relaxed)) {
    if (!usb_.is_open()) {
      reopen();
      next = Clock::now();
      continue;
    }
    tick();
    next = std::max(next + kPeriod, Clock::now() - kPeriod);  // what was missed is not caught up
    std::this_thread::sleep_until(next);
  }
  let_go();
}

Vector FalconDevice::force_now(Clock::time_point now) noexcept {
  const Wish& wish = wish_.newest();
  if (wish.count != wish_count_) {
    wish_count_ = wish.count;
    wish_at_ = now;
  }
  const bool overdue = now - wish_at_ >= kWishHolds && wish.force_n != Vector{0, 0, 0};
  overdue_.store(overdue, std::memory_order_relaxed);
  if (!clean_ || !homed_.load(std::memory_order_relaxed) || overdue || !std::isfinite(length(wish.force_n))) {
    turns_shown_ = 0;
    return {0, 0, 0};
  }
  turns_shown_ = std::min(turns_shown_ + 1, kRampTurns);
  return scale(shortened_or_zero(wish.force_n, falcon::kPeakForce), turns_shown_ / static_cast<double>(kRampTurns));
}

void FalconDevice::tick() noexcept {
  falcon::Command command;
  command.lights = homed_.load(std::memory_order_relaxed) ? falcon::kGreenLight : falcon::kRedLight;
  const auto torques = falcon::leg_torques(position_, force_now(Clock::now()));
  if (torques) {
    command.motors = falcon::motor_commands(*torques);
  } else {
    turns_shown_ = 0;
  }

  const falcon::Transfer result = falcon::exchange(usb_, reader_, command, kExchangeMs);
  const auto now = Clock::now();
  beat(now);
  clean_ = result == falcon::Transfer::done && take(reader_.newest(), now);
  if (clean_) {
    good_at_ = now;
    link_fault_.store(DeviceFault::none, std::memory_order_relaxed);
  } else if (result == falcon::Transfer::gone) {
    lose(DeviceFault::unplugged);
  } else if (now - good_at_ > kGiveUp) {
    lose(DeviceFault::communication_lost);
  } else if (now - good_at_ > kSilent) {
    link_fault_.store(DeviceFault::communication_lost, std::memory_order_relaxed);
  }
}

/// False when the report is held back; the pose then stays.
bool FalconDevice::take(const falcon::Report& report, Clock::time_point now) noexcept {
  DeviceReading reading;
  reading.buttons = report.buttons;
  const bool homed = report.homed == falcon::kAllHomed;
  if (homed) {
    const double now_ms = std::chrono::duration<double, std::milli>(now.time_since_epoch()).count();
    if (!homed_.load(std::memory_order_relaxed)) plausibility_.reset();  // the counts begin anew
    if (!plausibility_.accepts(report.encoders, now_ms)) return false;
    falcon::Angles angles{};
    for (int leg = 0; leg < 3; ++leg) angles[leg] = falcon::leg_angle(report.encoders[leg]);
    auto position = falcon::position_of(angles, position_);
    if (!position) position = falcon::position_of(angles);
    if (!position) return false;
    position_ = *position;
  }
  reading.position_m = position_;
  reading_.publish(reading);
  homed_.store(homed, std::memory_order_relaxed);
  return true;
}

void FalconDevice::lose(DeviceFault fault) noexcept {
  link_fault_.store(fault, std::memory_order_relaxed);
  homed_.store(false, std::memory_order_relaxed);
  clean_ = false;
  if (fault != DeviceFault::unplugged) let_go();
  usb_.close();
}

void FalconDevice::reopen() noexcept {
  DeviceFault fault = DeviceFault::communication_lost;
  try {
    const falcon::OpenProblem problem = usb_.open();
    if (problem.what.empty()) {
      fault = DeviceFault::driver_error;
      falcon::start(usb_, firmware_, stop_);
      reader_.reset();
      good_at_ = Clock::now();  // the fault is cleared by the first report
      beat(good_at_);
      return;
    }
    if (!problem.there) fault = DeviceFault::unplugged;
  } catch (const std::exception&) {
    usb_.close();
  }
  link_fault_.store(fault, std::memory_order_relaxed);
  std::unique_lock<std::mutex> lock(waiting_);
  stopped_.wait_for(lock, kLookAgain, [this] { return stop_.load(std::memory_order_relaxed); });
}

/// No force and no light, said twice in case the first is lost.
void FalconDevice::let_go() noexcept {
  for (int time = 0; time < 2 && usb_.is_open(); ++time) {
    if (falcon::exchange(usb_, reader_, {}, kExchangeMs) == falcon::Transfer::gone) break;
  }
}

}  // namespace vallecula::device

#include "device/drivers/hdapi/hd_device.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <thread>

#include "device/drivers/hdapi/hd_library.h"

namespace vallecula::device::hdapi {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// Until the first turns of the library's loop have shown where the device stands.
DeviceFault wait_ready(const Channel& channel, std::chrono::milliseconds longest) {
  const auto until = std::chrono::steady_clock::now() + longest;
  while (channel.fault() != DeviceFault::none && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(2ms);
    if (channel.calibration() == Calibration::needs_hand) break;  // a person's turn
  }
  return channel.fault();
}

/// The names that the vendor's set-up program wrote; each may be given as touch:NAME.
std::vector<std::string> names_set_up() {
  constexpr std::size_t kMost = 8;
  std::vector<std::string> names;
  const char* home = std::getenv("GTDD_HOME");
  const fs::path folder = fs::path(home != nullptr ? home : "/usr/share/3DSystems") / "config";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".config") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  if (names.size() > kMost) names.resize(kMost);
  return names;
}

FoundDevice told(const Scheduler::Opened& open) {
  FoundDevice found;
  found.name = open.name.empty() ? "touch" : "touch:" + open.name;
  found.info = open.info;
  found.calibration = open.channel->calibration();
  const DeviceFault fault = open.channel->fault();
  if (fault == DeviceFault::communication_lost) {
    found.problem = "it opens but gives no reading: another program may be using it";
    found.mend = "close the other program; else check the cable and the power";
  } else if (fault != DeviceFault::none) {
    found.problem = describe(fault);
  }
  return found;
}

/// What this program has open.
std::vector<FoundDevice> open_now() {
  std::vector<FoundDevice> found;
  const auto running = Scheduler::running();
  if (running == nullptr) return found;
  for (const Scheduler::Opened& one : running->opened()) found.push_back(told(one));
  return found;
}

FoundDevice told(const HdError& error, const std::string& name) {
  FoundDevice found;
  found.info.kind = "touch";
  found.info.model = name.empty() ? "Touch, Touch X" : name;
  found.info.driver = "libHD.so";
  found.info.own_axes = true;
  found.figures_known = false;
  found.problem = error.problem;
  found.mend = error.mend;
  return found;
}

}  // namespace

namespace {

/// Held while devices are listed, or one is opened.
std::mutex& touch_lock() {
  static std::mutex lock;
  return lock;
}

/// Under touch_lock().
std::vector<FoundDevice> ask_each() {
  std::vector<FoundDevice> found = open_now();
  if (!found.empty()) return found;
  std::vector<std::string> names = names_set_up();
  if (names.empty()) names.emplace_back();
  for (const std::string& name : names) {
    try {
      const auto scheduler = Scheduler::shared();
      const Scheduler::Opened open = scheduler->open(name);
      wait_ready(*open.channel, 300ms);
      found.push_back(told(open));
      scheduler->close(open.channel);
    } catch (const HdError& error) {
      found.push_back(told(error, name));
    }
  }
  return found;
}

Scheduler::Opened open_alone(Scheduler& scheduler, const std::string& name) {
  const std::lock_guard<std::mutex> alone(touch_lock());
  for (const Scheduler::Opened& one : scheduler.opened()) {
    if (one.name == name) throw HdError("the device is used by this program already", "End the trial that uses it");
  }
  return scheduler.open(name);
}

}  // namespace

std::vector<FoundDevice> ask_touch() {
  const std::lock_guard<std::mutex> alone(touch_lock());
  return ask_each();
}

HdDevice::HdDevice(const std::string& name) : scheduler_(Scheduler::shared()), opened_(open_alone(*scheduler_, name)) {
  wait_ready(*opened_.channel, 1000ms);
}

HdDevice::~HdDevice() { scheduler_->close(opened_.channel); }

DeviceReading HdDevice::read(double) noexcept {
  const Channel::State& state = opened_.channel->newest();
  DeviceReading reading;
  reading.position_m = state.pose.position_m;
  reading.rotation_wxyz = state.pose.rotation;
  reading.buttons = state.buttons;
  reading.valid = fault() == DeviceFault::none;
  return reading;
}

std::vector<FoundDevice> find_touch() {
  static std::vector<FoundDevice> last;
  static std::chrono::steady_clock::time_point asked;
  const std::lock_guard<std::mutex> alone(touch_lock());
  if (const auto open = open_now(); !open.empty()) return open;
  const auto now = std::chrono::steady_clock::now();
  if (last.empty() || now - asked >= kAskAgain) {
    last = ask_each();
    asked = std::chrono::steady_clock::now();
  }
  return last;
}

}  // namespace vallecula::device::hdapi

#include "device/drivers/spacemouse/spacemouse_device.h"

#include <hidapi.h>

#include <cerrno>
#include <chrono>
#include <set>

#include "device/drivers/open_trouble.h"
#include "device/drivers/spacemouse/spacemouse_models.h"

namespace vallecula::device {
namespace {

using namespace std::chrono_literals;

constexpr int kReadTimeoutMs = 20;  // the longest that ending the thread waits
constexpr auto kLookAgain = 500ms;
constexpr std::uint8_t kLedOn[] = {4, 1}, kLedOff[] = {4, 0};

/// Nodes this program has open: a node can be opened twice, and two hands on one cap are no two hands. Under
/// hid_lock().
std::set<std::string>& paths_in_use() {
  static std::set<std::string> paths;
  return paths;
}

SpaceMousePlace choose(const std::string& argument) {
  const std::lock_guard<std::mutex> guard(hid_lock());
  const std::vector<SpaceMousePlace> all = list_spacemice();
  const auto in_use = [](const SpaceMousePlace& place) { return paths_in_use().count(place.path) != 0; };
  if (all.empty()) {
    for (const SpaceMouseModel& model : spacemouse_models())
      if (taken_through_usbfs(model.vendor, model.product))
        throw DeviceError(std::string("spacemouse: another program holds the ") + model.name +
                          "; close the program that uses it");
    throw DeviceError("spacemouse: none is plugged in; plug one in and see `vallecula devices`");
  }
  std::size_t index = find_argument(all, argument);
  if (argument.empty())
    for (index = 0; index < all.size() && in_use(all[index]);) ++index;
  if (index == all.size() && argument.empty())
    throw DeviceError("spacemouse: every one that is plugged in is used by this program already; plug in another");
  if (index == all.size())
    throw DeviceError("spacemouse: there is no '" + argument + "' among the " + std::to_string(all.size()) +
                      " plugged in; `vallecula devices` lists them");
  if (in_use(all[index])) throw DeviceError("spacemouse: '" + argument + "' is used by this program already");
  return all[index];
}

}  // namespace

SpaceMouseDevice::SpaceMouseDevice(const std::string& argument, const RateSettings& settings)
    : place_(choose(argument)), rate_(settings) {
  {
    const std::lock_guard<std::mutex> guard(hid_lock());
    if (!open_at(place_.path)) {
      const int error = open_error(place_.path);
      const OpenTrouble trouble = open_trouble(error != 0 ? error : EIO);
      throw DeviceError("spacemouse: " + place_.model + ": " + trouble.problem + "; " + trouble.mend);
    }
  }
  thread_ = std::thread(&SpaceMouseDevice::run, this);
}

SpaceMouseDevice::~SpaceMouseDevice() {
  {
    const std::lock_guard<std::mutex> guard(waiting_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
  if (handle_ != nullptr) hid_write(handle_, kLedOff, sizeof(kLedOff));
  close_handle();
}

bool SpaceMouseDevice::open_at(const std::string& path) {
  handle_ = hid_open_path(path.c_str());
  if (handle_ == nullptr) return false;
  path_ = path;
  paths_in_use().insert(path);
  return true;
}

void SpaceMouseDevice::close_handle() {
  if (handle_ == nullptr) return;
  const std::lock_guard<std::mutex> guard(hid_lock());
  hid_close(handle_);
  handle_ = nullptr;
  paths_in_use().erase(path_);
}

void SpaceMouseDevice::look_for_it() {
  const std::lock_guard<std::mutex> guard(hid_lock());
  for (const SpaceMousePlace& found : list_spacemice()) {
    const bool same = found.vendor == place_.vendor && found.product == place_.product && found.serial == place_.serial;
    if (same && paths_in_use().count(found.path) == 0 && open_at(found.path)) return;
  }
}

void SpaceMouseDevice::hand_over(DeviceFault fault) {
  fault_.store(fault, std::memory_order_relaxed);
  handed_.publish({cap_, fault});
}

void SpaceMouseDevice::run() {
  std::uint8_t report[kLongestReport];
  bool lit = false;
  for (;;) {
    {
      std::unique_lock<std::mutex> guard(waiting_);
      if (handle_ == nullptr) wake_.wait_for(guard, kLookAgain, [this] { return stop_; });
      if (stop_) return;
    }
    if (handle_ == nullptr) {
      look_for_it();
      if (handle_ == nullptr) continue;
      lit = false;
      hand_over(DeviceFault::none);
    }
    if (!lit) hid_write(handle_, kLedOn, sizeof(kLedOn));  // a model without the lamp refuses it
    lit = true;
    const int size = hid_read_timeout(handle_, report, sizeof(report), kReadTimeoutMs);
    if (size > 0 && apply_report(report, static_cast<std::size_t>(size), cap_)) hand_over(DeviceFault::none);
    if (size < 0) {
      close_handle();
      cap_.translation = cap_.rotation = {0, 0, 0};
      cap_.buttons = 0;
      hand_over(DeviceFault::unplugged);
    }
  }
}

DeviceReading SpaceMouseDevice::read(double time_s) noexcept {
  const Handed& newest = handed_.newest();
  if (newest.fault == DeviceFault::none) return rate_.step(newest.cap, time_s);
  DeviceReading last = rate_.hold(time_s);
  last.valid = false;
  return last;
}

}  // namespace vallecula::device

#include "device/drivers/spacemouse/spacemouse_list.h"

#include <fcntl.h>
#include <hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "device/drivers/open_trouble.h"
#include "device/drivers/spacemouse/rate_control.h"
#include "device/drivers/spacemouse/spacemouse_models.h"

namespace vallecula::device {
namespace {

constexpr std::uint16_t kLogitechVendor = 0x046d;
/// Wired models are asked every 8 ms; wireless ones tell every 16 ms (check).
constexpr double kReportRateHz = 125.0;

/// Printable ASCII of what a device says of itself: it goes to terminals, tables and settings.
std::string plain(const wchar_t* text) {
  std::string out;
  for (; text != nullptr && *text != 0; ++text) out += *text > 32 && *text < 127 ? static_cast<char>(*text) : '_';
  return out;
}

void add_of_vendor(std::uint16_t vendor, std::vector<SpaceMousePlace>& all) {
  hid_device_info* const first = hid_enumerate(vendor, 0);
  for (const hid_device_info* one = first; one != nullptr; one = one->next) {
    const char* const name = spacemouse_name(one->vendor_id, one->product_id, one->usage_page, one->usage);
    if (name == nullptr || one->path == nullptr) continue;
    // An interface with several usages is listed once for each.
    if (std::any_of(all.begin(), all.end(), [one](const SpaceMousePlace& p) { return p.path == one->path; })) continue;
    all.push_back({one->path, name, plain(one->serial_number), one->vendor_id, one->product_id});
  }
  hid_free_enumeration(first);
}

FoundDevice found(const SpaceMousePlace& place) {
  FoundDevice one;
  one.info = spacemouse_info(place);
  if (const int error = open_error(place.path)) {
    const OpenTrouble trouble = open_trouble(error);
    one.problem = trouble.problem;
    one.mend = trouble.mend;
  }
  return one;
}

}  // namespace

std::mutex& hid_lock() {
  static std::mutex lock;
  return lock;
}

std::vector<SpaceMousePlace> list_spacemice() {
  std::vector<SpaceMousePlace> all;
  add_of_vendor(kLogitechVendor, all);
  add_of_vendor(k3DconnexionVendor, all);
  std::sort(all.begin(), all.end(), [](const SpaceMousePlace& a, const SpaceMousePlace& b) { return a.path < b.path; });
  return all;
}

int open_error(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return errno;
  ::close(file);
  return 0;
}

std::string spacemouse_argument(const std::vector<SpaceMousePlace>& all, std::size_t index) {
  if (all.size() == 1) return "";
  const std::string& serial = all[index].serial;
  const auto same =
      std::count_if(all.begin(), all.end(), [&serial](const SpaceMousePlace& other) { return other.serial == serial; });
  return serial.empty() || same > 1 ? std::to_string(index + 1) : serial;
}

std::size_t find_argument(const std::vector<SpaceMousePlace>& all, const std::string& argument) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!argument.empty() && all[i].serial == argument) return i;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (argument == std::to_string(i + 1)) return i;
  return all.size();
}

DeviceInfo spacemouse_info(const SpaceMousePlace& place) {
  const double edge = RateSettings{}.workspace_m;
  DeviceInfo info;
  info.kind = "spacemouse";
  info.model = place.model;
  info.serial = place.serial;
  info.driver = "hidapi";
  info.rate_hz = kReportRateHz;
  info.workspace_m = {edge, edge, edge};
  info.own_axes = true;
  return info;
}

std::vector<FoundDevice> find_spacemouse() {
  std::vector<SpaceMousePlace> all;
  {
    const std::lock_guard<std::mutex> guard(hid_lock());
    all = list_spacemice();
  }
  std::vector<FoundDevice> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    FoundDevice one = found(all[i]);
    if (one.problem.empty()) {
      const std::string argument = spacemouse_argument(all, i);
      one.name = one.info.kind + (argument.empty() ? "" : ":" + argument);
    }
    result.push_back(one);
  }
  // One that a program drives past the kernel has no hidraw node, and so is not in hidapi's list.
  for (const SpaceMouseModel& model : spacemouse_models()) {
    const auto listed = [&model](const SpaceMousePlace& p) {
      return p.vendor == model.vendor && p.product == model.product;
    };
    if (std::any_of(all.begin(), all.end(), listed) || !taken_through_usbfs(model.vendor, model.product)) continue;
    const OpenTrouble trouble = open_trouble(EBUSY);
    FoundDevice taken;
    taken.info = spacemouse_info({"", model.name, "", model.vendor, model.product});
    taken.problem = trouble.problem;
    taken.mend = trouble.mend;
    result.push_back(taken);
  }
  return result;
}

}  // namespace vallecula::device

#include "device/drivers/falcon/falcon_usb.h"

#include <libusb.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include "device/drivers/falcon/falcon_protocol.h"
#include "device/drivers/open_trouble.h"
#include "device/trajectory.h"

namespace vallecula::device::falcon {
namespace {

using Clock = std::chrono::steady_clock;
constexpr unsigned char kOut = 0x02, kIn = 0x81;
constexpr int kInterface = 0;
constexpr unsigned kControlMs = 100;
constexpr int kCancelMs = 200;

Transfer outcome(int error) noexcept {
  switch (error) {
    case LIBUSB_SUCCESS:
      return Transfer::done;
    case LIBUSB_ERROR_TIMEOUT:
      return Transfer::late;
    case LIBUSB_ERROR_NO_DEVICE:
      return Transfer::gone;
    default:
      return Transfer::failed;
  }
}

bool is_falcon(libusb_device* device) noexcept {
  libusb_device_descriptor about{};
  return libusb_get_device_descriptor(device, &about) == LIBUSB_SUCCESS && about.idVendor == kVendor &&
         about.idProduct == kProduct;
}

/// All devices of the bus, freed at the end of the scope.
struct DeviceList {
  explicit DeviceList(libusb_context* context) { count = libusb_get_device_list(context, &devices); }
  ~DeviceList() {
    if (devices != nullptr) libusb_free_device_list(devices, 1);
  }
  libusb_device** devices = nullptr;
  ssize_t count = 0;
};

/// Where a device is plugged in, as long as it is.
using Place = std::pair<int, int>;
Place place_of(libusb_device* device) noexcept {
  return {libusb_get_bus_number(device), libusb_get_device_address(device)};
}

/// Held while a Falcon is listed, opened or closed.
std::mutex& falcon_lock() {
  static std::mutex lock;
  return lock;
}
/// What this program holds, with its serial number. Under falcon_lock().
std::map<Place, std::string>& held_here() {
  static std::map<Place, std::string> held;
  return held;
}

/// Opens and claims; null and a problem where it cannot.
libusb_device_handle* claimed(libusb_device* device, OpenProblem& problem) {
  libusb_device_handle* handle = nullptr;
  int error = libusb_open(device, &handle);
  if (error == LIBUSB_SUCCESS) {
    libusb_set_auto_detach_kernel_driver(handle, 1);  // the kernel's serial driver, where it took the chip
    error = libusb_claim_interface(handle, kInterface);
    if (error != LIBUSB_SUCCESS) {
      libusb_close(handle);
      handle = nullptr;
    }
  }
  problem = open_problem(error);
  return handle;
}

OpenProblem held_by_us() { return {true, true, "it is used by this program already", "end the trial that uses it"}; }

std::string serial_of(libusb_device_handle* handle) {
  libusb_device_descriptor about{};
  if (libusb_get_device_descriptor(libusb_get_device(handle), &about) != LIBUSB_SUCCESS || about.iSerialNumber == 0)
    return {};
  std::array<unsigned char, 128> text{};
  const int length = libusb_get_string_descriptor_ascii(handle, about.iSerialNumber, text.data(), text.size());
  return length > 0 ? std::string(text.begin(), text.begin() + length) : std::string();
}

}  // namespace

OpenProblem open_problem(int libusb_error) {
  if (libusb_error == LIBUSB_SUCCESS) return {};
  if (libusb_error == LIBUSB_ERROR_NO_DEVICE || libusb_error == LIBUSB_ERROR_NOT_FOUND)
    return {false, false, "no Falcon is plugged in", "plug in its USB cable and its power supply"};
  const OpenTrouble trouble = open_trouble(libusb_error == LIBUSB_ERROR_ACCESS ? EACCES
                                           : libusb_error == LIBUSB_ERROR_BUSY ? EBUSY
                                                                               : EIO);
  return {true, false, trouble.problem, trouble.mend};
}

/// The transfer that waits for what comes in. On its own, because it is left alive when the bus does not give it back.
struct FalconUsb::Incoming {
  libusb_transfer* transfer = libusb_alloc_transfer(0);
  std::array<unsigned char, kReadBytes> bytes{};
  int completed = 0;
  bool under_way = false;

  ~Incoming() { libusb_free_transfer(transfer); }
  static void LIBUSB_CALL finish(libusb_transfer* transfer) {
    static_cast<Incoming*>(transfer->user_data)->completed = 1;
  }
};

FalconUsb::FalconUsb() {
  if (const int error = libusb_init(&context_); error != LIBUSB_SUCCESS) {
    throw DeviceError(std::string("device falcon: libusb cannot be used (") + libusb_error_name(error) +
                      "); check that /dev/bus/usb is there");
  }
  libusb_set_option(context_, LIBUSB_OPTION_LOG_LEVEL, LIBUSB_LOG_LEVEL_NONE);
}

FalconUsb::~FalconUsb() {
  close();
  libusb_exit(context_);
}

std::vector<UsbFalcon> FalconUsb::list() {
  std::vector<UsbFalcon> found;
  const std::lock_guard<std::mutex> alone(falcon_lock());
  const DeviceList all(context_);
  for (ssize_t i = 0; i < all.count; ++i) {
    if (!is_falcon(all.devices[i])) continue;
    UsbFalcon falcon;
    if (const auto held = held_here().find(place_of(all.devices[i])); held != held_here().end()) {
      falcon.serial = held->second;
      falcon.problem = held_by_us();
    } else if (libusb_device_handle* handle = claimed(all.devices[i], falcon.problem)) {
      falcon.serial = serial_of(handle);
      libusb_release_interface(handle, kInterface);
      libusb_close(handle);
    }
    if (falcon.problem.there) found.push_back(falcon);
  }
  return found;
}

OpenProblem FalconUsb::open() {
  close();
  OpenProblem problem = open_problem(LIBUSB_ERROR_NO_DEVICE);
  {
    const std::lock_guard<std::mutex> alone(falcon_lock());
    const DeviceList all(context_);
    for (ssize_t i = 0; i < all.count && handle_ == nullptr; ++i) {
      if (!is_falcon(all.devices[i])) continue;
      if (held_here().count(place_of(all.devices[i])) != 0) {
        problem = held_by_us();
      } else {
        handle_ = claimed(all.devices[i], problem);
      }
    }
    if (handle_ == nullptr) return problem;
    serial_ = serial_of(handle_);
    held_here().emplace(place_of(libusb_get_device(handle_)), serial_);
  }
  incoming_ = std::make_unique<Incoming>();
  if (incoming_->transfer == nullptr || !ask_incoming()) {
    close();
    return open_problem(LIBUSB_ERROR_IO);
  }
  return {};
}

void FalconUsb::end_transfer() noexcept {
  if (incoming_ != nullptr && incoming_->under_way) {
    libusb_cancel_transfer(incoming_->transfer);
    const auto end = Clock::now() + std::chrono::milliseconds(kCancelMs);
    while (incoming_->completed == 0 && Clock::now() < end) {
      timeval step{0, 10000};
      libusb_handle_events_timeout_completed(context_, &step, &incoming_->completed);
    }
    if (incoming_->completed == 0) incoming_.release();  // the bus may still write to it: better lost than torn
  }
  incoming_.reset();
}

void FalconUsb::close() noexcept {
  if (handle_ == nullptr) return;
  end_transfer();
  const std::lock_guard<std::mutex> alone(falcon_lock());
  held_here().erase(place_of(libusb_get_device(handle_)));
  libusb_release_interface(handle_, kInterface);
  libusb_close(handle_);
  handle_ = nullptr;
}

Transfer FalconUsb::control(std::uint8_t request, std::uint16_t value) noexcept {
  if (handle_ == nullptr) return Transfer::gone;
  constexpr std::uint8_t kVendorOut = 0x40;
  const int sent = libusb_control_transfer(handle_, kVendorOut, request, value, 0, nullptr, 0, kControlMs);
  return outcome(sent < 0 ? sent : LIBUSB_SUCCESS);
}

Transfer FalconUsb::write(const std::uint8_t* bytes, std::size_t count, int time_ms) noexcept {
  if (handle_ == nullptr) return Transfer::gone;
  int sent = 0;
  const int error = libusb_bulk_transfer(handle_, kOut, const_cast<std::uint8_t*>(bytes), static_cast<int>(count),
                                         &sent, static_cast<unsigned>(time_ms));
  if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle_, kOut);
  if (error == LIBUSB_SUCCESS && sent != static_cast<int>(count)) return Transfer::failed;
  return outcome(error);
}

bool FalconUsb::ask_incoming() noexcept {
  incoming_->completed = 0;
  libusb_fill_bulk_transfer(incoming_->transfer, handle_, kIn, incoming_->bytes.data(), kReadBytes, Incoming::finish,
                            incoming_.get(), 0);
  incoming_->under_way = libusb_submit_transfer(incoming_->transfer) == LIBUSB_SUCCESS;
  return incoming_->under_way;
}

Transfer FalconUsb::taken(std::uint8_t* bytes, std::size_t& count) noexcept {
  incoming_->under_way = false;
  switch (incoming_->transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED: {
      const std::size_t got =
          strip_modem_status(incoming_->bytes.data(), static_cast<std::size_t>(incoming_->transfer->actual_length));
      std::memcpy(bytes, incoming_->bytes.data(), got);
      count = got;
      return Transfer::done;
    }
    case LIBUSB_TRANSFER_NO_DEVICE:
      return Transfer::gone;
    case LIBUSB_TRANSFER_STALL:
      libusb_clear_halt(handle_, kIn);
      return Transfer::failed;
    default:
      return Transfer::failed;
  }
}

Transfer FalconUsb::read(std::uint8_t* bytes, std::size_t& count, int time_ms) noexcept {
  count = 0;
  if (handle_ == nullptr) return Transfer::gone;
  const auto end = Clock::now() + std::chrono::milliseconds(time_ms);
  do {
    if (!incoming_->under_way && !ask_incoming()) return Transfer::gone;
    const auto left = std::chrono::duration_cast<std::chrono::microseconds>(end - Clock::now()).count();
    timeval step{0, std::max<suseconds_t>(0, static_cast<suseconds_t>(left))};
    step.tv_sec = step.tv_usec / 1000000;
    step.tv_usec %= 1000000;
    libusb_handle_events_timeout_completed(context_, &step, &incoming_->completed);
    if (incoming_->completed == 0) continue;
    // A packet of status bytes alone is the chip saying that it has nothing.
    if (const Transfer result = taken(bytes, count); result != Transfer::done || count > 0) return result;
  } while (Clock::now() < end);
  return Transfer::late;
}

}  // namespace vallecula::device::falcon

// The Falcon's bus: finding, opening, and transfers that always come back. Each is used by one thread at a time; one
// that lists and one that opens or closes wait for each other, so that neither finds the device taken by the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct libusb_context;
struct libusb_device_handle;

namespace vallecula::device::falcon {

enum class Transfer {
  done,
  late,   ///< nothing within the time given
  gone,   ///< the device is no longer there
  failed  ///< stalled (and cleared again) or broken
};

/// Why a Falcon cannot be opened: what, and how to mend it. Both are empty where it can.
struct OpenProblem {
  bool there = true;  ///< false: none is plugged in
  bool ours = false;  ///< this program holds it
  std::string what, mend;
};
/// For an error of libusb_open or libusb_claim_interface (0: none).
OpenProblem open_problem(int libusb_error);

/// A Falcon that is plugged in.
struct UsbFalcon {
  std::string serial;
  OpenProblem problem;
};

class FalconUsb {
 public:
  /// Throws DeviceError when libusb cannot be used at all.
  FalconUsb();
  ~FalconUsb();
  FalconUsb(const FalconUsb&) = delete;
  FalconUsb& operator=(const FalconUsb&) = delete;

  /// Every Falcon there is; opens those it can for as long as it takes to ask for the serial number. Those that this
  /// program holds are told so and left alone.
  std::vector<UsbFalcon> list();
  /// Opens the first that is free; on failure tells why and stays closed.
  OpenProblem open();
  /// Ends the transfer under way within 0.2 s. Also what one calls after `gone`.
  void close() noexcept;
  bool is_open() const noexcept { return handle_ != nullptr; }
  const std::string& serial() const noexcept { return serial_; }

  /// A request to the FTDI chip (vendor request without data).
  Transfer control(std::uint8_t request, std::uint16_t value) noexcept;
  Transfer write(const std::uint8_t* bytes, std::size_t count, int time_ms) noexcept;
  /// What came in, without the chip's status bytes, at most kReadBytes; `count` is zero unless done. A transfer is
  /// always under way, so that nothing waits for being asked; with `time_ms` 0 only what has come already is taken.
  Transfer read(std::uint8_t* bytes, std::size_t& count, int time_ms) noexcept;
  static constexpr std::size_t kReadBytes = 512;

 private:
  struct Incoming;
  void end_transfer() noexcept;
  bool ask_incoming() noexcept;
  Transfer taken(std::uint8_t* bytes, std::size_t& count) noexcept;

  libusb_context* context_ = nullptr;
  libusb_device_handle* handle_ = nullptr;
  std::unique_ptr<Incoming> incoming_;
  std::string serial_;
};

}  // namespace vallecula::device::falcon

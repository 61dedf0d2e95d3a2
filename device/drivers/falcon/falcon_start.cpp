#include "device/drivers/falcon/falcon_start.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "device/trajectory.h"

namespace vallecula::device::falcon {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Requests of the FTDI chip and their values.
constexpr std::uint8_t kReset = 0, kModem = 1, kFlow = 2, kBaud = 3, kData = 4, kLatency = 9;
constexpr std::uint16_t kPurgeIn = 1, kPurgeOut = 2, kDtrLow = 0x0100, kDtrHigh = 0x0101, kRtsLow = 0x0200;
constexpr std::uint16_t kEightBitsNoParity = 8, kNoFlowControl = 0;
constexpr std::uint16_t kBaud9600 = 0x4138, kBaudLoader = 0x15, kBaudPackets = 0x2;
constexpr std::uint16_t kLatencyStartMs = 16, kLatencyPacketsMs = 1;

constexpr std::array<std::uint8_t, 3> kHello{0x0a, 0x43, 0x0d};
constexpr std::array<std::uint8_t, 4> kHelloAnswer{0x0a, 0x44, 0x2c, 0x0d};
/// What opens the loader. One source has the second (check); it is tried when the first is not answered.
constexpr std::array<std::uint8_t, 2> kLoaderCalls{0x41, 0x40};
constexpr std::uint8_t kLoaderAnswer = 0x41;
constexpr std::size_t kChunkBytes = 62;  // with the two status bytes the echo fills one packet of the bus

constexpr int kAttempts = 2, kHellos = 15;
constexpr int kHelloMs = 100, kLoaderMs = 300, kChunkMs = 500, kWriteMs = 100;
constexpr int kAlreadyRunningAsks = 10, kBootAsks = 100, kAskMs = 20;

/// Nothing public tells the size; the processor's memory is 18 K words, and less than a kilobyte can do nothing.
constexpr std::uintmax_t kLeastBytes = 1024, kMostBytes = 256 * 1024;

struct Stopped {};

[[noreturn]] void fail(const std::string& what, const std::string& mend) {
  throw DeviceError("device falcon: " + what + "; " + mend);
}

constexpr const char* kPowerCycle = "unplug its USB cable and its power supply, wait five seconds, plug both in again";

class Starter {
 public:
  Starter(FalconUsb& usb, const std::atomic<bool>& stop, std::chrono::milliseconds longest)
      : usb_(usb), stop_(stop), end_(Clock::now() + longest) {}

  /// Sends packets without force until one is answered.
  bool answers(int asks) {
    request(kLatency, kLatencyPacketsMs, "setting its latency");
    request(kBaud, kBaudPackets, "setting the speed of its packets");
    purge();
    PacketReader reader;
    Command command;
    command.lights = kRedLight;
    for (int ask = 0; ask < asks; ++ask) {
      go_on();
      if (check(exchange(usb_, reader, command, kAskMs), "asking for a packet", true)) return true;
    }
    return false;
  }

  /// Empty, or what went wrong at which step.
  std::string load(const std::vector<std::uint8_t>& firmware) {
    purge();
    request(kLatency, kLatencyStartMs, "setting its latency");
    request(kBaud, kBaud9600, "setting its speed");
    request(kData, kEightBitsNoParity, "setting its data format");
    request(kFlow, kNoFlowControl, "switching off flow control");
    request(kModem, kRtsLow, "lowering RTS");
    request(kModem, kDtrLow, "lowering DTR");
    request(kModem, kDtrHigh, "raising DTR");
    if (!greeted()) return "it does not answer the first greeting (is its power supply plugged in?)";
    request(kModem, kDtrLow, "lowering DTR");
    request(kBaud, kBaudLoader, "setting the loader's speed");
    if (!loader_opened()) return "its loader does not answer";
    for (std::size_t at = 0; at < firmware.size(); at += kChunkBytes) {
      const std::size_t count = std::min(kChunkBytes, firmware.size() - at);
      if (!echoed(firmware.data() + at, count))
        return "its loader does not echo the firmware (from byte " + std::to_string(at) + ")";
    }
    return {};
  }

 private:
  void go_on() const {
    if (stop_.load(std::memory_order_relaxed)) throw Stopped{};
    if (Clock::now() > end_) fail("starting it takes too long", kPowerCycle);
  }

  /// True when done; false when late, where that is allowed; else names the step.
  bool check(Transfer result, const std::string& step, bool may_be_late = false) {
    if (result == Transfer::done) return true;
    if (result == Transfer::late && may_be_late) return false;
    if (result == Transfer::gone) fail("it was unplugged while it was started (" + step + ")", "plug it in again");
    fail("starting it failed at " + step + (result == Transfer::late ? " (no answer in time)" : " (the bus refused)"),
         kPowerCycle);
  }

  void request(std::uint8_t request, std::uint16_t value, const char* step) {
    go_on();
    check(usb_.control(request, value), step);
  }

  void purge() {
    request(kReset, kPurgeIn, "emptying its buffers");
    request(kReset, kPurgeOut, "emptying its buffers");
  }

  /// Reads until `stop_at(collected)` or the time is over.
  template <class Found>
  bool collect(int time_ms, const char* step, Found found) {
    std::vector<std::uint8_t> collected;
    const auto end = Clock::now() + std::chrono::milliseconds(time_ms);
    for (;;) {
      go_on();
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      if (left <= 0) return false;
      std::array<std::uint8_t, FalconUsb::kReadBytes> bytes;
      std::size_t count = 0;
      if (!check(usb_.read(bytes.data(), count, static_cast<int>(std::min<long>(left, 50))), step, true)) continue;
      collected.insert(collected.end(), bytes.begin(), bytes.begin() + count);
      if (found(collected)) return true;
    }
  }

  void send(const std::uint8_t* bytes, std::size_t count, const char* step) {
    check(usb_.write(bytes, count, kWriteMs), step);
  }

  bool greeted() {
    for (int hello = 0; hello < kHellos; ++hello) {
      send(kHello.data(), kHello.size(), "the first greeting");
      // Some chips put a zero in front: the answer is looked for anywhere in what comes.
      if (collect(kHelloMs, "the answer to the first greeting", [](const std::vector<std::uint8_t>& got) {
            return std::search(got.begin(), got.end(), kHelloAnswer.begin(), kHelloAnswer.end()) != got.end();
          }))
        return true;
    }
    return false;
  }

  bool loader_opened() {
    for (const std::uint8_t call : kLoaderCalls) {
      send(&call, 1, "opening its loader");
      if (collect(kLoaderMs, "its loader's answer",
                  [](const std::vector<std::uint8_t>& got) { return got.back() == kLoaderAnswer; }))
        return true;
    }
    return false;
  }

  bool echoed(const std::uint8_t* bytes, std::size_t count) {
    send(bytes, count, "sending the firmware");
    bool same = true;
    const bool whole = collect(kChunkMs, "the firmware's echo", [&](const std::vector<std::uint8_t>& got) {
      same = got.size() <= count && std::equal(got.begin(), got.end(), bytes);
      return !same || got.size() == count;
    });
    return whole && same;
  }

  FalconUsb& usb_;
  const std::atomic<bool>& stop_;
  const Clock::time_point end_;
};

const char* set_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

fs::path usual_place() {
  if (const char* home = set_variable("VALLECULA_HOME")) return fs::path(home) / "falcon.bin";
  if (const char* data = set_variable("XDG_DATA_HOME")) return fs::path(data) / "vallecula" / "falcon.bin";
  if (const char* home = set_variable("HOME")) return fs::path(home) / ".local/share/vallecula/falcon.bin";
  return {};
}

}  // namespace

std::vector<std::uint8_t> read_firmware(const std::string& argument) {
  fs::path file = argument;
  std::string which = "the firmware file that was named";
  if (file.empty()) {
    if (const char* variable = set_variable("VALLECULA_FALCON_FIRMWARE")) {
      file = variable;
      which = "the firmware file named by VALLECULA_FALCON_FIRMWARE";
    } else {
      file = usual_place();
      which = "the firmware file falcon.bin in the user's data folder";
      std::error_code error;
      if (file.empty() || !fs::exists(file, error)) return {};
    }
  }
  std::error_code error;
  if (!fs::is_regular_file(file, error)) fail(which + " is not there or is no file", kFirmwareAdvice);
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size < kLeastBytes || size > kMostBytes) {
    fail(which + " cannot be the Falcon's: it has " + std::to_string(error ? 0 : size) + " bytes, expected " +
             std::to_string(kLeastBytes) + " to " + std::to_string(kMostBytes),
         kFirmwareAdvice);
  }
  std::vector<std::uint8_t> bytes(size);
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    fail(which + " cannot be read", "check its permission");
  return bytes;
}

Transfer exchange(FalconUsb& usb, PacketReader& reader, const Command& command, int time_ms) noexcept {
  std::array<std::uint8_t, FalconUsb::kReadBytes> bytes;
  std::size_t count = 0;
  if (const Transfer result = usb.read(bytes.data(), count, 0); result != Transfer::late) {
    if (result != Transfer::done) return result;
    reader.feed(bytes.data(), count);
  }
  const Packet packet = encode(command);
  if (const Transfer result = usb.write(packet.data(), packet.size(), time_ms); result != Transfer::done) return result;
  const auto end = Clock::now() + std::chrono::milliseconds(time_ms);
  do {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    const Transfer result = usb.read(bytes.data(), count, static_cast<int>(std::max<long>(left, 0)) + 1);
    if (result != Transfer::done) return result;
    if (reader.feed(bytes.data(), count) > 0) return Transfer::done;
  } while (Clock::now() < end);
  return Transfer::late;
}

void start(FalconUsb& usb, const std::vector<std::uint8_t>& firmware, const std::atomic<bool>& stop,
           std::chrono::milliseconds longest) {
  Starter starter(usb, stop, longest);
  try {
    if (starter.answers(kAlreadyRunningAsks)) return;
    if (firmware.empty()) fail("it needs its firmware, and no firmware file was found", kFirmwareAdvice);
    std::string first;  // a processor left in the middle answers the second attempt less: that says nothing
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      std::string problem = starter.load(firmware);
      if (problem.empty() && starter.answers(kBootAsks)) return;
      if (problem.empty()) problem = "it took the firmware but does not answer (is the file the Falcon's?)";
      if (first.empty()) first = problem;
    }
    fail(first, kPowerCycle);
  } catch (const Stopped&) {
    fail("starting it was given up", "start it again");
  }
}

}  // namespace vallecula::device::falcon

// A Falcon on a mocked bus: the FTDI chip, the processor behind it and the user's hand, as far as usbfs shows them.
#pragma once

#include <umockdev.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace vallecula::device {

/// What it gets wrong; all of it can be changed while it is in use.
struct FalconFaults {
  bool held = false;           ///< another program has claimed it
  bool silent = false;         ///< takes everything, says nothing but the chip's status
  bool deaf_to_hello = false;  ///< does not answer the first greeting
  bool loader_dead = false;    ///< does not answer the loader's call
  long wrong_echo_at = -1;     ///< this byte of the firmware comes back wrong
  bool dies_of_firmware = false;
  int stalls_out = 0, stalls_in = 0;  ///< so many transfers stall
  int broken_packets = 0;             ///< so many answers lose their middle
  int flipped_packets = 0;            ///< so many answers have a wrong high nibble in the first encoder
  int late_ms = 0;                    ///< answers come so much later
  int blocks_ms = 0;                  ///< every write stands so long in the kernel
  bool twice = false;                 ///< every answer comes twice
};

class MockFalcon {
 public:
  /// Not plugged in yet. `firmware` is what makes it run; empty: it runs from the start.
  MockFalcon(UMockdevTestbed* bed, std::vector<std::uint8_t> firmware);
  ~MockFalcon();

  /// Without power in between the processor keeps running; with, it needs its firmware and its homing again.
  void plug(bool powered_anew = true);
  void unplug();

  template <class Change>
  void set(Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(faults_);
  }
  /// The hand has moved the grip to its ends.
  void home(bool done = true);
  void put(const std::array<std::int16_t, 3>& encoders, std::uint8_t buttons = 0);

  struct Seen {
    std::vector<std::pair<int, int>> requests;  ///< of the chip: request, value
    std::array<int, 3> motors{};                ///< of the last command
    int lights = 0;                             ///< green 2, blue 4, red 8
    bool homing = false;
    long commands = 0, malformed = 0, loads = 0;
    long forces = 0;  ///< commands with force
    int largest_motor = 0, largest_motor_unhomed = 0;
    int forces_unhomed = 0;   ///< commands with force while the answer says that it is not homed
    std::vector<int> chunks;  ///< bytes of each write while the firmware came
  };
  Seen seen() const;
  /// Calls this with the motors of every command that comes, until the next listener.
  void listen(std::function<void(const std::array<int, 3>&)> listener);
  static std::string serial() { return "FALCON07"; }

 private:
  using Clock = std::chrono::steady_clock;
  enum class Phase { cold, greeted, loading, dead, running };
  struct Flying {
    UMockdevIoctlClient* client;
    UMockdevIoctlData* urb;
    UMockdevIoctlData* buffer;
    int status = 0;
    bool discarded = false;
  };
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static void on_vanished(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  bool handle(UMockdevIoctlClient* client);
  void submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  void reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg);
  bool finished(Flying& one);
  int control(std::uint8_t* bytes, int length);
  void chip_request(int request, int value);
  void received(const std::uint8_t* bytes, int count);
  void command(const std::uint8_t* bytes);
  void say(const std::vector<std::uint8_t>& bytes);
  void forget(UMockdevIoctlClient* client);

  UMockdevTestbed* bed_;
  UMockdevIoctlBase* handler_;
  const std::vector<std::uint8_t> firmware_;
  mutable std::mutex mutex_;
  FalconFaults faults_;
  Seen seen_;
  std::function<void(const std::array<int, 3>&)> listener_;
  bool plugged_ = false;
  UMockdevIoctlClient* claimed_by_ = nullptr;
  std::list<Flying> flying_;

  Phase phase_ = Phase::cold;
  int baud_ = 0, latency_ms_ = 16;
  bool dtr_ = false;
  std::vector<std::uint8_t> loaded_, incoming_;
  std::deque<std::pair<Clock::time_point, std::uint8_t>> outgoing_;
  Clock::time_point status_at_{};
  std::array<std::int16_t, 3> encoders_{};
  std::uint8_t buttons_ = 0;
  bool homed_ = false;
};

}  // namespace vallecula::device

// The library's one servo loop and the thread that tends it: several devices share them.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "device/drivers/hdapi/hd_channel.h"

namespace vallecula::device::hdapi {

/// Every call into the library outside its own loop is made on one thread, whose numbers have a decimal point whatever
/// the user's locale (the library reads its set-up with it). That thread also reopens, twice a second, a device that is
/// lost. The loop stands while a device is opened, reopened or closed: the others show no force in that time, from
/// a last turn before it on, and say servo_late if it is long.
class Scheduler {
 public:
  struct Opened {
    std::shared_ptr<Channel> channel;
    std::string name;  ///< as it was asked for; empty: the default
    DeviceInfo info;
  };

  /// The running one, or a new one once the last has ended. Throws HdError when the library cannot be loaded, or the
  /// last one does not end.
  static std::shared_ptr<Scheduler> shared();
  /// The running one, or nothing.
  static std::shared_ptr<Scheduler> running();
  ~Scheduler();

  /// Opens the device that the vendor's set-up calls `name`; an empty name: the usual default names in turn. Throws
  /// HdError with the library's error and the mend.
  Opened open(const std::string& name);
  /// Zero force, then closed. Returns after kPatience at the latest, even if the library hangs.
  void close(const std::shared_ptr<Channel>& channel) noexcept;
  /// What is open now.
  std::vector<Opened> opened() const;

  static constexpr std::chrono::seconds kPatience{2};

  struct Core;

 private:
  explicit Scheduler(const Functions& hd);
  std::shared_ptr<Core> core_;
};

}  // namespace vallecula::device::hdapi

// A device of the driver over the stand-in libHD.so.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>

#include "device/drivers/hdapi/hd_device.h"
#include "tests/device/stand_in_hd/control.h"

namespace vallecula::device::hdapi {

class HdapiTest : public ::testing::Test {
 protected:
  HdapiTest() : hd(VALLECULA_STAND_IN_HD) { setenv("VALLECULA_LIBHD", VALLECULA_STAND_IN_HD, 1); }
  ~HdapiTest() override {
    EXPECT_EQ(hd.violations(), "");
    EXPECT_FALSE(hd.open(0));
    EXPECT_FALSE(hd.open(1));
    EXPECT_FALSE(hd.running());
    EXPECT_EQ(hd.callbacks(), 0);
    unsetenv("VALLECULA_LIBHD");
  }

  using Held = std::unique_ptr<HdDevice, std::function<void(HdDevice*)>>;

  /// With the loop turned by hand: it is turned while the device waits to be ready and while it is closed, and else
  /// only by turn().
  Held open_by_hand(const std::string& name = "") const {
    hd.by_hand();
    HdDevice* device = nullptr;
    while_turning([&] { device = new HdDevice(name); });
    return Held(device, [this](HdDevice* closed) { while_turning([&] { delete closed; }); });
  }
  /// Writes the force and turns, as often as given.
  void push(HdDevice& device, const Vector& force_n, int turns) const {
    for (int i = 0; i < turns; ++i) {
      device.write(force_n);
      hd.turn(1);
    }
  }
  static bool within(std::chrono::milliseconds longest, const std::function<bool()>& so) {
    const auto until = std::chrono::steady_clock::now() + longest;
    while (!so()) {
      if (std::chrono::steady_clock::now() > until) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }

  const testing::StandIn hd;

 private:
  void while_turning(const std::function<void()>& act) const {
    std::atomic<bool> done{false};
    std::thread turning([&] {
      while (!done) {
        hd.turn(1);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
    try {
      act();
    } catch (...) {
      done = true;
      turning.join();
      throw;
    }
    done = true;
    turning.join();
  }
};

}  // namespace vallecula::device::hdapi

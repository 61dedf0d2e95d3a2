// A mocked /sys and /dev for the real libusb and hidapi; see umockdev. One a process: ctest runs each *Umockdev test in
// its own.
#pragma once

#include <gtest/gtest.h>

#include <string>

// What Qt makes a macro is a name in glib.
#pragma push_macro("signals")
#undef signals
#include <umockdev.h>
#pragma pop_macro("signals")

namespace vallecula::device {

/// A test fixture with an empty testbed. Its tests are skipped, with a notice, where the process was started without
/// umockdev's preload (a test program run by hand): then the real machine's devices would be seen.
class TestbedUmockdev : public ::testing::Test {
 protected:
  void SetUp() override {
    bed_ = umockdev_testbed_new();
    if (!umockdev_in_mock_environment()) GTEST_SKIP() << "run this under umockdev-wrapper, as ctest does";
  }
  void TearDown() override {
    if (bed_ != nullptr) g_object_unref(bed_);
  }
  /// Adds devices in the form of `umockdev-record`; a malformed text fails the test.
  void add(const std::string& text) {
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(bed_, text.c_str(), &error)) {
      ADD_FAILURE() << (error != nullptr ? error->message : "umockdev refuses the device");
      g_clear_error(&error);
    }
  }

  UMockdevTestbed* bed_ = nullptr;
};

}  // namespace vallecula::device

// A mocked USB device with HID interfaces, as the real hidapi finds and opens it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/device/testbed_umockdev.h"

namespace vallecula::device {

/// One interface: the usages its report descriptor names, each a collection of its own.
struct MockHid {
  int node = 0;  ///< /dev/hidrawN
  std::vector<std::pair<std::uint8_t, std::uint8_t>> usages = {{0x01, 0x08}};
};

/// One device on the bus with its interfaces.
struct MockUsb {
  int port = 1;
  std::uint16_t vendor = 0x256f, product = 0xc635;
  std::string serial;
  std::vector<MockHid> interfaces = {{}};
  std::string driver = "usbhid";  ///< of its interfaces; "usbfs": a program drives it, and it has no hidraw nodes
};

class HidUmockdev : public TestbedUmockdev {
 protected:
  void SetUp() override;
  void TearDown() override;
  void plug_in(const MockUsb& usb);
  void unplug(const MockUsb& usb);
  /// Hands one input report to whoever reads the node.
  void report(int node, const std::vector<std::uint8_t>& bytes);
  /// What was written to the node so far and not yet taken here.
  std::vector<std::uint8_t> written(int node);
  /// Where the mocked node really is.
  std::string real_path(int node) const;

 private:
  static gboolean answer(UMockdevIoctlBase* base, UMockdevIoctlClient* client, gpointer self);
  std::vector<UMockdevIoctlBase*> handlers_;
};

}  // namespace vallecula::device

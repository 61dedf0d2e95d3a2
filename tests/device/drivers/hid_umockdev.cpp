#include "tests/device/drivers/hid_umockdev.h"

#include <linux/hidraw.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace vallecula::device {
namespace {

std::string usb_path(const MockUsb& usb) {
  return "/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(usb.port);
}

std::string hexadecimal(unsigned value, int digits) {
  char text[16];
  std::snprintf(text, sizeof(text), "%0*X", digits, value);
  return text;
}

/// The HID device's name on its bus: BUS:VENDOR:PRODUCT.NUMBER.
std::string hid_name(const MockUsb& usb, const MockHid& hid) {
  return "0003:" + hexadecimal(usb.vendor, 4) + ":" + hexadecimal(usb.product, 4) + "." +
         hexadecimal(static_cast<unsigned>(hid.node), 4);
}

/// Closes the testbed's end of a node, as the kernel does to who reads a device that is gone; the number stays the
/// testbed's, which closes it again.
void hang_up(int fd) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_EQ(dup2(ends[0], fd), fd);
  close(ends[0]);
  close(ends[1]);
}

std::string descriptor(const MockHid& hid) {
  std::string hex;
  for (const auto& [page, usage] : hid.usages)
    hex += "05" + hexadecimal(page, 2) + "09" + hexadecimal(usage, 2) + "A1018501C0";
  return hex;
}

}  // namespace

void HidUmockdev::SetUp() { TestbedUmockdev::SetUp(); }

void HidUmockdev::TearDown() {
  TestbedUmockdev::TearDown();
  for (UMockdevIoctlBase* handler : handlers_) g_object_unref(handler);
}

gboolean HidUmockdev::answer(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer) {
  const gulong request = umockdev_ioctl_client_get_request(client);
  if (request != HIDIOCGRDESCSIZE) return FALSE;  // all that hidapi asks when it opens a node
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  UMockdevIoctlData* size = umockdev_ioctl_data_resolve(argument, 0, sizeof(int), nullptr);
  int bytes = 64;
  umockdev_ioctl_data_update(size, 0, reinterpret_cast<guint8*>(&bytes), sizeof(bytes));
  umockdev_ioctl_data_unref(size);
  umockdev_ioctl_client_complete(client, 0, 0);
  return TRUE;
}

void HidUmockdev::plug_in(const MockUsb& usb) {
  const std::string device = usb_path(usb);
  std::string text = "P: " + device + "\nN: bus/usb/001/00" + std::to_string(usb.port) +
                     "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=" + hexadecimal(usb.vendor, 4) +
                     "\nA: idProduct=" + hexadecimal(usb.product, 4) +
                     "\nA: manufacturer=3Dconnexion\nA: product=SpaceMouse\n" +
                     (usb.serial.empty() ? "" : "A: serial=" + usb.serial + "\n") + "\n";
  for (std::size_t i = 0; i < usb.interfaces.size(); ++i) {
    const MockHid& hid = usb.interfaces[i];
    const std::string number = "1-" + std::to_string(usb.port) + ":1." + std::to_string(i);
    const std::string interface = device + "/" + number;
    text += "P: " + interface +
            "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nL: driver=../../../../../../bus/usb/drivers/" + usb.driver +
            "\n\n";
    if (usb.driver != "usbhid") continue;
    const std::string id = hid_name(usb, hid);
    text += "P: " + interface + "/" + id + "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:" + hexadecimal(usb.vendor, 8) + ":" +
            hexadecimal(usb.product, 8) + "\nE: HID_NAME=3Dconnexion SpaceMouse\nE: HID_UNIQ=" + usb.serial +
            "\nH: report_descriptor=" + descriptor(hid) + "\n\n";
    const std::string node = "hidraw" + std::to_string(hid.node);
    text += "P: " + interface + "/" + id + "/hidraw/" + node + "\nN: " + node +
            "\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/" + node + "\nL: device=../../../" + id + "\n\n";
    UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
    g_signal_connect(handler, "handle-ioctl", G_CALLBACK(&HidUmockdev::answer), this);
    GError* error = nullptr;
    if (!umockdev_testbed_attach_ioctl(bed_, ("/dev/" + node).c_str(), handler, &error))
      ADD_FAILURE() << (error != nullptr ? error->message : "no ioctl handler");
    g_clear_error(&error);
    handlers_.push_back(handler);
  }
  add(text);
}

void HidUmockdev::unplug(const MockUsb& usb) {
  const std::string device = "/sys" + usb_path(usb);
  for (std::size_t i = 0; i < usb.interfaces.size(); ++i) {
    const std::string interface = device + "/1-" + std::to_string(usb.port) + ":1." + std::to_string(i);
    if (usb.driver == "usbhid") {
      const MockHid& hid = usb.interfaces[i];
      const std::string node = "hidraw" + std::to_string(hid.node);
      const int fd = umockdev_testbed_get_dev_fd(bed_, ("/dev/" + node).c_str());
      hang_up(fd);
      GError* ignored = nullptr;
      umockdev_testbed_detach_ioctl(bed_, ("/dev/" + node).c_str(), &ignored);
      g_clear_error(&ignored);
      const std::string id = interface + "/" + hid_name(usb, hid);
      umockdev_testbed_remove_device(bed_, (id + "/hidraw/" + node).c_str());
      umockdev_testbed_remove_device(bed_, id.c_str());
    }
    umockdev_testbed_remove_device(bed_, interface.c_str());
  }
  umockdev_testbed_remove_device(bed_, device.c_str());
}

void HidUmockdev::report(int node, const std::vector<std::uint8_t>& bytes) {
  const int fd = umockdev_testbed_get_dev_fd(bed_, ("/dev/hidraw" + std::to_string(node)).c_str());
  ASSERT_GE(fd, 0);
  ASSERT_EQ(::write(fd, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

std::vector<std::uint8_t> HidUmockdev::written(int node) {
  const int fd = umockdev_testbed_get_dev_fd(bed_, ("/dev/hidraw" + std::to_string(node)).c_str());
  std::vector<std::uint8_t> bytes(256);
  pollfd ready{fd, POLLIN, 0};
  if (poll(&ready, 1, 0) != 1) return {};
  const ssize_t size = ::read(fd, bytes.data(), bytes.size());
  bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return bytes;
}

std::string HidUmockdev::real_path(int node) const {
  gchar* root = umockdev_testbed_get_root_dir(bed_);
  const std::string path = std::string(root) + "/dev/hidraw" + std::to_string(node);
  g_free(root);
  return path;
}

}  // namespace vallecula::device

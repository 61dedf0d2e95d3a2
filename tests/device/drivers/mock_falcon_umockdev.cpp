#include "tests/device/drivers/mock_falcon_umockdev.h"

#include <gtest/gtest.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <thread>

namespace vallecula::device {
namespace {

constexpr const char* kNode = "/dev/bus/usb/001/001";
constexpr const char* kSysfs = "/sys/devices/usb1";
constexpr const char* kDescription =
    "P: /devices/usb1\n"
    "N: bus/usb/001/001\n"
    "E: SUBSYSTEM=usb\n"
    "E: DRIVER=usb\n"
    "E: BUSNUM=001\n"
    "E: DEVNUM=001\n"
    "E: DEVNAME=/dev/bus/usb/001/001\n"
    "E: DEVTYPE=usb_device\n"
    "A: busnum=1\\n\n"
    "A: devnum=1\\n\n"
    "A: bConfigurationValue=1\\n\n"
    "A: speed=12\\n\n"
    "A: idVendor=0403\\n\n"
    "A: idProduct=cb48\\n\n"
    "H: descriptors="
    "12010002000000400304 48cb000601020301"
    "090220000101008 02d"
    "0904000002ffffff02"
    "07058102400000"
    "07050202400000\n";

std::string description() {
  std::string text = kDescription;
  const std::size_t hex = text.find("H: descriptors=") + 15;  // the groups above are for reading
  text.erase(std::remove(text.begin() + static_cast<long>(hex), text.end(), ' '), text.end());
  return text;
}

std::uint8_t* bytes_of(UMockdevIoctlData* data) { return data->data; }

}  // namespace

MockFalcon::MockFalcon(UMockdevTestbed* bed, std::vector<std::uint8_t> firmware)
    : bed_(bed), handler_(umockdev_ioctl_base_new()), firmware_(std::move(firmware)) {
  g_signal_connect(handler_, "handle-ioctl", G_CALLBACK(on_ioctl), this);
  g_signal_connect(handler_, "client-vanished", G_CALLBACK(on_vanished), this);
  GError* error = nullptr;
  if (!umockdev_testbed_attach_ioctl(bed_, kNode, handler_, &error)) ADD_FAILURE() << error->message;
}

MockFalcon::~MockFalcon() {
  umockdev_testbed_detach_ioctl(bed_, kNode, nullptr);
  g_signal_handlers_disconnect_by_data(handler_, this);
  g_object_unref(handler_);
}

void MockFalcon::plug(bool powered_anew) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    plugged_ = true;
    claimed_by_ = nullptr;
    outgoing_.clear();
    incoming_.clear();
    if (powered_anew) {
      phase_ = firmware_.empty() ? Phase::running : Phase::cold;
      homed_ = false;
    }
  }
  GError* error = nullptr;
  if (!umockdev_testbed_add_from_string(bed_, description().c_str(), &error)) ADD_FAILURE() << error->message;
}

void MockFalcon::unplug() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    plugged_ = false;
  }
  umockdev_testbed_uevent(bed_, kSysfs, "remove");
  umockdev_testbed_remove_device(bed_, kSysfs);
}

void MockFalcon::home(bool done) {
  const std::lock_guard<std::mutex> lock(mutex_);
  homed_ = done;
}

void MockFalcon::put(const std::array<std::int16_t, 3>& encoders, std::uint8_t buttons) {
  const std::lock_guard<std::mutex> lock(mutex_);
  encoders_ = encoders;
  buttons_ = buttons;
}

MockFalcon::Seen MockFalcon::seen() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return seen_;
}

void MockFalcon::listen(std::function<void(const std::array<int, 3>&)> listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  listener_ = std::move(listener);
}

// --- usbfs -----------------------------------------------------------------------------------------------------------

gboolean MockFalcon::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  return static_cast<MockFalcon*>(self)->handle(client) ? TRUE : FALSE;
}

void MockFalcon::on_vanished(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  auto* mock = static_cast<MockFalcon*>(self);
  const std::lock_guard<std::mutex> lock(mock->mutex_);
  mock->forget(client);
}

void MockFalcon::forget(UMockdevIoctlClient* client) {
  if (claimed_by_ == client) claimed_by_ = nullptr;
  for (auto one = flying_.begin(); one != flying_.end();) {
    if (one->client != client) {
      ++one;
      continue;
    }
    umockdev_ioctl_data_unref(one->urb);
    umockdev_ioctl_data_unref(one->buffer);
    one = flying_.erase(one);
  }
}

bool MockFalcon::handle(UMockdevIoctlClient* client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  UMockdevIoctlData* arg = umockdev_ioctl_client_get_arg(client);
  const gulong request = umockdev_ioctl_client_get_request(client);
  const auto answer = [&](long result, int error = 0) {
    umockdev_ioctl_client_complete(client, result, error);
    return true;
  };
  if (!plugged_ && request != USBDEVFS_REAPURB && request != USBDEVFS_REAPURBNDELAY && request != USBDEVFS_DISCARDURB)
    return answer(-1, ENODEV);
  switch (request) {
    case USBDEVFS_GET_CAPABILITIES: {
      UMockdevIoctlData* flags = umockdev_ioctl_data_resolve(arg, 0, sizeof(guint32), nullptr);
      const guint32 value = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                            USBDEVFS_CAP_REAP_AFTER_DISCONNECT | USBDEVFS_CAP_ZERO_PACKET;
      std::memcpy(bytes_of(flags), &value, sizeof(value));
      umockdev_ioctl_data_unref(flags);
      return answer(0);
    }
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_DISCONNECT_CLAIM:
      if (faults_.held || (claimed_by_ != nullptr && claimed_by_ != client)) return answer(-1, EBUSY);
      claimed_by_ = client;
      return answer(0);
    case USBDEVFS_RELEASEINTERFACE:
      if (claimed_by_ == client) claimed_by_ = nullptr;
      return answer(0);
    case USBDEVFS_CLEAR_HALT:
      return answer(0);
    case USBDEVFS_GETDRIVER:
    case USBDEVFS_IOCTL:
      return answer(-1, ENODATA);
    case USBDEVFS_SUBMITURB:
      submit(client, arg);
      return true;
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
      reap(client, arg);
      return true;
    case USBDEVFS_DISCARDURB: {
      gulong address = 0;
      std::memcpy(&address, bytes_of(arg), sizeof(address));
      for (Flying& one : flying_) {
        if (one.client != client || one.urb->client_addr != address) continue;
        one.discarded = true;
        return answer(0);
      }
      return answer(-1, EINVAL);
    }
    default:
      return false;
  }
}

void MockFalcon::submit(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  UMockdevIoctlData* data = umockdev_ioctl_data_resolve(arg, 0, sizeof(usbdevfs_urb), nullptr);
  auto* urb = reinterpret_cast<usbdevfs_urb*>(bytes_of(data));
  UMockdevIoctlData* buffer =
      umockdev_ioctl_data_resolve(data, offsetof(usbdevfs_urb, buffer), urb->buffer_length, nullptr);
  Flying one{client, data, buffer};
  if (claimed_by_ != client && urb->type == USBDEVFS_URB_TYPE_BULK) {
    umockdev_ioctl_data_unref(data);
    umockdev_ioctl_data_unref(buffer);
    umockdev_ioctl_client_complete(client, -1, EINVAL);
    return;
  }
  if (urb->type == USBDEVFS_URB_TYPE_CONTROL) {
    urb->actual_length = control(bytes_of(buffer), urb->buffer_length);
  } else if ((urb->endpoint & 0x80) == 0) {
    if (faults_.blocks_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(faults_.blocks_ms));
    if (faults_.stalls_out > 0) {
      --faults_.stalls_out;
      one.status = -EPIPE;
    } else {
      received(bytes_of(buffer), urb->buffer_length);
      urb->actual_length = urb->buffer_length;
    }
  } else {
    status_at_ = Clock::now() + std::chrono::milliseconds(latency_ms_);
    if (faults_.stalls_in > 0) {
      --faults_.stalls_in;
      one.status = -EPIPE;
    }
  }
  flying_.push_back(one);
  umockdev_ioctl_client_complete(client, 0, 0);
}

/// Whether the transfer is over; fills what came in.
bool MockFalcon::finished(Flying& one) {
  auto* urb = reinterpret_cast<usbdevfs_urb*>(bytes_of(one.urb));
  if (!plugged_) one.status = -ENODEV;
  if (one.discarded) one.status = -ENOENT;
  urb->status = one.status;
  if (one.status != 0 || urb->type == USBDEVFS_URB_TYPE_CONTROL || (urb->endpoint & 0x80) == 0) return true;
  const auto now = Clock::now();
  const bool speaks = !outgoing_.empty() && outgoing_.front().first <= now;
  if (!speaks && now < status_at_) return false;
  // Packets of 64 bytes, each begun by two of modem status, until nothing more is there.
  int length = 0;
  std::uint8_t* bytes = bytes_of(one.buffer);
  do {
    const int end = std::min(length + 64, urb->buffer_length);
    bytes[length++] = 0x01;
    bytes[length++] = 0x60;
    while (length < end && !outgoing_.empty() && outgoing_.front().first <= now) {
      bytes[length++] = outgoing_.front().second;
      outgoing_.pop_front();
    }
  } while (length + 2 < urb->buffer_length && length % 64 == 0 && !outgoing_.empty() && outgoing_.front().first <= now);
  urb->actual_length = length;
  return true;
}

void MockFalcon::reap(UMockdevIoctlClient* client, UMockdevIoctlData* arg) {
  for (auto one = flying_.begin(); one != flying_.end(); ++one) {
    if (one->client != client || !finished(*one)) continue;
    UMockdevIoctlData* pointer = umockdev_ioctl_data_resolve(arg, 0, sizeof(gpointer), nullptr);
    umockdev_ioctl_data_set_ptr(pointer, 0, one->urb);
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(pointer);
    umockdev_ioctl_data_unref(one->urb);
    umockdev_ioctl_data_unref(one->buffer);
    flying_.erase(one);
    return;
  }
  umockdev_ioctl_client_complete(client, -1, plugged_ ? EAGAIN : ENODEV);
}

// --- the chip and the processor --------------------------------------------------------------------------------------

/// Returns the bytes of data.
int MockFalcon::control(std::uint8_t* bytes, int length) {
  const int type = bytes[0], request = bytes[1], value = bytes[2] | (bytes[3] << 8),
            wanted = bytes[6] | (bytes[7] << 8);
  if (type == 0x40) {
    chip_request(request, value);
    return 0;
  }
  if (type == 0x80 && request == 6 && (value >> 8) == 3) {  // a string
    std::vector<std::uint8_t> text{0, 3};
    if ((value & 0xff) == 0) {
      text.insert(text.end(), {0x09, 0x04});
    } else {
      for (const char c : serial()) text.insert(text.end(), {static_cast<std::uint8_t>(c), 0});
    }
    text[0] = static_cast<std::uint8_t>(text.size());
    const int count = std::min({static_cast<int>(text.size()), wanted, length - 8});
    std::copy(text.begin(), text.begin() + count, bytes + 8);
    return count;
  }
  return 0;
}

void MockFalcon::chip_request(int request, int value) {
  seen_.requests.emplace_back(request, value);
  if (request == 0 && value == 1) outgoing_.clear();
  if (request == 1 && (value & 0x0100) != 0) dtr_ = (value & 1) != 0;
  if (request == 9) latency_ms_ = value;
  if (request == 3) {
    baud_ = value;
    if (phase_ == Phase::loading && value == 2) {
      ++seen_.loads;
      phase_ = loaded_ == firmware_ && !faults_.dies_of_firmware ? Phase::running : Phase::dead;
    }
  }
}

void MockFalcon::received(const std::uint8_t* bytes, int count) {
  if (phase_ == Phase::loading) seen_.chunks.push_back(count);
  for (int i = 0; i < count; ++i) {
    const std::uint8_t byte = bytes[i];
    incoming_.push_back(byte);
    switch (phase_) {
      case Phase::cold: {
        static constexpr std::uint8_t kHello[] = {0x0a, 0x43, 0x0d};
        if (baud_ == 0x4138 && dtr_ && incoming_.size() >= 3 && std::equal(kHello, kHello + 3, incoming_.end() - 3) &&
            !faults_.deaf_to_hello) {
          phase_ = Phase::greeted;
          say({0x0a, 0x44, 0x2c, 0x0d});
        }
        break;
      }
      case Phase::greeted:
        if (baud_ == 0x15 && !dtr_ && byte == 0x41 && !faults_.loader_dead) {
          phase_ = Phase::loading;
          loaded_.clear();
          say({0x41});
        } else if (baud_ == 0x4138) {
          phase_ = Phase::cold;  // greeted again
        }
        break;
      case Phase::loading:
        say({static_cast<std::uint8_t>(static_cast<long>(loaded_.size()) == faults_.wrong_echo_at ? ~byte : byte)});
        loaded_.push_back(byte);
        break;
      case Phase::dead:
        break;
      case Phase::running:
        if (baud_ != 2 || incoming_.size() < 16) break;
        command(incoming_.data() + incoming_.size() - 16);
        break;
    }
  }
  if (incoming_.size() > 4096) incoming_.clear();
}

/// The last 16 bytes that came: a command, or the middle of one.
void MockFalcon::command(const std::uint8_t* bytes) {
  if (bytes[0] != '<' || bytes[15] != '>') return;
  std::array<std::uint8_t, 16> packet;
  std::copy(bytes, bytes + packet.size(), packet.begin());
  incoming_.clear();
  for (int leg = 0; leg < 3; ++leg) {
    int value = 0;
    for (int nibble = 3; nibble >= 0; --nibble) {
      const int digit = packet[1 + 4 * leg + nibble] - 'A';
      if (digit < 0 || digit > 15) ++seen_.malformed;
      value = value * 16 + digit;
    }
    seen_.motors[leg] = value >= 0x8000 ? value - 0x10000 : value;
    seen_.largest_motor = std::max(seen_.largest_motor, std::abs(seen_.motors[leg]));
    if (!homed_) seen_.largest_motor_unhomed = std::max(seen_.largest_motor_unhomed, std::abs(seen_.motors[leg]));
  }
  const bool force = seen_.motors != std::array<int, 3>{};
  seen_.forces += force;
  seen_.forces_unhomed += force && !homed_;
  seen_.lights = (packet[13] - 'A') & 0x0e;
  seen_.homing = ((packet[13] - 'A') & 1) != 0;
  ++seen_.commands;
  if (listener_) listener_(seen_.motors);
  if (faults_.silent) return;

  std::vector<std::uint8_t> answer{'<'};
  for (const std::int16_t encoder : encoders_) {
    const int value = encoder & 0xffff;
    for (const int shift : {0, 4, 8, 12}) answer.push_back(static_cast<std::uint8_t>('A' + ((value >> shift) & 15)));
  }
  answer.push_back(static_cast<std::uint8_t>('A' + (homed_ ? 0x70 : 0) + buttons_));
  answer.push_back('A');
  answer.push_back('>');
  if (faults_.flipped_packets > 0) {
    --faults_.flipped_packets;
    answer[4] = static_cast<std::uint8_t>('A' + ((answer[4] - 'A') ^ 8));
  }
  if (faults_.broken_packets > 0) {
    --faults_.broken_packets;
    answer.erase(answer.begin() + 5, answer.begin() + 9);
  }
  say(answer);
  if (faults_.twice) say(answer);
}

void MockFalcon::say(const std::vector<std::uint8_t>& bytes) {
  const auto at = Clock::now() + std::chrono::milliseconds(faults_.late_ms);
  for (const std::uint8_t byte : bytes) outgoing_.emplace_back(at, byte);
}

}  // namespace vallecula::device

// Finding, opening and starting a Falcon, and what is said when that fails.
#include "device/drivers/falcon/falcon_start.h"
#include "device/factory.h"
#include "tests/device/drivers/falcon_bed_umockdev.h"

namespace vallecula::device {
namespace {

using Strings = std::vector<std::string>;

class FalconStartUmockdev : public FalconUmockdev {};

TEST_F(FalconStartUmockdev, IsFoundAndWhatItLacksIsSaid) {
  EXPECT_TRUE(find_falcon().empty());
  MockFalcon mock(bed_, some_firmware());
  mock.plug();
  auto found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "falcon");
  EXPECT_EQ(found[0].info.serial, MockFalcon::serial());
  EXPECT_EQ(found[0].info.driver, "libusb");
  EXPECT_EQ(found[0].info.sensed_dof, 3);
  EXPECT_EQ(found[0].calibration, Calibration::needs_hand);
  EXPECT_NE(found[0].problem.find("firmware"), std::string::npos);
  EXPECT_NE(found[0].mend.find("VALLECULA_FALCON_FIRMWARE"), std::string::npos);

  write_file("falcon.bin", some_firmware());
  found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(mock.seen().commands, 0);  // nothing was started

  mock.set([](FalconFaults& f) { f.held = true; });
  found = find_falcon();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].problem.find("another program"), std::string::npos);
  EXPECT_EQ(found[0].name, "");

  mock.unplug();
  EXPECT_TRUE(wait_for([] { return find_falcon().empty(); }));
}

TEST_F(FalconStartUmockdev, TheFactoryMakesIt) {
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  write_file("my.bin", some_firmware());
  const auto made = make_device("falcon", (folder_ / "my.bin").string());
  EXPECT_EQ(made->info().kind, "falcon");
  EXPECT_EQ(made->info().serial, MockFalcon::serial());
  EXPECT_TRUE(made->info().own_axes);
  EXPECT_EQ(made->info().peak_force_n, 8.0);
  EXPECT_EQ(mock_->seen().loads, 1);
}

TEST_F(FalconStartUmockdev, StartsStepByStep) {
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  write_file("falcon.bin", some_firmware());
  device_ = std::make_unique<FalconDevice>();
  const auto seen = mock_->seen();
  const std::vector<std::pair<int, int>> expected{
      {9, 1},     {3, 0x2},    {0, 1},     {0, 2},   // does it answer packets already?
      {0, 1},     {0, 2},                            // purge
      {9, 16},    {3, 0x4138}, {4, 8},     {2, 0},   // latency, 9600 baud, 8N1, no flow control
      {1, 0x200}, {1, 0x100},  {1, 0x101},           // RTS low, DTR low then high; greeting
      {1, 0x100}, {3, 0x15},                         // DTR low, the loader's speed; firmware
      {9, 1},     {3, 0x2},    {0, 1},     {0, 2}};  // packets
  EXPECT_EQ(seen.requests, expected);
  ASSERT_EQ(seen.chunks.size(), (1500u + 61) / 62);
  for (std::size_t i = 0; i + 1 < seen.chunks.size(); ++i) EXPECT_EQ(seen.chunks[i], 62);
  EXPECT_EQ(seen.loads, 1);
  EXPECT_TRUE(wait_for([&] { return mock_->seen().homing; }));
}

TEST_F(FalconStartUmockdev, OneThatRunsIsNotLoadedAgain) {
  open_running();  // and no firmware file anywhere
  EXPECT_EQ(mock_->seen().loads, 0);
  EXPECT_EQ(mock_->seen().requests.size(), 4u);
  EXPECT_TRUE(ticks_until({0, 0, 0}, [&] { return mock_->seen().commands > 20; }));
}

TEST_F(FalconStartUmockdev, FailuresToOpenAreNamed) {
  expect_error({"no Falcon is plugged in", "power supply"});
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
  mock_->plug();
  expect_error({"firmware", "~/.local/share/vallecula/falcon.bin", "falcon:FIRMWARE.bin"});
  expect_error({"named is not there"}, (folder_ / "none.bin").string());
  expect_error({"named is not there"}, folder_.string());
  write_file("small.bin", some_firmware(1000));
  expect_error({"1000 bytes", "1024"}, (folder_ / "small.bin").string());
  write_file("large.bin", std::vector<std::uint8_t>(300000));
  expect_error({"300000 bytes"}, (folder_ / "large.bin").string());
  ::setenv("VALLECULA_FALCON_FIRMWARE", (folder_ / "none.bin").c_str(), 1);
  expect_error({"VALLECULA_FALCON_FIRMWARE"});
  write_file("falcon.bin", some_firmware());
  ::unsetenv("VALLECULA_FALCON_FIRMWARE");
  mock_->set([](FalconFaults& f) { f.held = true; });
  expect_error({"another program"});
  mock_->set([](FalconFaults& f) { f = {}; });
  mock_->set([](FalconFaults& f) { f.stalls_out = 1000; });
  expect_error({"asking for a packet", "bus refused"});
}

TEST_F(FalconStartUmockdev, FailuresOfTheStartAreNamed) {
  write_file("falcon.bin", some_firmware());
  const auto with = [&](const std::function<void(FalconFaults&)>& fault, const Strings& parts) {
    mock_ = std::make_unique<MockFalcon>(bed_, some_firmware());
    mock_->set(fault);
    mock_->plug();
    expect_error(parts);
    mock_->unplug();
    mock_.reset();
  };
  with([](FalconFaults& f) { f.deaf_to_hello = true; }, {"first greeting", "power supply"});
  with([](FalconFaults& f) { f.loader_dead = true; }, {"loader does not answer"});
  with([](FalconFaults& f) { f.wrong_echo_at = 700; }, {"echo", "from byte 682"});  // the eleventh chunk's begin
  with([](FalconFaults& f) { f.dies_of_firmware = true; }, {"took the firmware but does not answer"});
}

TEST_F(FalconStartUmockdev, TheStartEndsInTimeAndWhenItIsStopped) {
  const auto start_error = [&](std::atomic<bool>& stop, std::chrono::milliseconds longest) {
    falcon::FalconUsb usb;
    EXPECT_EQ(usb.open().what, "");
    try {
      falcon::start(usb, some_firmware(60000), stop, longest);
    } catch (const DeviceError& error) {
      return std::string(error.what());
    }
    return std::string("started");
  };
  mock_ = std::make_unique<MockFalcon>(bed_, some_firmware(60000));
  mock_->set([](FalconFaults& f) { f.late_ms = 60; });  // every echo: a minute for this firmware
  mock_->plug();
  std::atomic<bool> stop{false};
  auto begin = Clock::now();
  EXPECT_NE(start_error(stop, std::chrono::milliseconds(1500)).find("takes too long"), std::string::npos);
  EXPECT_LT(since(begin), 15.0);  // of a minute

  begin = Clock::now();
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    stop = true;
  });
  EXPECT_NE(start_error(stop, std::chrono::seconds(20)).find("given up"), std::string::npos);
  EXPECT_LT(since(begin), 15.0);  // of twenty seconds
  other.join();
}

}  // namespace
}  // namespace vallecula::device

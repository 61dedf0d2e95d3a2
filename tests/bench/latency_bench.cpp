// vallecula_latency_bench [SECONDS]: from reading the hand to writing its force, with the scripted device. Two figures:
// the device's own layer (map, guard, output chain) in a bare loop, and a whole servo tick at 1 kHz beside a running
// scene.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "device/drivers/scripted_device.h"
#include "engine/haptics/runner.h"
#include "gui/session/hands_port.h"
#include "tests/engine/mouth_scene.h"

namespace {

using namespace vallecula;

std::int64_t now_ns() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1'000'000'000LL + t.tv_nsec;
}

void print(const char* what, std::vector<std::int64_t>& ns) {
  std::sort(ns.begin(), ns.end());
  const auto at = [&](double share) {
    return 1e-3 * static_cast<double>(ns[static_cast<std::size_t>(share * static_cast<double>(ns.size() - 1))]);
  };
  std::printf("%-34s p50 %8.2f  p99 %8.2f  p99.9 %8.2f  max %8.2f us  (%zu ticks)\n", what, at(0.5), at(0.99),
              at(0.999), at(1.0), ns.size());
}

/// A hand that presses the tongue of the scene again and again.
device::Trajectory presses(double seconds) {
  std::vector<device::Keyframe> keys;
  const engine::Vec3 top = engine::testing::kTongueTop;
  for (int i = 0; i <= static_cast<int>(seconds / 0.5) + 1; ++i)
    keys.push_back({0.5 * i, {top.x(), top.y(), top.z() + (i % 2 == 0 ? 0.002 : -0.003)}});
  return device::Trajectory(std::move(keys));
}

/// The port, with a watch on it: started at the reading, stopped when the force has been written.
class WatchedPort final : public engine::HapticPort {
 public:
  WatchedPort(device::GuardedDevice& device, std::vector<std::int64_t>& ns) : port_(device), ns_(ns) {}
  engine::PortInput read(double time_s) noexcept override {
    began_ = now_ns();
    return port_.read(time_s);
  }
  void see_tool(const engine::Pose& tool) noexcept override { port_.see_tool(tool); }
  void write(const engine::Vec3& force_n) noexcept override {
    port_.write(force_n);
    if (ns_.size() < ns_.capacity()) ns_.push_back(now_ns() - began_);
  }

 private:
  gui::HandsPort port_;
  std::vector<std::int64_t>& ns_;
  std::int64_t began_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20.0;
  if (!(seconds >= 1.0 && seconds <= 3600.0)) {
    std::fprintf(stderr, "vallecula_latency_bench: '%s' is no time; give 1 to 3600 seconds\n", argv[1]);
    return 2;
  }
  device::HandSettings hand = device::firm_hand();
  hand.tremor_amplitude_m = 1e-4;
  {
    device::ScriptedDevice script(presses(seconds), hand);
    device::GuardedDevice guard(script, device::guard_for(script.info()));
    std::vector<std::int64_t> ns(1'000'000);
    for (std::size_t i = 0; i < ns.size(); ++i) {
      const std::int64_t began = now_ns();
      const device::DeviceReading reading = guard.read(0.001 * static_cast<double>(i));
      guard.see_tool(reading.position_m, reading.rotation_wxyz);
      guard.write({0.0, 0.0, 2.0});
      ns[i] = now_ns() - began;
    }
    print("device layer alone", ns);
  }
  device::ScriptedDevice script(presses(seconds), hand);
  device::GuardedDevice guard(script, device::guard_for(script.info()));
  std::vector<std::int64_t> ns;
  ns.reserve(static_cast<std::size_t>(seconds * 1000.0));
  WatchedPort port(guard, ns);
  engine::Runner runner(engine::build_scene(engine::testing::mouth_scene()), port);
  runner.start();
  engine::TickRecord record;
  for (std::int64_t ticks = 0; ticks < static_cast<std::int64_t>(seconds * 1000.0);) {
    while (runner.pop(record)) ++ticks;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  runner.stop();
  print("read to force, with a scene", ns);
  const engine::TimingReport timing = runner.timing();
  std::printf("%.1f Hz, %lld of %lld forces more than 1 ms late; %s\n", timing.loop_rate_hz,
              static_cast<long long>(timing.deadline_misses), static_cast<long long>(timing.ticks),
              timing.priority.c_str());
  return 0;
}

#include "gui/session/expert_loop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "device/drivers/scripted_device.h"
#include "engine/haptics/runner.h"
#include "gui/session/film_frames.h"
#include "gui/session/hands_port.h"
#include "gui/session/low_priority.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/scripted_pairs.h"
#include "gui/session/trial_session.h"

namespace vallecula::gui {

namespace {

constexpr double kTickS = 0.001;
constexpr double kBeforeMouthS = 1.0;  ///< of the blade's way that nobody need see: up to the lips
constexpr int kLeastPriority = 19;     ///< nice

struct Plan {
  device::Trajectory blade;
  std::optional<device::Trajectory> tube;
  device::ActionPlan actions;
  double from_s = 0.0, to_s = 0.0;
};

/// When the blade first leaves its place: an expert may give breaths before.
double sets_out_s(const device::Trajectory& blade) {
  const auto& keys = blade.keyframes();
  const auto moved = std::find_if(keys.begin(), keys.end(), [&](const device::Keyframe& k) {
    return k.position_m != keys.front().position_m;
  });
  return moved == keys.begin() || moved == keys.end() ? blade.start_s() : std::prev(moved)->time_s;
}

Plan plan_for(const TrialSession& session) {
  const auto& intubation = session.scene().intubation;
  Plan plan{scripted_hand("expert", session.package(), session.scenario()), {}, {}};
  if (intubation) {
    ScriptedPair pair = scripted_pair("expert", session.package(), session.scenario(), *intubation);
    plan = {std::move(pair.blade), std::move(pair.tube), std::move(pair.actions)};
  }
  plan.from_s = sets_out_s(plan.blade) + kBeforeMouthS;
  plan.to_s = std::min(plan.blade.end_s(), plan.from_s + kLoopS);
  return plan;
}

}  // namespace

struct ExpertLoop::Impl {
  explicit Impl(const TrialSession& session)
      : plan(plan_for(session)),
        blade_device(plan.blade, device::firm_hand()),
        blade(blade_device, device::guard_for(blade_device.info())),
        scene(session.built_scene()) {
    if (plan.tube) {
      tube_device.emplace(*plan.tube, device::firm_hand());
      tube.emplace(*tube_device, device::guard_for(tube_device->info()));
      port.emplace(blade, *tube, plan.actions, keys);
    } else {
      port.emplace(blade, plan.actions, keys);
    }
    runner = std::make_unique<engine::Runner>(scene, *port);
    const auto ticks = static_cast<std::size_t>(std::llround((plan.to_s - plan.from_s) / kTickS));
    film = plan_film(ticks, kTickS, bytes_of(runner->latest()), kLoopBytes);
    frames.emplace(film.frames);
    worker = std::thread([this] {
      take_low_priority(kLeastPriority);
      try {
        compute();
      } catch (const std::exception& error) {
        remark = std::string("the expert's loop stopped: ") + error.what();
      }
      finished.store(true, std::memory_order_release);
    });
  }
  ~Impl() {
    stop = true;
    worker.join();
  }

  void compute() {
    std::uint32_t faults = 0;
    const auto go = [&](std::int64_t ticks) {
      for (std::int64_t n = 0; n < ticks && !stop && faults == 0; ++n)
        runner->run(1, [&](const engine::TickRecord& tick) {
          faults = tick.faults & (engine::kFaultTissue | engine::kFaultForce | engine::kFaultDevicePose);
        });
    };
    go(std::llround(plan.from_s / kTickS) + 1);
    while (!stop && faults == 0 && !frames->full()) {
      frames->next() = runner->latest();
      frames->publish();
      go(film.every_ticks);
    }
    if (faults != 0) remark = "the expert's loop stopped at a fault of the computation";
  }

  static constexpr std::size_t kLoopBytes = std::size_t{128} << 20;

  Plan plan;
  device::ScriptedDevice blade_device;
  device::GuardedDevice blade;
  std::optional<device::ScriptedDevice> tube_device;
  std::optional<device::GuardedDevice> tube;
  HandActions keys;  ///< nobody's
  std::shared_ptr<const engine::Scene> scene;
  std::optional<HandsPort> port;
  std::unique_ptr<engine::Runner> runner;
  FilmPlan film;
  std::optional<FilmFrames> frames;
  std::atomic<bool> stop{false}, finished{false};
  std::string remark;  ///< written before `finished`
  std::thread worker;
};

ExpertLoop::ExpertLoop(const TrialSession& session) : impl_(std::make_unique<Impl>(session)) {}
ExpertLoop::~ExpertLoop() = default;

double ExpertLoop::duration_s() const {
  return static_cast<double>(impl_->film.frames) * static_cast<double>(impl_->film.every_ticks) * kTickS;
}
double ExpertLoop::computed_s() const {
  return static_cast<double>(impl_->frames->computed()) * static_cast<double>(impl_->film.every_ticks) * kTickS;
}
bool ExpertLoop::finished() const { return impl_->finished.load(std::memory_order_acquire); }
std::string ExpertLoop::remark() const { return finished() ? impl_->remark : std::string(); }

const engine::Snapshot* ExpertLoop::frame(double t) const {
  if (!std::isfinite(t)) return nullptr;
  const double frame_s = static_cast<double>(impl_->film.every_ticks) * kTickS;
  const auto count = static_cast<std::int64_t>(impl_->film.frames);
  const auto index = static_cast<std::int64_t>(std::floor(std::fmod(t, duration_s()) / frame_s + 1e-9));
  return impl_->frames->at(static_cast<std::size_t>((index % count + count) % count));
}

}  // namespace vallecula::gui

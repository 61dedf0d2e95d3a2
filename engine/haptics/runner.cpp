#include "engine/haptics/runner.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <thread>

#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "engine/haptics/servo.h"
#include "engine/haptics/snapshots.h"

namespace vallecula::engine {

namespace {

constexpr std::size_t kRingSize = 8192;           // records: 8 s
constexpr std::int64_t kPublishEverySteps = 8;    // snapshots at 125 Hz: twice what any screen shows
constexpr std::int64_t kGiveUpNs = 5'000'000;     // further behind than this the clock is set anew instead of caught up
constexpr std::int64_t kMissNs = 1'000'000;
constexpr std::uint64_t kShortTurnNs = 100'000;  // the least that Linux takes
constexpr int kBins = 2000, kBinNs = 10'000;      // step times: 10 us bins up to 20 ms

std::int64_t now_ns() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1'000'000'000LL + t.tv_nsec;
}

/// The newest ticks, frozen by the first one with a fault: what led to it travels with it. Sized once.
class FaultRing {
 public:
  void add(const TickRecord& record) noexcept {
    if (frozen_) return;
    ring_[static_cast<std::size_t>(added_++ % kSize)] = record;
    frozen_ = (record.faults & (kFaultDevicePose | kFaultTissue | kFaultForce)) != 0 ||
              (record.intubation.faults & ~std::uint32_t{kIntubationFaultHand | kIntubationFaultContacts}) != 0;
  }
  std::vector<TickRecord> before_fault() const {
    std::vector<TickRecord> ticks;
    for (std::int64_t i = std::max<std::int64_t>(0, added_ - kSize); frozen_ && i < added_; ++i)
      ticks.push_back(ring_[static_cast<std::size_t>(i % kSize)]);
    return ticks;
  }

 private:
  static constexpr std::int64_t kSize = 50;
  std::array<TickRecord, kSize> ring_;
  std::int64_t added_ = 0;
  bool frozen_ = false;
};

/// Of a thread that real-time priority is refused: it runs for short pieces and is to be let in at once when it wakes.
/// Linux from 6.12 on takes sched_runtime as the length of a piece by which it orders ordinary threads (sched_setattr(2));
/// before that the call changes nothing.
void ask_for_short_turns() {
  if (sched_getscheduler(0) != SCHED_OTHER) return;  // started as batch or idle on purpose
  struct {
    std::uint32_t size, policy;
    std::uint64_t flags;
    std::int32_t nice;
    std::uint32_t priority;
    std::uint64_t runtime_ns, deadline_ns, period_ns;
  } attributes{};
  attributes.size = sizeof attributes;
  attributes.policy = SCHED_OTHER;
  attributes.nice = getpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)));
  attributes.runtime_ns = kShortTurnNs;
  syscall(SYS_sched_setattr, 0, &attributes, 0U);
}

/// Real-time priority and an eager timer where the system grants them; says what was got.
std::string raise_this_thread(int priority) {
  prctl(PR_SET_TIMERSLACK, 1UL, 0, 0, 0);
  sched_param param{};
  param.sched_priority = priority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &param) == 0)
    return "real-time priority " + std::to_string(priority);
  ask_for_short_turns();
  return "ordinary priority (real-time priority was not granted; ticks may come late)";
}

}  // namespace

struct Runner::Impl {
  Impl(std::shared_ptr<const Scene> s, HapticPort& p)
      : scene(std::move(s)), port(p), state(*scene), snapshots(*scene), ring(kRingSize), bins(kBins, 0) {
    sem_init(&work, 0, 0);
  }
  ~Impl() {
    stop();
    sem_destroy(&work);
  }

  std::shared_ptr<const Scene> scene;
  HapticPort& port;
  SceneState state;
  ServoState servo;
  LatestSnapshot snapshots;

  // Records: single producer (servo), single consumer.
  FaultRing last_ticks;
  std::vector<TickRecord> ring;
  std::atomic<std::uint64_t> ring_head{0}, ring_tail{0};
  std::atomic<std::int64_t> dropped{0};

  // Servo -> simulation: the input slot is written only while the simulation idles (fed == done).
  StepInput input;
  std::array<StepResult, kResultSlots> results;  // the slot of step s is s % kResultSlots
  std::atomic<std::int64_t> fed{-1}, done{-1};
  sem_t work;
  std::atomic<bool> running{false};
  std::thread servo_thread, simulation_thread;

  std::atomic<std::int64_t> ticks{0}, misses{0}, overruns{0};
  std::atomic<double> rate{0.0};
  std::atomic<double> shown[3] = {0.0, 0.0, 0.0}, second_shown[3] = {0.0, 0.0, 0.0};
  std::int64_t began_ns = 0, ended_ns = 0;
  std::vector<std::int64_t> bins;
  std::string servo_priority, simulation_priority;

  void simulate(std::int64_t step_index) {
    const std::int64_t before = now_ns();
    const StepResult result = step(*scene, state, input);
    results[step_index % kResultSlots] = result;
    const std::int64_t bin = (now_ns() - before) / kBinNs;
    ++bins[std::min<std::int64_t>(bin, kBins - 1)];
    if (step_index % kPublishEverySteps == 0) {
      Snapshot& s = snapshots.to_write();
      fill_snapshot(*scene, state, result, s);
      for (int a = 0; a < 3; ++a) {
        s.displayed_force_n[a] = shown[a].load(std::memory_order_relaxed);
        s.intubation.displayed_force_n[a] = second_shown[a].load(std::memory_order_relaxed);
      }
      s.ticks = ticks.load(std::memory_order_relaxed);
      s.deadline_misses = misses.load(std::memory_order_relaxed);
      s.overruns = overruns.load(std::memory_order_relaxed);
      s.loop_rate_hz = rate.load(std::memory_order_relaxed);
      snapshots.publish();
    }
    done.store(step_index, std::memory_order_release);
  }

  void simulation_loop() {
    simulation_priority = raise_this_thread(79);
    for (;;) {
      while (sem_wait(&work) != 0 && errno == EINTR) {
      }
      if (!running.load(std::memory_order_acquire)) return;
      const std::int64_t step_index = fed.load(std::memory_order_acquire);
      if (step_index > done.load(std::memory_order_relaxed)) simulate(step_index);
    }
  }

  void push(const TickRecord& record) {
    const std::uint64_t head = ring_head.load(std::memory_order_relaxed);
    if (head - ring_tail.load(std::memory_order_acquire) >= kRingSize) {
      dropped.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    ring[head % kRingSize] = record;
    ring_head.store(head + 1, std::memory_order_release);
  }

  void show(const Vec3& force, const Vec3& second_force) {
    for (int a = 0; a < 3; ++a) {
      shown[a].store(force[a], std::memory_order_relaxed);
      second_shown[a].store(second_force[a], std::memory_order_relaxed);
    }
    port.write(force);
    if (scene->intubation) port.write_second(second_force);
  }

  void show(const TickRecord& record) {
    if (record.step_used >= 0) port.see_tool(record.proxy_pose);
    show(record.displayed_force_n, record.intubation.displayed_force_n);
  }

  void servo_loop() {
    servo_priority = raise_this_thread(80);
    const std::int64_t period = static_cast<std::int64_t>(scene->model.step_s * 1e9 + 0.5);
    std::int64_t due = now_ns() + period;
    std::int64_t second_began = due;
    began_ns = due;
    for (std::int64_t tick = 0; running.load(std::memory_order_acquire); ++tick) {
      timespec until{due / 1'000'000'000, due % 1'000'000'000};
      while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
      }
      const PortInput in = port.read(static_cast<double>(tick) * scene->model.step_s);
      const std::int64_t newest = done.load(std::memory_order_acquire);
      const std::int64_t last_fed = fed.load(std::memory_order_relaxed);
      const bool idle = newest == last_fed;
      const StepResult none;
      const StepResult& used = newest >= 0 ? results[newest % kResultSlots] : none;
      const std::int64_t feeding = idle ? last_fed + 1 : -1;
      const TickRecord record = servo_tick(*scene, tick, in, feeding, used, !idle, servo);
      show(record);
      if (now_ns() - due > kMissNs) misses.fetch_add(1, std::memory_order_relaxed);
      if (idle) {
        input = step_input(in);
        fed.store(feeding, std::memory_order_release);
        sem_post(&work);
      } else {
        overruns.fetch_add(1, std::memory_order_relaxed);
      }
      push(record);
      last_ticks.add(record);
      ticks.store(tick + 1, std::memory_order_relaxed);
      if ((tick + 1) % 1000 == 0) {
        const std::int64_t t = now_ns();
        rate.store(1000.0 * 1e9 / static_cast<double>(std::max<std::int64_t>(1, t - second_began)), std::memory_order_relaxed);
        second_began = t;
      }
      due += period;
      const std::int64_t behind = now_ns() - due;
      if (behind > kGiveUpNs) due += behind;
    }
    ended_ns = now_ns();
    show(Vec3::Zero(), Vec3::Zero());
  }

  void stop() {
    if (!running.exchange(false)) return;
    servo_thread.join();
    sem_post(&work);
    simulation_thread.join();
  }
};

Runner::Runner(std::shared_ptr<const Scene> scene, HapticPort& port)
    : impl_(std::make_unique<Impl>(std::move(scene), port)) {}

Runner::~Runner() = default;

void Runner::start() {
  Impl& m = *impl_;
  if (m.running || m.ticks > 0) throw std::logic_error("a runner runs once");
  mlockall(MCL_CURRENT | MCL_FUTURE);  // best effort: without the right to, pages may be swapped
  m.running = true;
  m.simulation_thread = std::thread([&m] { m.simulation_loop(); });
  m.servo_thread = std::thread([&m] { m.servo_loop(); });
}

void Runner::stop() { impl_->stop(); }

bool Runner::pop(TickRecord& record) {
  Impl& m = *impl_;
  const std::uint64_t tail = m.ring_tail.load(std::memory_order_relaxed);
  if (tail == m.ring_head.load(std::memory_order_acquire)) return false;
  record = m.ring[tail % kRingSize];
  m.ring_tail.store(tail + 1, std::memory_order_release);
  return true;
}

const Snapshot& Runner::latest() { return impl_->snapshots.read(); }

std::vector<TickRecord> Runner::ticks_before_fault() const { return impl_->last_ticks.before_fault(); }

TimingReport Runner::timing() const {
  const Impl& m = *impl_;
  TimingReport report;
  report.ticks = m.ticks;
  report.deadline_misses = m.misses;
  report.overruns = m.overruns;
  if (m.ended_ns > m.began_ns) report.loop_rate_hz = static_cast<double>(report.ticks) * 1e9 / static_cast<double>(m.ended_ns - m.began_ns);
  std::int64_t total = 0, sum = 0;
  for (std::int64_t n : m.bins) total += n;
  for (int i = 0; i < kBins; ++i) {
    sum += m.bins[i];
    const double upper = (i + 1) * kBinNs * 1e-6;
    if (report.step_p50_ms == 0 && 2 * sum >= total && total > 0) report.step_p50_ms = upper;
    if (report.step_p99_ms == 0 && 100 * sum >= 99 * total && total > 0) report.step_p99_ms = upper;
  }
  report.priority = "servo: " + m.servo_priority + "; simulation: " + m.simulation_priority;
  return report;
}

void Runner::run(std::int64_t ticks, const std::function<void(const TickRecord&)>& sink) {
  Impl& m = *impl_;
  if (m.began_ns == 0) m.began_ns = now_ns();
  for (std::int64_t i = 0; i < ticks; ++i) {
    const std::int64_t tick = m.ticks;
    const PortInput in = m.port.read(static_cast<double>(tick) * m.scene->model.step_s);
    const std::int64_t feeding = m.fed + 1;
    m.input = step_input(in);
    m.fed = feeding;
    m.simulate(feeding);
    const TickRecord record = servo_tick(*m.scene, tick, in, feeding, m.results[feeding % kResultSlots], false, m.servo);
    m.show(record);
    m.ticks = tick + 1;
    m.last_ticks.add(record);
    sink(record);
  }
  m.ended_ns = now_ns();
  m.servo_priority = m.simulation_priority = "none needed (not in real time)";
}

std::string instruction_set() { return "x86-64"; }

}  // namespace vallecula::engine

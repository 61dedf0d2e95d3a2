// Runs a scene: a servo thread at 1 kHz and a simulation thread, joined without locks; or both in turn on the caller's
// thread, as fast as they go.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/haptics/passivity.h"
#include "engine/haptics/port.h"
#include "engine/scene.h"
#include "engine/snapshot.h"
#include "engine/tick_record.h"

namespace vallecula::engine {

struct TimingReport {
  double loop_rate_hz = 0.0;           ///< servo ticks a second, mean over the run
  std::int64_t ticks = 0;
  std::int64_t deadline_misses = 0;    ///< forces written more than 1 ms after they were due
  std::int64_t overruns = 0;           ///< ticks whose step was not finished in time
  double step_p50_ms = 0.0, step_p99_ms = 0.0;  ///< work per simulation step
  std::string priority;                ///< what real-time set-up was granted, in words
};

class Runner {
 public:
  /// The port must outlive the runner. State starts at rest. The first device pose the port gives places the proxy.
  Runner(std::shared_ptr<const Scene> scene, HapticPort& port);
  ~Runner();  ///< stops
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Real time: starts both threads. Tick records go to a ring that one consumer must empty by pop() (it holds 8 s).
  void start();
  void stop();
  bool pop(TickRecord& record);        ///< wait-free, one consumer thread; false: nothing new
  /// Newest whole snapshot; wait-free; one consumer thread.
  const Snapshot& latest();
  TimingReport timing() const;         ///< after stop() or run()
  /// The 50 ticks up to and with the first that had a fault of the engine's or a pose's own (kFaultDevicePose,
  /// kFaultTissue, kFaultForce; of the second half all but kIntubationFaultHand and kIntubationFaultContacts), oldest first; empty without one. After
  /// stop() or run().
  std::vector<TickRecord> ticks_before_fault() const;

  /// As fast as it goes, on this thread: `ticks` servo ticks with a step each; `sink` gets each record.
  void run(std::int64_t ticks, const std::function<void(const TickRecord&)>& sink);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Recomputes a recorded trial tick by tick. Feed the records in order; each call takes the inputs of `recorded` (device
/// pose, validity, buttons, which step it fed, which step it used) and gives the record as computed now.
class Replayer {
 public:
  explicit Replayer(std::shared_ptr<const Scene> scene);
  ~Replayer();
  TickRecord replay(const TickRecord& recorded);
  const Snapshot& snapshot();          ///< of the newest step, for drawing a replay
  const PassivityObserver& energy() const;  ///< of the hand's, over the records so far

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Instruction-set level of the engine's kernels in this build, for the log ("x86-64").
std::string instruction_set();

}  // namespace vallecula::engine

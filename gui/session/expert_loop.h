// The scripted expert on this patient, computed while a trial waits or runs, to be looked at over and over.
#pragma once

#include <memory>
#include <string>

#include "engine/snapshot.h"

namespace vallecula::gui {

class TrialSession;

constexpr double kLoopS = 20.0;  ///< at most; from the blade's way into the mouth on: lift, and passage of the tube

class ExpertLoop {
 public:
  /// Begins to compute on a low-priority thread of its own, as fast as it goes, first what comes before the loop and is
  /// not kept. The session's scene is shared, which nobody changes; the session need not outlive this. Throws
  /// std::runtime_error where there is no plan for its patient.
  explicit ExpertLoop(const TrialSession& session);
  ~ExpertLoop();  ///< stops within a tick
  ExpertLoop(const ExpertLoop&) = delete;
  ExpertLoop& operator=(const ExpertLoop&) = delete;

  double duration_s() const;  ///< of the whole loop
  double computed_s() const;  ///< of it, from its begin on; any thread
  /// The frame at a second of the loop (the last one not later; beyond its end it begins anew): null while it has not
  /// been computed. Any thread; it stays as it is.
  const engine::Snapshot* frame(double t) const;
  bool finished() const;       ///< computed whole, or stopped short; any thread
  std::string remark() const;  ///< once finished: why it stopped short, for a person; empty: it did not

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vallecula::gui

// The scripted expert on this patient, computed while a trial waits or runs, to be looked at over and over.
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "curricula/scenario.h"
#include "engine/snapshot.h"
#include "gui/session/replay_film.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

class ExpertLoop {
 public:
  /// Begins to compute on a low-priority thread of its own, as fast as it goes, first what comes before the loop and is
  /// not kept. Throws std::runtime_error where there is no plan for this patient. Both are copied.
  ExpertLoop(const pipeline::PatientPackage& package, const curricula::Scenario& scenario);
  ~ExpertLoop();  ///< stops within a tick
  ExpertLoop(const ExpertLoop&) = delete;
  ExpertLoop& operator=(const ExpertLoop&) = delete;

  double duration_s() const;  ///< of the whole loop
  double computed_s() const;  ///< of it, from its begin on; any thread
  /// The frame at a second of the loop (the last one not later; beyond its end it begins anew): null while it has not
  /// been computed. Any thread; it stays as it is.
  const engine::Snapshot* frame(double t) const;
  std::string remark() const;  ///< why it stopped short, for a person; empty: it did not

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vallecula::gui

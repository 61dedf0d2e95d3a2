// One trial: joins device, engine and recorder, owns their threads and their shutdown. No window in here.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "curricula/scenario.h"
#include "curricula/score/score.h"
#include "device/haptic_device.h"
#include "engine/scene.h"
#include "engine/snapshot.h"
#include "gui/session/dual_task.h"
#include "gui/session/hand_actions.h"
#include "gui/session/held_tools.h"
#include "gui/session/holder.h"
#include "gui/session/peaks_so_far.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

struct TrialSetup {
  std::filesystem::path patient;                            ///< NAME.patient
  std::shared_ptr<const pipeline::PatientPackage> package;  ///< as it was read from there already; null: it is read
  std::filesystem::path curriculum;                         ///< YAML
  std::string scenario;                                     ///< id in it
  curricula::Mode mode = curricula::Mode::practice;
  std::uint32_t attempt_seed = 0;  ///< what the scenario's variation is drawn with; 0: as written
  curricula::ToolChoice taken;     ///< of the blades and tubes that the scenario offers
  std::string device;              ///< KIND[:ARG], one of device_names() (session/device_choice.h)
  std::string second;              ///< of the tube's hand, as HandsSetup (session/two_hands.h)
  /// A tool of its own (m, tool frame) instead of the scenario's blade; null: the blade.
  std::shared_ptr<const engine::TriangleMesh> tool;
  /// Folder for trial.vtrial, tool.ply (of a tool of its own), score.json, report.html, force.png, fault.csv.
  std::filesystem::path out;
  /// A device of the caller's own, made anew where a script would be; empty: by the name above.
  std::function<std::unique_ptr<device::HapticDevice>()> own_device, own_second_device;
  bool realtime = true;      ///< false: as fast as it goes, servo and simulation in lockstep on one thread
  long long trainee_id = 0;  ///< whose trial it is, by the records; 0, or a hand of a script or record: nobody's
  /// Builds the scene, where the caller has what one is built of faster; empty: engine::build_scene.
  std::function<std::shared_ptr<const engine::Scene>(const engine::SceneDescription&)> build_scene;
  std::filesystem::path final_out;  ///< where the caller will move `out` to once all is whole; empty: it stays
};

struct TrialOutcome {
  curricula::Score score;
  std::filesystem::path log, score_json, report, force_plot;
  std::string fault;           ///< in plain words, with the file its ticks are in; empty: none
  bool replay_allowed = true;  ///< false: an assessment, whose replay stays locked to its trainee
  bool by_person = true;       ///< false: a script's or a record's hand
  long long record_id = 0;     ///< of its row: what a rating or a note is given to
};

/// Life: construct (loads and builds; may take a second) -> start -> poll latest()/finished -> finish. start() and the
/// resets return at once; what goes to disk and records is the session's own thread's, before the first tick. finish()
/// is called once, and where it throws, the ticks written until then stay, to be kept when a program starts next; the
/// destructor stops the threads of a trial that was not finished and keeps its log as interrupted.
class TrialSession {
 public:
  explicit TrialSession(const TrialSetup& setup);  ///< throws std::runtime_error with one clear message
  ~TrialSession();  ///< of one that was started and not finished it may wait for disk and records: not on the window's
                    ///< thread
  TrialSession(const TrialSession&) = delete;
  TrialSession& operator=(const TrialSession&) = delete;

  const pipeline::PatientPackage& package() const;
  const curricula::Scenario& scenario() const;
  const engine::SceneDescription& scene() const;  ///< m, LPS: tool mesh, soft mesh, surfaces as the engine has them
  /// As it is stepped; to be stepped by others too.
  std::shared_ptr<const engine::Scene> built_scene() const;
  /// What became of trials that were cut off before this one, a sentence each.
  const std::vector<std::string>& notices() const;
  device::HapticDevice& device();  ///< a mouse device is fed through this (dynamic_cast to device::MouseDevice)
  /// Of the tube's hand; null: device() takes blade and tube in turn (takes_turns), or there is no tube.
  device::HapticDevice* second_device();
  bool takes_turns() const;
  Tool in_hand() const;    ///< which tool device() has. Any thread, while no reset() runs
  DualTask& dual_task();   ///< the scenario's distractions as they come up; answered by the window
  bool by_person() const;  ///< false: the device is a script's or a record's
  HandActions& actions();  ///< what the window's keys ask for; change_hand() makes device() take the other tool

  /// Returns at once. The log is made and the trial registered before the first tick, on another thread; where that
  /// fails, finished() turns true and problem() says why, as finish() would throw it.
  void start();
  /// Asked to start, and the first tick has not come: records or disk are being waited for. Window's thread.
  bool starting() const;
  /// Why the attempt could not begin or its log could not be written, for a person; empty: nothing so far. Any thread.
  std::string problem() const;
  /// Somebody holds the trial: its clock stands, no force is shown, the tools stay. Once all have let go it goes on as
  /// after any pause, when the hand confirms. A reset lets nobody go. Logged as a pause that names who held it. Throws
  /// std::runtime_error in an assessment. Window's thread.
  void freeze(Holder holder, bool on);
  /// A picture of the trial came to the screen. From the first one on a trial that a person steers is held by
  /// Holder::picture, an assessment too, once none has come for PictureWatch::kLongest: it is the caller who lets it
  /// go when pictures come again, or a reset. After ten minutes it is ended. Window's thread.
  void picture_shown();
  /// Whoever draws it has begun to: the first picture may take PictureWatch::kFirst.
  void picture_expected();
  bool frozen() const;                  ///< by anybody; any thread
  bool frozen_by(Holder holder) const;  ///< any thread
  /// No tick comes any more, and the hands are nobody's: waits for neither disk nor records. What is left to do is the
  /// destructor's.
  void halt();
  /// Why the trial is paused and what to do, for a person; empty: it is not. While it is, the tool stays where it was,
  /// no force is shown, and the trial's clock stands. Any thread, while no reset() runs.
  std::string pause() const;
  /// The hand confirms by a key that it has hold of the device again.
  void confirm();
  /// How long this attempt has been paused so far, s. Any thread.
  double paused_s() const;
  /// The largest forces of this attempt so far, of every tick that is on record. Any thread.
  PeaksSoFar peaks() const;
  /// The first fault of the loop in this attempt, in plain words; empty: none yet. Any thread.
  std::string fault() const;
  bool finished() const;  ///< the script or the scenario's time is over
  /// Tissue to rest, the attempt starts anew; the one before stays, recorded, as before-reset-N.vtrial, with its tool
  /// (where it had one of its own) as before-reset-N.tool.ply.
  /// `between`: called when the old attempt is over and the new one has not begun (a hand is put back then).
  void reset(const std::function<void()>& between = {});
  /// Practice only: as reset(), but the blade is first led the scripted expert's way until its tip is in the vallecula;
  /// then the hand has it from there, wherever the device is by then, without a jump. Throws std::runtime_error in an
  /// assessment. The trial is logged as begun at the vallecula: it counts neither as a time nor towards mastery.
  void reset_at_vallecula(const std::function<void()>& between = {});
  /// The blade is still being led there; the hand does nothing yet. Any thread, while no reset() runs.
  bool led_in() const;
  /// Patient and tools as they are before the first tick, the hands where a person's begin. Any thread.
  const engine::Snapshot& at_start() const;
  /// Newest whole snapshot; wait-free; to be called by one thread only (the window's).
  const engine::Snapshot& latest();
  TrialOutcome finish(const std::string& how);  ///< stops, closes the log, scores, writes the results, adds the record

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vallecula::gui

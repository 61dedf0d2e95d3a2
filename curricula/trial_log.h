// The trial log (DESIGN 4.6): header once, then one record per servo tick. Written in checksummed blocks, recovered
// up to the last whole block, little-endian on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vallecula::curricula {

enum class LoggedState : std::uint8_t { tracking = 0, limited = 1, lost = 2, recovering = 3 };

/// Order of LogTick::loads.
enum LoadedStructure { kTongue = 0, kEpiglottis, kGum, kPalate, kTeeth, kLarynx, kStructures };

struct LogPose {
  std::array<double, 3> position_m{};
  std::array<double, 4> rotation_wxyz{1, 0, 0, 0};
};

struct LogLoad {
  std::array<double, 3> force_n{};   ///< on the tool, world axes
  std::array<double, 3> centre_m{};  ///< of the contacts, world
  std::int32_t contacts = 0;
  double area_m2 = 0.0;  ///< of the tissue's surface at rest that they stand for; 0: none, or not known (rigid anatomy)
};

/// What the second hand holds, and where its tip is. `larynx`: from the inlet to the cricoid.
enum class LoggedInHand : std::uint8_t { tube_with_stylet = 0, tube, catheter };
enum class LoggedPlace : std::uint8_t { outside = 0, mouth, larynx, trachea, main_bronchus, oesophagus };

/// Order of LogIntubation::loads_n.
enum LoggedTubeLoad {
  kTubeVestibule = 0,
  kTubeCords,
  kTubeSubglottis,
  kTubeCricoid,
  kTubeTrachea,
  kTubeBronchus,
  kTubeOesophagus,
  kTubePharynx,
  kTubeTongue,
  kTubeEpiglottis,
  kTubeBlade,
  kTubeLoads
};
constexpr std::uint8_t kNothingAgainstTip = 255;

/// The second half of the procedure in one tick: the same fields as engine::IntubationRecord.
struct LogIntubation {
  LogPose hand_pose;
  bool hand_valid = true;
  LoggedInHand in_hand = LoggedInHand::tube;
  std::array<double, 3> tip_m{};
  std::array<double, 3> tip_direction{0, 0, 1};
  LoggedPlace place = LoggedPlace::outside;
  std::int8_t side = -1;      ///< main bronchus that the tip is in: 0 right, 1 left; -1: in none
  double past_cords_m = 0.0;  ///< of the tip along the airway, at most 0 above; in the oesophagus from its mouth
  double at_mouth_m = 0.0;    ///< the tube's mark at the upper lip; 0: outside
  double buckled_m = 0.0;
  std::array<double, 3> model_force_n{};  ///< on the second hand, world axes
  std::array<double, 3> displayed_force_n{};
  std::array<double, kTubeLoads> loads_n{};       ///< by what is touched, sums of magnitudes
  double tip_load_n = 0.0;                        ///< along the tube, of what stands before its tip
  std::uint8_t tip_against = kNothingAgainstTip;  ///< what that is, mostly: a LoggedTubeLoad
  double glottis_opening = 0.0;                   ///< 0..1
  bool spasm = false;
  double secretions_ml = 0.0;
  double sao2 = 0.0, spo2 = 0.0;  ///< 0..1; true, displayed
  double heart_per_min = 0.0;
  bool detector_yellow = false;
  std::int32_t breaths_given = 0;  ///< since the trial began
  double given_per_min = 0.0;
  std::uint32_t faults = 0;
};

/// What happened beside the hands: the dual task. Reaction times are differences of ticks.
struct LogEvent {
  enum class Kind : std::uint8_t { shown = 0, answered, silenced };
  std::int64_t tick = 0;  ///< of the tick that was the newest then
  Kind kind = Kind::shown;
  int distraction = 0;  ///< of the scenario, counted from 1
  int answer = 0;       ///< that was chosen, counted from 1; 0 where none was
};

/// One servo tick. The same fields as engine::TickRecord; curricula knows no engine, so they are written out here.
struct LogTick {
  std::int64_t tick = 0;
  double time_s = 0.0;
  LogPose device_pose;
  std::uint32_t buttons = 0;
  bool device_valid = true;
  std::int64_t step_fed = -1;
  std::int64_t step_used = -1;
  LogPose proxy_pose;
  LoggedState state = LoggedState::tracking;
  std::array<double, 3> model_force_n{};
  std::array<double, 3> model_torque_nm{};
  std::array<double, 3> displayed_force_n{};
  std::array<LogLoad, kStructures> loads{};
  bool has_areas = false;  ///< of the trial: the loads' areas are known; not in logs of a schema below 4
  bool has_sight = false;
  double glottis_visible = 0.0;
  std::uint32_t faults = 0;
  bool has_intubation = false;  ///< of the trial: the same in all its ticks
  LogIntubation intubation;
};

/// The trial's clock stands: a device that a hand needs cannot be used.
inline bool paused(const LogTick& tick) noexcept {
  return !tick.device_valid || (tick.has_intubation && !tick.intubation.hand_valid);
}

/// The tube's tip, not the catheter's, is in the oesophagus.
inline bool tube_in_oesophagus(const LogTick& tick) noexcept {
  return tick.intubation.in_hand != LoggedInHand::catheter && tick.intubation.place == LoggedPlace::oesophagus;
}

/// The setting a depth is judged by: this infant's way from the cords to the carina, m.
constexpr char kCordsToCarina[] = "cords_to_carina_m";
/// How far the upper lip stands before the gums' plane, m: at_mouth_m is read there. A log without it was recorded when
/// at_mouth_m was read at the gums, and has no mark at the lips.
constexpr char kLipsBeforeGums[] = "lips_before_gums_m";
/// The head's extension on the neck, degrees; where it is known, depth is told for the neutral head as well.
constexpr char kHeadExtension[] = "head_extension_deg";

/// Of a trial begun at the vallecula: so many ticks, not counting those in a pause, the blade was led there by a plan.
/// In them its device was told no force, whatever displayed_force_n has: that is what the servo would have shown, and
/// what a replay computes.
constexpr char kLeadInTicks[] = "lead_in_ticks";

/// Bits of LogTick::buttons that scores ask for (engine::Action has all of them).
enum LoggedAction : std::uint32_t {
  kLoggedEyeRight = 1u << 21,
  kLoggedEyeLeft = 1u << 22,
  kLoggedEyeUp = 1u << 23,
  kLoggedEyeDown = 1u << 24,
  kLoggedExtension = 1u << 25,
  kLoggedEyeMoves = kLoggedEyeRight | kLoggedEyeLeft | kLoggedEyeUp | kLoggedEyeDown,
  kLoggedAided = 1u << 31,  ///< in a pause as well
  kLoggedSaturationDriven = (1u << 26) | (1u << 27),
  kLoggedHeartDriven = (1u << 28) | (1u << 29),
  kLoggedSpasm = 1u << 30,
};

/// Everything that must be known to understand and to repeat the trial. No identity of patient or trainee.
struct LogHeader {
  int schema = 1;  ///< as read; written: 4 with events or contact areas, 3 with an intubation, 2 with a tool of its
                   ///< own, which older readers must not miss
  std::string software_version;
  std::string build_hash;       ///< of the program that wrote it
  std::string instruction_set;  ///< kernels' level, for instance "x86-64"
  std::string package_name;
  std::string package_path;     ///< from the log's folder, or the bare name: never a person's folders
  std::string package_sha256;   ///< of patient.yaml
  std::string curriculum_path;  ///< likewise
  std::string scenario_id;
  std::string scenario_yaml;  ///< the scenario's text: scoring needs no other file
  std::string scenario_sha256;
  std::string tool_sha256;         ///< of tool.ply beside the log; empty: the scenario's blade
  bool has_events = false;         ///< of the scenario's distractions; without it there can be none
  bool has_contact_areas = false;  ///< its ticks have the areas of their loads
  bool has_intubation = false;     ///< its ticks have the second half; settings then hold kCordsToCarina
  std::string device_kind;         ///< scores are never pooled across kinds
  double servo_period_s = 0.001;
  double device_limit_n = 7.9;
  bool realtime = false;
  std::map<std::string, double> settings;                    ///< engine settings by name
  std::map<std::string, std::array<double, 3>> landmarks_m;  ///< patient landmarks in metres
};

/// LogFooter::ended, where the trainee ended it to begin anew, or ended it.
constexpr const char* kEndedByReset = "reset";
constexpr const char* kEndedByTrainee = "ended by trainee";

/// What is known only at the end.
struct LogFooter {
  bool complete = false;  ///< false: the trial was cut off; the ticks are up to the last whole block
  std::string ended;      ///< one of the two below, "finished", ...
  double loop_rate_hz = 0.0;
  std::int64_t deadline_misses = 0;
  std::int64_t overruns = 0;              ///< ticks whose simulation step was not finished in time
  std::string real_time_setup;            ///< what priority the threads were granted, in words; empty in older logs
  std::vector<std::string> pause_faults;  ///< the device's fault of each pause in order, "" where it is not known; none
                                          ///< in older logs
};

struct TrialLog {
  LogHeader header;
  std::vector<LogTick> ticks;
  std::vector<LogEvent> events;  ///< by growing tick
  LogFooter footer;
};

class TrialLogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends ticks in checksummed blocks to PATH.part, which it holds locked and syncs every second or so; close() writes
/// the footer, syncs and renames to PATH. A PATH.part that another trial is writing is an error.
class TrialLogWriter {
 public:
  TrialLogWriter(const std::filesystem::path& path, const LogHeader& header);
  ~TrialLogWriter();
  TrialLogWriter(const TrialLogWriter&) = delete;
  TrialLogWriter& operator=(const TrialLogWriter&) = delete;
  void append(const LogTick& tick);
  /// Not before the tick it names has been appended. The ticks before it go to the file as well.
  void append(const LogEvent& event);
  void close(const LogFooter& footer);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads a log (a .vtrial file, a .part left by a crash, or the folder that holds trial.vtrial). Throws TrialLogError.
TrialLog read_trial_log(const std::filesystem::path& path);

/// PATH.part is held by its writer, of this program or another.
bool is_being_written(const std::filesystem::path& path);

enum class CutLog {
  nothing,        ///< there is neither PATH nor a tick in PATH.part, which is removed
  no_folder,      ///< not even the folder is there: its disk may be elsewhere
  being_written,  ///< its writer lives
  whole,          ///< PATH is there, closed by its writer
  kept            ///< PATH.part has become PATH
};
/// Makes the log of a writer that was cut off (killed, power cut) a whole one: PATH.part is cut after its last whole
/// block and gets a footer that says so (complete is false, ended "interrupted"), then the name PATH. What is recorded
/// before stays as it is, to the byte; where what follows is damage and not a cut, PATH.damaged keeps the file as it
/// was. May be cut off itself and done again. Throws TrialLogError: the header or the first ticks are damaged
/// (PATH.part stays), the disk is full.
CutLog close_cut_log(const std::filesystem::path& path);

}  // namespace vallecula::curricula

// What is checked of a device before a session, step by step: what the person is asked for, and what came of it.
#pragma once

#include <QCoreApplication>
#include <QDateTime>
#include <QString>
#include <array>
#include <functional>
#include <vector>

#include "gui/instructor/device_probe.h"

namespace vallecula::gui {

/// In this order.
enum class CheckStep { opened, calibration, rate, moves, reach, force, buttons };
constexpr int kCheckSteps = 7;
enum class CheckVerdict { to_come, under_way, good, bad, skipped };

struct CheckLine {
  CheckVerdict verdict = CheckVerdict::to_come;
  QString words;  ///< what was found, for a person
};

/// Of one device, at one time; kept for the session only.
struct CheckResult {
  QString device;  ///< KIND[:ARG]
  QDateTime at;
  std::array<CheckLine, kCheckSteps> lines;
  int bad() const;
};

/// What a laryngoscopy needs: width, height and depth of the way of the blade's tip and of the tube, m.
constexpr std::array<double, 3> kMouthReachM{0.040, 0.040, 0.080};
/// Judged good: at least this rate, and no larger share of late forces.
constexpr double kLeastRateHz = 950.0, kMostLateShare = 0.01;
constexpr double kMeasureS = 2.0;
/// A move counts once it is this long.
constexpr double kMoveM = 0.025;

/// The places that the reach step asks for, in the order of reached().
enum ReachMark { kTopLeft, kTopRight, kBottomLeft, kBottomRight, kNear, kFar, kReachMarks };

/// Life: begin with a probe (or with why there is none) -> look() every few frames, and what the person does -> over().
/// It has no widget and no thread; the probe must outlive it.
class CheckRun {
  Q_DECLARE_TR_FUNCTIONS(vallecula::gui::CheckRun)
 public:
  /// `clutch_button`: as a person counts the device's buttons; 0: none. `random`: 0 or 1, the sign of each push.
  CheckRun(DeviceProbe& probe, int clutch_button, std::function<int()> random);
  /// Of a device that could not be opened.
  static std::array<CheckLine, kCheckSteps> not_opened(const QString& why);

  void look();
  void push();                    ///< the person holds the handle and is ready
  void felt(int axis, int sign);  ///< which way; sign 0: nothing was felt
  void cannot();                  ///< what is asked for cannot be done: bad, and on to the next
  void centre();                  ///< the reach is counted from where the hand is

  static QString title(CheckStep step);
  const std::array<CheckLine, kCheckSteps>& lines() const { return lines_; }
  CheckStep step() const { return step_; }
  bool over() const { return over_; }
  QString ask() const;  ///< what the person is to do now; empty: nothing
  bool may_push() const;
  bool may_answer() const;
  const std::array<bool, kReachMarks>& reached() const { return reached_; }
  const ProbeState& state() const { return state_; }

 private:
  CheckLine& line(CheckStep step) { return lines_[static_cast<std::size_t>(step)]; }
  void end_step(CheckVerdict verdict, const QString& words);
  void begin_step(CheckStep step);
  void look_at_calibration();
  void look_at_rate();
  void look_at_moves();
  void look_at_reach();
  void look_at_buttons();
  QString missing_marks() const;

  DeviceProbe& probe_;
  const int clutch_;
  const std::function<int()> random_;
  std::array<CheckLine, kCheckSteps> lines_;
  CheckStep step_ = CheckStep::opened;
  bool over_ = false;
  ProbeState state_;
  // Of the step under way.
  int part_ = 0;             ///< the direction that is asked for, or pushed along
  bool second_try_ = false;  ///< of a move
  int asked_ = 0;            ///< which measure or centre of the probe this step waits for
  std::array<double, 3> from_m_{0, 0, 0};
  std::array<bool, kReachMarks> reached_{};
  int pushes_asked_ = 0, pushed_sign_ = 1;
  QStringList wrong_;
  double largest_push_n_ = 0.0;
  std::uint32_t pressed_ = 0;
  bool clutched_ = false;
};

/// "to the right", "towards you", ...
QString direction_words(int axis, int sign);

}  // namespace vallecula::gui

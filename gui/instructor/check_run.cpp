#include "gui/instructor/check_run.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "device/rotation.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {

using Step = CheckStep;
using Verdict = CheckVerdict;

namespace {

QString fault_words(device::DeviceFault fault) { return in_words(device::describe(fault)); }

/// A device that was just opened may need so long for its first reading.
constexpr double kSettleS = 1.0;

/// The axis in which a way is longest, and its sign.
std::pair<int, int> main_direction(const device::Vector& way) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::fabs(way[static_cast<std::size_t>(i)]) > std::fabs(way[static_cast<std::size_t>(axis)])) axis = i;
  return {axis, way[static_cast<std::size_t>(axis)] < 0.0 ? -1 : 1};
}

}  // namespace

QString direction_words(int axis, int sign) {
  const char* words[3][2] = {
      {QT_TRANSLATE_NOOP("Direction", "to the left"), QT_TRANSLATE_NOOP("Direction", "to the right")},
      {QT_TRANSLATE_NOOP("Direction", "down"), QT_TRANSLATE_NOOP("Direction", "up")},
      {QT_TRANSLATE_NOOP("Direction", "away from you"), QT_TRANSLATE_NOOP("Direction", "towards you")}};
  return QCoreApplication::translate("Direction", words[axis][sign > 0 ? 1 : 0]);
}

int CheckResult::bad() const {
  return static_cast<int>(
      std::count_if(lines.begin(), lines.end(), [](const CheckLine& line) { return line.verdict == Verdict::bad; }));
}

QString CheckRun::title(Step step) {
  switch (step) {
    case Step::opened:
      return tr("Found and opened");
    case Step::calibration:
      return tr("Calibration");
    case Step::rate:
      return tr("Rate");
    case Step::moves:
      return tr("Directions of motion");
    case Step::reach:
      return tr("Reach over the mouth");
    case Step::force:
      return tr("Directions of force");
    case Step::buttons:
      break;
  }
  return tr("Buttons and clutch");
}

CheckRun::CheckRun(DeviceProbe& probe, int clutch_button, std::function<int()> random)
    : probe_(probe), clutch_(probe.info().own_axes ? clutch_button : 0), random_(std::move(random)) {
  const device::DeviceInfo& info = probe_.info();
  end_step(
      Verdict::good,
      info.serial.empty()
          ? QString::fromStdString(info.model)
          : tr("%1, serial number %2").arg(QString::fromStdString(info.model), QString::fromStdString(info.serial)));
}

std::array<CheckLine, kCheckSteps> CheckRun::not_opened(const QString& why) {
  std::array<CheckLine, kCheckSteps> lines;
  for (CheckLine& line : lines) line = {Verdict::skipped, tr("not come to")};
  lines[0] = {Verdict::bad, why};
  return lines;
}

void CheckRun::end_step(Verdict verdict, const QString& words) {
  line(step_) = {verdict, words};
  if (step_ == Step::buttons)
    over_ = true;
  else
    begin_step(static_cast<Step>(static_cast<int>(step_) + 1));
}

void CheckRun::begin_step(Step step) {
  step_ = step;
  line(step).verdict = Verdict::under_way;
  part_ = 0;
  second_try_ = false;
  from_m_ = state_.tool_m;
  wrong_.clear();
  if (step == Step::rate) asked_ = probe_.measure();
  if (step == Step::reach) centre();
  if (step == Step::force && probe_.push_n() <= 0.0) end_step(Verdict::skipped, tr("the device shows no force"));
  if (step_ == Step::buttons && line(step_).verdict == Verdict::under_way && clutch_ == 0)
    end_step(Verdict::skipped,
             probe_.info().own_axes ? tr("no button is the clutch (Device settings)") : tr("it needs no clutch"));
}

void CheckRun::look() {
  if (over_) return;
  state_ = probe_.newest();
  // Calibrated by the hand, or just opened: its first reading may still be on its way.
  const bool waits = step_ == Step::calibration &&
                     (state_.fault == device::DeviceFault::not_calibrated || state_.measured_s < kSettleS);
  if (state_.guard == device::GuardState::confirming && step_ == Step::calibration) {
    probe_.confirm();
    return;
  }
  if (state_.fault != device::DeviceFault::none && !waits) {
    line(step_) = {Verdict::bad, tr("It failed here: %1").arg(fault_words(state_.fault))};
    for (int later = static_cast<int>(step_) + 1; later < kCheckSteps; ++later)
      lines_[static_cast<std::size_t>(later)] = {Verdict::skipped, tr("not come to")};
    over_ = true;
    return;
  }
  if (step_ == Step::calibration)
    look_at_calibration();
  else if (step_ == Step::rate)
    look_at_rate();
  else if (step_ == Step::moves)
    look_at_moves();
  else if (step_ == Step::reach)
    look_at_reach();
  else if (step_ == Step::buttons)
    look_at_buttons();
}

void CheckRun::look_at_calibration() {
  if (state_.ticks == 0 || state_.fault != device::DeviceFault::none) return;  // nothing was read yet
  if (state_.calibration == device::Calibration::not_needed) end_step(Verdict::good, tr("not needed"));
  if (state_.calibration == device::Calibration::good) end_step(Verdict::good, tr("good"));
}

void CheckRun::look_at_rate() {
  if (state_.measures != asked_ || state_.measured_s < kMeasureS) return;
  const double rate_hz = static_cast<double>(state_.ticks) / state_.measured_s;
  const double late = static_cast<double>(state_.late) / static_cast<double>(std::max<std::int64_t>(1, state_.ticks));
  const QString words = (state_.real_time ? tr("%1 Hz over %2 s, %3 % of the forces late by more than 1 ms")
                                          : tr("%1 Hz over %2 s, %3 % of the forces late by more than 1 ms, without "
                                               "real-time priority"))
                            .arg(rate_hz, 0, 'f', 0)
                            .arg(decimal(state_.measured_s, 1))
                            .arg(decimal(100.0 * late, 1));
  if (rate_hz >= kLeastRateHz && late <= kMostLateShare) return end_step(Verdict::good, words);
  end_step(Verdict::bad,
           tr("%1: too slow (at least %2 Hz, at most %3 % late). End other programs; use a port of its own")
               .arg(words)
               .arg(kLeastRateHz, 0, 'f', 0)
               .arg(100.0 * kMostLateShare, 0, 'f', 0));
}

void CheckRun::look_at_moves() {
  const device::Vector way = device::subtract(state_.tool_m, from_m_);
  if (device::length(way) < kMoveM) return;
  from_m_ = state_.tool_m;
  const auto [axis, sign] = main_direction(way);
  if (axis != part_ || sign < 0) {
    if (!second_try_) {
      second_try_ = true;
      line(step_).words =
          tr("It went %1. Once more, straight %2").arg(direction_words(axis, sign), direction_words(part_, 1));
      return;
    }
    wrong_ << tr("moved %1, it went %2").arg(direction_words(part_, 1), direction_words(axis, sign));
  }
  second_try_ = false;
  line(step_).words.clear();
  if (++part_ < 3) return;
  if (wrong_.isEmpty()) return end_step(Verdict::good, tr("right, up and towards you are as they should be"));
  end_step(Verdict::bad,
           tr("%1: axes are exchanged, or the device stands turned (Device settings)").arg(wrong_.join("; ")));
}

void CheckRun::look_at_reach() {
  if (state_.centres != asked_) return;
  const auto [right, up, near] = state_.tool_m;
  const double w = 0.5 * kMouthReachM[0], h = 0.5 * kMouthReachM[1], d = 0.5 * kMouthReachM[2];
  reached_[kTopLeft] |= right <= -w && up >= h;
  reached_[kTopRight] |= right >= w && up >= h;
  reached_[kBottomLeft] |= right <= -w && up <= -h;
  reached_[kBottomRight] |= right >= w && up <= -h;
  reached_[kNear] |= near >= d;
  reached_[kFar] |= near <= -d;
  if (std::all_of(reached_.begin(), reached_.end(), [](bool one) { return one; }))
    end_step(Verdict::good, tr("covers %1 x %2 x %3 mm")
                                .arg(1e3 * kMouthReachM[0], 0, 'f', 0)
                                .arg(1e3 * kMouthReachM[1], 0, 'f', 0)
                                .arg(1e3 * kMouthReachM[2], 0, 'f', 0));
}

QString CheckRun::missing_marks() const {
  const QString names[kReachMarks] = {tr("top left"),     tr("top right"), tr("bottom left"),
                                      tr("bottom right"), tr("near"),      tr("far")};
  QStringList missing;
  for (int i = 0; i < kReachMarks; ++i)
    if (!reached_[static_cast<std::size_t>(i)]) missing << names[i];
  return missing.join(", ");
}

void CheckRun::centre() {
  asked_ = probe_.centre();
  reached_ = {};
}

bool CheckRun::may_push() const { return !over_ && step_ == Step::force && pushes_asked_ == part_; }

bool CheckRun::may_answer() const {
  return !over_ && step_ == Step::force && pushes_asked_ == part_ + 1 && state_.pushes >= pushes_asked_;
}

void CheckRun::push() {
  if (!may_push()) return;
  pushed_sign_ = random_() == 0 ? -1 : 1;
  ++pushes_asked_;
  probe_.push(part_, pushed_sign_);
}

void CheckRun::felt(int axis, int sign) {
  if (!may_answer()) return;
  largest_push_n_ = std::max(largest_push_n_, state_.pushed_n);
  if (state_.pushed_away)
    wrong_ << tr("pushed %1, the handle went away: hold it").arg(direction_words(part_, pushed_sign_));
  else if (sign == 0)
    wrong_ << tr("pushed %1, nothing was felt").arg(direction_words(part_, pushed_sign_));
  else if (axis != part_ || sign != pushed_sign_)
    wrong_ << tr("pushed %1, felt %2").arg(direction_words(part_, pushed_sign_), direction_words(axis, sign));
  if (++part_ < 3) return;
  const QString size = tr("%1 N").arg(decimal(largest_push_n_, 1));
  if (wrong_.isEmpty()) return end_step(Verdict::good, tr("felt as pushed, with %1").arg(size));
  end_step(Verdict::bad,
           tr("%1 (with %2): do not practise with this device before it is mended").arg(wrong_.join("; "), size));
}

void CheckRun::look_at_buttons() {
  pressed_ |= state_.buttons;
  if (state_.guard == device::GuardState::clutched) clutched_ = true;
  if (!clutched_ || state_.guard == device::GuardState::clutched) return;
  QStringList numbers;
  for (int n = 1; n <= 16; ++n)
    if ((pressed_ & bit_of_button(n)) != 0) numbers << QString::number(n);
  end_step(Verdict::good, tr("button %1 frees the hand; pressed: %2").arg(clutch_).arg(numbers.join(", ")));
}

void CheckRun::cannot() {
  if (over_) return;
  if (step_ == Step::calibration)
    end_step(Verdict::bad, fault_words(device::DeviceFault::not_calibrated));
  else if (step_ == Step::moves)
    end_step(Verdict::bad, tr("the device does not move %1").arg(direction_words(part_, 1)));
  else if (step_ == Step::reach)
    end_step(Verdict::bad, tr("not reached: %1. Begin in the middle of the device's range, or make the blade's way "
                              "longer (Device settings)")
                               .arg(missing_marks()));
  else if (step_ == Step::force)
    end_step(Verdict::skipped, tr("left out"));
  else if (step_ == Step::buttons)
    end_step(Verdict::bad, pressed_ == 0 ? tr("no button was noticed")
                                         : tr("the clutch, button %1, was not noticed; others were").arg(clutch_));
}

QString CheckRun::ask() const {
  if (over_) return {};
  switch (step_) {
    case Step::calibration:
      return fault_words(device::DeviceFault::not_calibrated);
    case Step::rate:
      return tr("Hold still: the rate is measured for %1 s.").arg(kMeasureS, 0, 'f', 0);
    case Step::moves:
      return (probe_.info().kind == "mouse"        ? tr("Move the blade %1, about %2 cm: drag, wheel or keys.")
              : probe_.info().kind == "spacemouse" ? tr("Push the cap %1, until the blade has gone about %2 cm.")
                                                   : tr("Move the handle %1, about %2 cm."))
          .arg(direction_words(part_, 1))
          .arg(1e2 * kMoveM + 0.5, 0, 'f', 0);
    case Step::reach:
      return tr("Go to the four corners, then far and near. Still to come: %1.").arg(missing_marks());
    case Step::force:
      if (may_push())
        return tr("Hold the handle as in a trial. Push %1 of 3, with at most %2 N: press Push when you are ready.")
            .arg(part_ + 1)
            .arg(decimal(probe_.push_n(), 1));
      return may_answer() ? tr("Which way were you pushed?") : tr("Feel which way it pushes ...");
    case Step::buttons:
      return tr("Press and hold button %1, the clutch, and let it go.").arg(clutch_);
    case Step::opened:
      break;
  }
  return {};
}

}  // namespace vallecula::gui

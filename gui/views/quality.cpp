#include "gui/views/quality.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace vallecula::gui {
namespace {

/// A step's pixels and what else it leaves out save a third of a frame at most: 1.5 for 85 to 70 % a side, with nothing
/// else to draw. What seems more or less came from other programs meanwhile.
constexpr double kSavesLeast = 1.02, kSavesMost = 1.6, kSavesUnknown = 2.2;

}  // namespace

QualityGovernor::Mode QualityGovernor::mode_of(const QString& setting) {
  return setting == "high" ? Mode::high : setting == "low" ? Mode::low : Mode::automatic;
}

void QualityGovernor::set_mode(Mode mode) {
  mode_ = mode;
  window_begins_s_ = -1.0;
  calm_s_ = given_up_at_ = 0.0;
  if (mode == Mode::high) step_ = 0;
  if (mode == Mode::low) step_ = static_cast<int>(kQualities.size()) - 1;
}

void QualityGovernor::hold(int step) {
  mode_ = Mode::held;
  take(step);
}

bool QualityGovernor::take(int step) {
  const int within = std::clamp(step, 0, static_cast<int>(kQualities.size()) - 1);
  calm_s_ = given_up_at_ = 0.0;
  const bool changed = within != step_;
  step_ = within;
  return changed;
}

bool QualityGovernor::frame(double now_s, double busy_s) {
  if (mode_ != Mode::automatic) return false;
  if (window_begins_s_ < 0.0 || now_s < window_begins_s_ || now_s - window_begins_s_ > 3.0 * kWindowS) {
    window_begins_s_ = now_s;  // the first frame, or the first after a pause: what it cost belongs to no second
    busy_s_ = calm_s_ = given_up_at_ = 0.0;
    frames_ = 0;
    return false;
  }
  busy_s_ += busy_s;
  ++frames_;
  const double length = now_s - window_begins_s_;
  if (length < kWindowS) return false;
  const double share = busy_s_ / frames_ / kFrameS;
  window_begins_s_ = now_s;
  busy_s_ = 0.0;
  frames_ = 0;
  const double before = cost_of_step_before(share);
  if (share > kBusyMost) {
    const bool changed = take(step_ + 1);
    if (changed) given_up_at_ = share;
    return changed;
  }
  calm_s_ = before < kBusyAgain ? calm_s_ + length : 0.0;
  return calm_s_ >= kCalmS && take(step_ - 1);
}

double QualityGovernor::cost_of_step_before(double share) {
  double& saves = saves_[static_cast<std::size_t>(step_)];
  if (given_up_at_ > 0.0) saves = std::clamp(given_up_at_ / share, kSavesLeast, kSavesMost);
  given_up_at_ = 0.0;
  return share * (saves > 0.0 ? saves : kSavesUnknown);
}

QString QualityGovernor::reduced() const {
  const Quality& now = quality();
  QStringList left_out;
  if (!now.rim) left_out << QCoreApplication::translate("QualityGovernor", "rim light");
  if (!now.shadows) left_out << QCoreApplication::translate("QualityGovernor", "shadows");
  if (now.coarser > 0) left_out << QCoreApplication::translate("QualityGovernor", "fine tongue");
  if (now.resolution < 1.0)
    left_out << QCoreApplication::translate("QualityGovernor", "resolution (%1 %)")
                    .arg(static_cast<int>(100.0 * now.resolution + 0.5));
  if (least()) left_out << QCoreApplication::translate("QualityGovernor", "cut and video in turn");
  return left_out.isEmpty() ? QString()
                            : QCoreApplication::translate("QualityGovernor", "Drawn with less to stay fluent: %1")
                                  .arg(left_out.join(", "));
}

}  // namespace vallecula::gui

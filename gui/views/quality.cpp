#include "gui/views/quality.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace vallecula::gui {
namespace {

/// What a step saves, as the cost of the one before over its own. Pixels and what else is left out make 1.5 at most,
/// with nothing else to draw; what seems more or less came from other programs meanwhile.
constexpr double kSavesLeast = 1.02, kSavesMost = 1.6, kSavesUnseen = 1.05;
constexpr double kAgree = 0.1;       ///< two seconds of one step tell the same
constexpr double kSoonS = 10.0;      ///< a fall so soon after a step was taken back undoes it
constexpr int kMostDoublings = 4;    ///< of the calm that is waited for after it
constexpr double kTryS = 60.0;       ///< of room at a step, and the one before is tried, whatever was seen of it
constexpr double kForgivenS = 60.0;  ///< without a fall, and one of them is taken off

}  // namespace

QualityGovernor::Mode QualityGovernor::mode_of(const QString& setting) {
  return setting == "high" ? Mode::high : setting == "low" ? Mode::low : Mode::automatic;
}

void QualityGovernor::set_mode(Mode mode) {
  mode_ = mode;
  saves_ = {};
  doublings_ = 0;
  pause();
  if (mode == Mode::high) step_ = 0;
  if (mode == Mode::low) step_ = static_cast<int>(kQualities.size()) - 1;
}

/// What was begun to be seen is not gone on with.
void QualityGovernor::pause() {
  window_begins_s_ = -1.0;
  busy_s_ = calm_s_ = room_s_ = given_up_at_ = first_second_ = 0.0;
  frames_ = 0;
}

void QualityGovernor::hold(int step) {
  mode_ = Mode::held;
  take(step);
}

bool QualityGovernor::take(int step) {
  const int within = std::clamp(step, 0, static_cast<int>(kQualities.size()) - 1);
  calm_s_ = room_s_ = given_up_at_ = first_second_ = 0.0;
  const bool changed = within != step_;
  step_ = within;
  return changed;
}

bool QualityGovernor::frame(double now_s, double busy_s) {
  if (mode_ != Mode::automatic) return false;
  if (window_begins_s_ < 0.0 || now_s < window_begins_s_ || now_s - window_begins_s_ > 3.0 * kWindowS) {
    pause();  // the first frame, or the first after a pause: what it cost belongs to no second
    window_begins_s_ = now_s;
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
  return second(share, length);
}

bool QualityGovernor::second(double share, double length_s) {
  see_what_was_saved(share);
  since_climb_s_ += length_s;
  since_fall_s_ += length_s;
  if (share > kBusyMost) {
    if (since_climb_s_ < kSoonS) doublings_ = std::min(doublings_ + 1, kMostDoublings);
    since_fall_s_ = 0.0;
    const bool changed = take(step_ + 1);
    if (changed) given_up_at_ = share;
    return changed;
  }
  if (since_fall_s_ > kForgivenS) {
    doublings_ = std::max(0, doublings_ - 1);
    since_fall_s_ = 0.0;
  }
  const double saves = saves_[static_cast<std::size_t>(step_)];
  const double before = share * (saves > 0.0 ? saves : kSavesUnseen);
  calm_s_ = before < kBusyAgain ? calm_s_ + length_s : 0.0;
  room_s_ = share * kSavesLeast < kBusyAgain ? room_s_ + length_s : 0.0;
  if (calm_s_ < std::ldexp(kCalmS, doublings_) && room_s_ < std::ldexp(kTryS, doublings_)) return false;
  if (!take(step_ - 1)) return false;
  since_climb_s_ = 0.0;
  return true;
}

/// A step that is given up in its turn met the same load as the one before; where it stays, the second after must tell
/// the same, or the load has ended meanwhile.
void QualityGovernor::see_what_was_saved(double share) {
  if (given_up_at_ <= 0.0) return;
  if (share <= kBusyMost && first_second_ <= 0.0) {
    first_second_ = share;
    return;
  }
  if (share > kBusyMost || std::abs(share - first_second_) < kAgree * first_second_)
    saves_[static_cast<std::size_t>(step_)] = std::clamp(given_up_at_ / share, kSavesLeast, kSavesMost);
  given_up_at_ = first_second_ = 0.0;
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

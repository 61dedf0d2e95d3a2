// Whether the computer keeps up with the hand.
#pragma once

namespace vallecula::gui {

/// Of forces that are late, or steps dropped, from which share on a hand notices (assumed).
constexpr double kNoticedShare = 0.01;

/// `late`: forces written more than 1 ms after they were due; `dropped`: ticks whose simulation step was not finished.
constexpr bool keeps_up(long long ticks, long long late, long long dropped) {
  const double noticed = kNoticedShare * static_cast<double>(ticks);
  return static_cast<double>(late) <= noticed && static_cast<double>(dropped) <= noticed;
}

/// The same while a trial runs, of its last two to four seconds.
class Pace {
 public:
  struct Counts {
    long long ticks = 0, late = 0, dropped = 0;
  };
  /// `now`: since the trial began. Of less than a second nothing bad is said.
  bool keeps_up(const Counts& now) {
    if (now.ticks < newer_.ticks) older_ = newer_ = {};  // begun anew
    if (now.ticks - newer_.ticks >= kSpanTicks) {
      older_ = newer_;
      newer_ = now;
    }
    const long long ticks = now.ticks - older_.ticks;
    return ticks < kLeastTicks || gui::keeps_up(ticks, now.late - older_.late, now.dropped - older_.dropped);
  }

 private:
  static constexpr long long kSpanTicks = 2000, kLeastTicks = 1000;
  Counts older_, newer_;
};

}  // namespace vallecula::gui

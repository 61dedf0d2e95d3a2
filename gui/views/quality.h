// How finely the views are drawn, so that a slow machine keeps its frame rate: the resolution inside the view goes
// first, then effects, then the frame rate.
#pragma once

#include <QString>
#include <array>

namespace vallecula::gui {

struct Quality {
  bool rim = true;          ///< the bright edge of what is wet
  bool shadows = true;      ///< of blade and tube on the tissue
  int coarser = 0;          ///< how many of the tongue's levels of refinement are left out
  double resolution = 1.0;  ///< pixels that are drawn along a side, as a share of the view's own
  bool operator==(const Quality& other) const {
    return rim == other.rim && shadows == other.shadows && coarser == other.coarser && resolution == other.resolution;
  }
};

/// In the order in which they are taken; the first is everything. What a view costs without a graphics card is by its
/// pixels: the effects together are a tenth of it, and without shadows depth is hard to judge. So they go last.
constexpr std::array<Quality, 7> kQualities{{{true, true, 0, 1.0},
                                             {true, true, 0, 0.85},
                                             {true, true, 0, 0.7},
                                             {true, true, 0, 0.6},
                                             {false, true, 0, 0.6},
                                             {false, false, 1, 0.6},
                                             {false, false, 1, 0.5}}};

class QualityGovernor {
 public:
  enum class Mode { automatic, high, low, held };
  /// Of the setting [look] quality: "high", "low"; anything else is automatic.
  static Mode mode_of(const QString& setting);

  /// high: always everything; low: always the least.
  void set_mode(Mode mode);
  Mode mode() const { return mode_; }
  /// Stays at this step whatever frames cost: for measuring one.
  void hold(int step);
  /// A frame of all views together, which ended at `now_s` and kept the window for `busy_s`. True when quality() is
  /// another from here on. The rule, in automatic: over the last second, above kBusyMost of the time a frame may take
  /// at 30 a second a step is given up; kCalmS in which the step before would keep the window for less than kBusyAgain
  /// of it, and that is taken back. What it would cost is told by what this very step saved on this machine when it was
  /// taken last, with whatever was on the screen then. A step that was taken back too early doubles the wait; what
  /// was seen wrongly, since a load ended in that very second, is mended by a try after a minute.
  bool frame(double now_s, double busy_s);
  int step() const { return step_; }
  bool least() const { return step_ + 1 == static_cast<int>(kQualities.size()); }
  const Quality& quality() const { return kQualities[static_cast<std::size_t>(step_)]; }
  /// What is left out, in words for the status line; empty where nothing is.
  QString reduced() const;

  static constexpr double kFrameS = 1.0 / 30.0, kBusyMost = 0.90, kBusyAgain = 0.85;
  static constexpr double kWindowS = 1.0, kCalmS = 3.0;

 private:
  bool take(int step);
  void pause();
  bool second(double share, double length_s);
  void see_what_was_saved(double share);
  Mode mode_ = Mode::automatic;
  int step_ = 0, frames_ = 0;
  double window_begins_s_ = -1.0, busy_s_ = 0.0, calm_s_ = 0.0, room_s_ = 0.0;
  std::array<double, kQualities.size()> saves_{};  ///< cost of the step before over that of this one; 0: not seen yet
  double given_up_at_ = 0.0;   ///< share of the step before, until it is seen what this one saves; 0: seen
  double first_second_ = 0.0;  ///< share of this one's first second; 0: not over
  double since_climb_s_ = 1e9, since_fall_s_ = 0.0;
  int doublings_ = 0;  ///< of kCalmS
};

}  // namespace vallecula::gui

// How the pictures of a running trial come to the screen.
#pragma once

#include <chrono>

#include "gui/session/picture_watch.h"

namespace vallecula::gui {

/// Times in s, of one clock that does not go back.
class PictureFlow {
 public:
  static constexpr double kCountedS = 1.0;  ///< what a rate is of
  /// Longer between two pictures, and they stand.
  static constexpr double kGapS = std::chrono::duration<double>(PictureWatch::kLongest).count();
  static constexpr double kFlowsS = 1.0;  ///< so long without such a gap, and so many pictures, and they flow again
  static constexpr int kFlowsAt = 5;

  void begin(double now_s);
  /// One came to the screen.
  void came(double now_s);
  /// Pictures a second, over the last kCountedS or what a longer wait made of it.
  double per_second() const { return per_second_; }
  bool flows(double now_s) const {
    return now_s - last_s_ <= kGapS && now_s - flows_since_s_ >= kFlowsS && since_gap_ >= kFlowsAt;
  }
  double last_gap_s() const { return last_gap_s_; }  ///< the last one above kGapS; 0: there was none

 private:
  double counted_from_s_ = 0.0, last_s_ = 0.0, flows_since_s_ = 0.0;
  double per_second_ = 0.0, last_gap_s_ = 0.0;
  int counted_ = 0, since_gap_ = 0;
  bool whole_ = false;  ///< a whole kCountedS was counted
};

}  // namespace vallecula::gui

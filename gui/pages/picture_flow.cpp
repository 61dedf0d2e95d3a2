#include "gui/pages/picture_flow.h"

namespace vallecula::gui {

void PictureFlow::begin(double now_s) {
  *this = PictureFlow();
  counted_from_s_ = last_s_ = flows_since_s_ = now_s;
}

void PictureFlow::came(double now_s) {
  if (now_s - last_s_ > kGapS) {
    last_gap_s_ = now_s - last_s_;
    flows_since_s_ = now_s;
    since_gap_ = 0;
  }
  last_s_ = now_s;
  ++since_gap_;
  ++counted_;
  const double counted_s = now_s - counted_from_s_;
  if (counted_s <= 0.0 || (whole_ && counted_s < kCountedS)) return;
  per_second_ = counted_ / counted_s;
  if (counted_s < kCountedS) return;
  whole_ = true;
  counted_ = 0;
  counted_from_s_ = now_s;
}

}  // namespace vallecula::gui

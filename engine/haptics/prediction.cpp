#include "engine/haptics/prediction.h"

#include <algorithm>

namespace vallecula::engine {

namespace {

constexpr double kTouch = 0.01;                        // N; less is no contact
constexpr double kSoftest = 1.0, kStiffest = 20000.0;  // N/m
constexpr double kFade = 0.95;                         // a step's weight in the next
constexpr double kLeastWay = 1e-6;                     // m; shorter ways say nothing of a stiffness

Vec6 vector_of(const Wrench& w) {
  Vec6 v;
  v << w.force, w.torque;
  return v;
}

}  // namespace

double ContactStiffness::feel(const Pose& tool, const Wrench& tissue) noexcept {
  const double size = tissue.force.norm();
  if (!(size > kTouch)) {
    felt_ = 0;
    work_ = way_ = 0.0;
    return 0.0;
  }
  const Vec6 direction = vector_of(tissue) / size;
  const int at = felt_ % kWindow;
  if (felt_ >= kWindow) {
    const double way = direction.dot(move_between(tools_[at], tool));
    work_ = kFade * work_ + (forces_[at].force.dot(direction.head<3>()) - size) * way;
    way_ = kFade * way_ + way * way;
  }
  tools_[at] = tool;
  forces_[at] = tissue;
  felt_ = felt_ + 1 < 2 * kWindow ? felt_ + 1 : kWindow;
  return std::clamp(work_ / (way_ + kLeastWay * kLeastWay), kSoftest, kStiffest);
}

void add_tissue(const Wrench& tissue, double stiffness_n_m, PushingSprings& springs) noexcept {
  const double size = tissue.force.norm();
  if (size > kTouch && stiffness_n_m > 0)
    springs.add(vector_of(tissue) / size, size / stiffness_n_m, stiffness_n_m, 0.0);
}

void advance(const ProxySettings& settings, Prediction prediction, const Pose& device, CouplingState& c) noexcept {
  if (prediction == Prediction::contact && !c.held) {
    follow_device(device, settings.step_s, c.hand);
    c.springs.follow(move_coupled(settings, c.hand, Wrench{}, Mat6::Zero(), c.springs, c.proxy));
    return;
  }
  if (prediction != Prediction::hold)
    c.proxy.pull.force += settings.stiffness_n_m * c.hand.scale * (device.position - c.hand.device.position);
  c.hand.device = device;
}

}  // namespace vallecula::engine

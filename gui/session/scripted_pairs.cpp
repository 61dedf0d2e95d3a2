#include "gui/session/scripted_pairs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/physiology/infant.h"
#include "engine/tube/intubation_record.h"
#include "engine/tube/rod.h"
#include "gui/session/operator_frame.h"
#include "gui/session/scripted_hands.h"

namespace vallecula::gui {

namespace {

using engine::AirwayPart;
using engine::AirwayRing;
using engine::Mat3;
using engine::Pose;
using engine::Quat;
using engine::Vec3;

// s; the blade's hand is as high as it lifts at kSeen, the tube's then sets out.
constexpr double kSeen = 10.0, kIntoMouth = 11.0, kBeforeInlet = 12.2, kAtInlet = 13.2;
constexpr double kStep = 0.1;          // s between keyframes
constexpr double kGulletDeep = 0.025;  // m beyond its mouth: the tip's last place (term)
constexpr double kGivenUp = 13.0;      // s: until then the view is looked at
constexpr double kRolled = 0.43;  // of the concave side to the right: from the corner of the mouth the way turns back
constexpr double kLook = 0.5;     // s before the tube is pushed on
constexpr double kPushSpeed = 0.008;  // m/s along the tube
// The tube's tip, m (term) past the cords, until where the stylet is in it: bent as it is it goes no deeper into a
// straight windpipe than its bend does.
constexpr double kStyletUntil = 0.020;
constexpr double kStyletTakes = 0.6;    // s
constexpr double kBladeOutAfter = 0.6;  // s that the tube is held before the blade goes
constexpr double kWithdrawal = 4.5;     // s that the blade takes (expert_laryngoscopy)
// s by mask where the heart begins slow: until it is above 100, and as long as one ventilates between attempts.
constexpr double kLeastVentilated = 30.0, kMostVentilated = 60.0;
constexpr double kHeartEnough = 100.0;  // 1/min
constexpr double kHeartHeld = 2.0;      // s that it is watched to stay above
constexpr double kBreathEvery = 1.5;    // s: 40 a minute, as a key that is held gives them
constexpr double kMaskAway = 1.0;       // s
constexpr double kBreaths = 12.2;       // s of breaths, 40 a minute: the detector needs up to 6
constexpr double kLarynxLifted = 1.5;   // mm term: the way of the larynx under the expert's lift

/// The tube as it hangs from the hand when nothing acts on it, in the grip's frame.
class RestingTube {
 public:
  RestingTube(const engine::TubeDesign& tube, const engine::Stylet* stylet)
      : rod_(engine::tube_rod(tube, stylet, engine::usual_grip_from_tip(tube))), state_(rod_, Pose{}) {}

  /// The grip with which the tip is at `tip`, the tube passes through `through` (or lies towards it), and its concave
  /// side is turned to `concave` as far as that leaves open.
  Pose grip(const Vec3& tip, const Vec3& through, const Vec3& concave) const {
    const double far = (through - tip).norm();
    std::size_t node = 1;
    while (node + 1 < state_.position.size() && (state_.position[node] - state_.position[0]).norm() < far) ++node;
    const Quat turn(frame(through - tip, concave) *
                    frame(state_.position[node] - state_.position[0], state_.rotation[0] * Vec3::UnitZ()).transpose());
    return {tip - turn * state_.position[0], turn};
  }

 private:
  static Mat3 frame(const Vec3& along, const Vec3& concave) {
    const Vec3 x = along.normalized(), z = (concave - concave.dot(x) * x).normalized();
    Mat3 axes;
    axes << x, z.cross(x), z;
    return axes;
  }
  engine::Rod rod_;
  engine::RodState state_;
};

/// Keyframes of the tube's grip, one after the other.
class TubeHand {
 public:
  void at(double time_s, const Pose& grip) {
    device::Keyframe k;
    k.time_s = time_s;
    for (int a = 0; a < 3; ++a) k.position_m[a] = grip.position[a];
    const Quat& q = grip.rotation;
    k.rotation_wxyz = {q.w(), q.x(), q.y(), q.z()};
    keys_.push_back(k);
    last_ = grip;
  }
  void rests(double time_s) { at(time_s, last_); }
  device::Trajectory trajectory() const { return device::Trajectory(keys_); }

 private:
  std::vector<device::Keyframe> keys_;
  Pose last_;
};

/// A way through rings, m, each moved aside by its share of the larynx' way.
class Way {
 public:
  Way(const std::vector<AirwayRing>& first, const std::vector<AirwayRing>& then, const Vec3& larynx_way) {
    double share = 0.0;
    for (const AirwayRing& r : first)
      if (r.part == AirwayPart::cords) share = r.larynx_share;
    for (const auto* rings : {&first, &then})
      for (const AirwayRing& r : *rings) {
        const Vec3 at = r.centre + (share > 0 ? r.larynx_share / share : 0.0) * larynx_way;
        from_start_.push_back(points_.empty() ? 0.0 : from_start_.back() + (at - points_.back()).norm());
        points_.push_back(at);
      }
  }
  double to_ring(std::size_t i) const { return from_start_[i]; }
  /// Straight on beyond its ends.
  Vec3 at(double s) const {
    std::size_t i = 1;
    while (i + 1 < points_.size() && from_start_[i] < s) ++i;
    const double share = (s - from_start_[i - 1]) / (from_start_[i] - from_start_[i - 1]);
    return points_[i - 1] + share * (points_[i] - points_[i - 1]);
  }

 private:
  std::vector<Vec3> points_;
  std::vector<double> from_start_;
};

/// Where the tip is to be and where the tube is to pass, m.
struct Aim {
  Vec3 tip, through;
};

class Planner {
 public:
  Planner(const pipeline::PatientPackage& package, const engine::IntubationDescription& d)
      : package_(package),
        intubation_(d),
        frame_(package),
        tube_(d.tube, nullptr),
        stiff_(d.tube, d.stylet ? &*d.stylet : nullptr),
        mouth_(frame_.at(52, 2, -8)) {
    wait_outside();
  }

  /// To a share of the way from the cords to the carina, and so far beyond.
  ScriptedPair intubate(double share, double beyond_m) {
    const engine::AirwayCourse& course = intubation_.course;
    const Way way(course.airway, course.bronchi[0], kLarynxLifted * 1e-3 * frame_.size * frame_.lift);
    std::size_t cords = 0;
    while (course.airway[cords].part != AirwayPart::cords) ++cords;
    const double to_cords = way.to_ring(cords), to_carina = way.to_ring(course.airway.size() - 1);
    go(kIntoMouth, at_lips());
    // From the right and from below: over the middle the tube would hide from the eye what it is to enter. The inlet is
    // narrow: 2 mm aside at it the tip of a 3.5 catches on the rim.
    const auto beside = [&](double sight, double lift, double left) -> Vec3 {
      return way.at(0) + 1e-3 * frame_.size * (sight * frame_.sight + lift * frame_.lift + left * frame_.left);
    };
    go(kBeforeInlet, {beside(8, -3.5, -4.5), mouth_});
    go(kAtInlet, {beside(0, -1.5, -1.25), mouth_});
    go(time_s_ + kLook, aim_);
    const double goal = to_cords + share * (to_carina - to_cords) + beyond_m;
    const double stiff = std::min(goal, to_cords + kStyletUntil * frame_.size);
    along(way, 0.0, stiff);
    draw_stylet();
    if (goal > stiff) along(way, stiff, goal);
    return confirmed();
  }

  ScriptedPair oesophagus() {
    const engine::AirwayCourse& course = intubation_.course;
    const Way way(course.oesophagus, {}, Vec3::Zero());
    go(kIntoMouth, at_lips());
    go(kBeforeInlet, {frame_.at(12, -10, -1), mouth_});
    go(kAtInlet, {frame_.at(2, -12, 0), mouth_});
    go(kAtInlet + kLook, {way.at(0), mouth_});
    along(way, 0.0, kGulletDeep * frame_.size);
    draw_stylet();
    return confirmed();
  }

  /// The view, and no more: until `until_s`.
  ScriptedPair look_only(double until_s) {
    hand_.rests(until_s + kWithdrawal);
    return {expert_laryngoscopy(package_, until_s), hand_.trajectory(), {}};
  }

 private:
  Aim at_lips() const { return {frame_.at(56, 2, -9), frame_.at(110, 10, -16)}; }
  Pose grip(const Aim& aim) const {
    return (drawn_ ? tube_ : stiff_).grip(aim.tip, aim.through, frame_.lift - kRolled * frame_.left);
  }

  void wait_outside() {
    aim_ = {frame_.at(95, 12, -16), frame_.at(160, 30, -26)};
    hand_.at(0.0, grip(aim_));
    hand_.rests(kSeen);
    time_s_ = kSeen;
  }

  /// The tip in a straight line to its next place: the grip, far off, goes along a curve.
  void go(double until_s, const Aim& to) {
    const int steps = std::max(1, static_cast<int>(std::lround((until_s - time_s_) / kStep)));
    for (int i = 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      hand_.at(time_s_ + share * (until_s - time_s_),
               grip({aim_.tip + share * (to.tip - aim_.tip), aim_.through + share * (to.through - aim_.through)}));
    }
    aim_ = to;
    time_s_ = until_s;
  }

  /// The tip from one place of a way to another.
  void along(const Way& way, double from, double to) {
    const int steps = std::max(1, static_cast<int>(std::lround((to - from) / 0.001)));
    for (int i = 1; i <= steps; ++i)
      go(time_s_ + (to - from) / steps / kPushSpeed, {way.at(from + (to - from) * i / steps), mouth_});
  }

  void draw_stylet() {
    if (intubation_.stylet) actions_.push_back({time_s_, engine::kActionStyletOut});
    drawn_ = true;
    if (intubation_.stylet) time_s_ += kStyletTakes;
    hand_.at(time_s_ += kStep, grip(aim_));
  }

  /// The tube held where it is; the blade out, then breaths.
  ScriptedPair confirmed() {
    const double hold = time_s_ + kBladeOutAfter, out = hold + kWithdrawal + 0.5, end = out + kBreaths;
    hand_.rests(end);
    actions_.push_back({out, engine::kActionBreath});
    return {lasting(expert_laryngoscopy(package_, hold), end), hand_.trajectory(),
            device::ActionPlan(std::move(actions_))};
  }

  /// The hand stays where it ends.
  static device::Trajectory lasting(const device::Trajectory& hand, double until_s) {
    std::vector<device::Keyframe> keys = hand.keyframes();
    keys.push_back(keys.back());
    keys.back().time_s = until_s;
    return device::Trajectory(std::move(keys));
  }

  const pipeline::PatientPackage& package_;
  const engine::IntubationDescription& intubation_;
  const OperatorFrame frame_;
  const RestingTube tube_, stiff_;
  const Vec3 mouth_;
  TubeHand hand_;
  std::vector<device::TimedActions> actions_;
  Aim aim_;
  double time_s_ = 0.0;
  bool drawn_ = false;  ///< the stylet
};

device::Trajectory later(const device::Trajectory& hand, double by_s) {
  std::vector<device::Keyframe> keys = hand.keyframes();
  for (device::Keyframe& k : keys) k.time_s += by_s;
  return device::Trajectory(std::move(keys));
}

/// Seconds of breaths by mask until this infant's heart is above 100: as the scene will have it, for the infant is
/// drawn from its seed, and its cords let all of a breath through.
double until_heart_enough_s(const engine::IntubationDescription& intubation) {
  constexpr double kDt = 0.01;
  const engine::Infant infant = engine::build_infant(intubation.infant);
  engine::InfantState state = engine::start(infant);
  double held_s = 0.0, until_breath_s = 0.0, now_s = 0.0;
  for (; now_s < kMostVentilated && (now_s < kLeastVentilated || held_s < kHeartHeld); now_s += kDt) {
    engine::InfantInput in;
    in.breathing = intubation.breathes;
    if (until_breath_s < kDt / 2) {
      in.breath = engine::Breath::mask;
      until_breath_s += kBreathEvery;
    }
    until_breath_s -= kDt;
    held_s = engine::step(infant, state, in, kDt).heart_per_min > kHeartEnough ? held_s + kDt : 0.0;
  }
  return now_s;
}

/// Breaths by mask for so long first, then the pair.
ScriptedPair ventilated_first(const ScriptedPair& pair, double for_s) {
  const double begin_s = for_s + kMaskAway;
  std::vector<device::TimedActions> actions{{0.0, engine::kActionBreath}, {for_s, 0}};
  for (device::TimedActions change : pair.actions.changes()) {
    change.time_s += begin_s;
    actions.push_back(change);
  }
  return {later(pair.blade, begin_s), later(pair.tube, begin_s), device::ActionPlan(std::move(actions))};
}

ScriptedPair planned(const std::string& kind, const pipeline::PatientPackage& package,
                     const curricula::Scenario& scenario, const engine::IntubationDescription& intubation) {
  Planner planner(package, intubation);
  if (kind == "expert") return planner.intubate(0.6, 0.0);
  if (kind == "shallow") return planner.intubate(0.3, 0.0);
  if (kind == "deep") return planner.intubate(0.95, 0.0);
  if (kind == "mainstem") return planner.intubate(1.0, 0.018);
  if (kind == "oesophagus") return planner.oesophagus();
  if (kind == "abandon") return planner.look_only(kGivenUp);
  if (kind == "late") return planner.look_only(std::max(kGivenUp, scenario.max_attempt_s));
  throw std::runtime_error("scripted pair '" + kind + "' is not known");
}

}  // namespace

ScriptedPair scripted_pair(const std::string& kind, const pipeline::PatientPackage& package,
                           const curricula::Scenario& scenario, const engine::IntubationDescription& intubation) {
  ScriptedPair pair = planned(kind, package, scenario, intubation);
  const bool slow_heart = intubation.infant.course == engine::Course::delivery_room;
  return slow_heart ? ventilated_first(pair, until_heart_enough_s(intubation)) : pair;
}

}  // namespace vallecula::gui

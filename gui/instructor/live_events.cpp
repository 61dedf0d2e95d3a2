#include "gui/instructor/live_events.h"

#include <algorithm>

#include "gui/report/markdown.h"
#include "gui/session/trial_clock.h"
#include "gui/session/words_from_below.h"
#include "gui/views/monitor_panel.h"

namespace vallecula::gui {
namespace {

/// The blade is out once its tip has been before the gums this long: at their edge it does not flutter.
constexpr double kOutS = 1.0;
/// A force is back within its target below this share of it.
constexpr double kBackWithin = 0.9;

double load(const engine::Snapshot& snapshot, engine::Structure structure) {
  return snapshot.loads[static_cast<std::size_t>(structure)].force_n.norm();
}

bool in_airway(engine::TipPlace place) {
  return place == engine::TipPlace::trachea || place == engine::TipPlace::main_bronchus;
}

}  // namespace

void LiveEvents::begin(const curricula::Scenario& scenario, const std::optional<curricula::Mouth>& mouth) {
  *this = LiveEvents();
  mouth_ = mouth;
  sight_percent_ = scenario.sight_percent;
  tongue_target_n_ = scenario.targets.tongue_force_n;
  gum_target_n_ = scenario.targets.gum_force_n;
}

std::vector<LiveEvent> LiveEvents::watch(const engine::Snapshot& snapshot, const QString& pause, double paused_s,
                                         DualTask* task) {
  told_.clear();
  now_s_ = std::max(now_s_, trial_clock_s(snapshot) - paused_s);
  log_s_ = std::max(log_s_, trial_clock_s(snapshot));
  if (pause_.isEmpty() && !pause.isEmpty()) pause_began_s_ = log_s_;
  if (pause != pause_) tell(pause.isEmpty() ? tr("It goes on") : tr("Paused: %1").arg(in_words(pause.toStdString())));
  pause_ = pause;
  watch_blade(snapshot);
  watch_force(tr("tongue"), load(snapshot, engine::Structure::tongue), tongue_target_n_, over_tongue_);
  watch_force(tr("gum"), load(snapshot, engine::Structure::gum), gum_target_n_, over_gum_);
  if (snapshot.has_intubation) watch_tube(snapshot.intubation);
  if (task != nullptr) watch_beside(*task);
  return std::move(told_);
}

void LiveEvents::watch_blade(const engine::Snapshot& snapshot) {
  const engine::Vec3& tip = snapshot.proxy_pose.position;
  const bool holds = mouth_ && mouth_->holds({tip.x(), tip.y(), tip.z()});
  if (holds) last_in_s_ = now_s_;
  if (holds && !in_) tell(tr("Blade in the mouth"));
  if (in_ && !holds && now_s_ - last_in_s_ >= kOutS) tell(tr("Blade out"));
  in_ = holds || (in_ && now_s_ - last_in_s_ < kOutS);
  const double percent = 100.0 * snapshot.glottis_visible;
  if (!seen_ && percent >= sight_percent_) {
    seen_ = true;
    tell(tr("Glottis in sight, %1 %").arg(percent, 0, 'f', 0));
  }
}

void LiveEvents::watch_force(const QString& what, double force_n, double target_n, bool& over) {
  if (!over && force_n > target_n)
    tell(tr("Over the target on the %1: %2 N of %3 N").arg(what).arg(decimal(force_n, 1)).arg(decimal(target_n, 1)));
  over = force_n > (over ? kBackWithin : 1.0) * target_n;
}

void LiveEvents::watch_tube(const engine::IntubationRecord& now) {
  using engine::TipPlace;
  if (now.in_hand != engine::InHand::catheter) {
    if (in_airway(now.place) && !in_airway(place_)) tell(tr("Tube past the cords"));
    if (now.place == TipPlace::main_bronchus && place_ != TipPlace::main_bronchus) tell(tr("Tube in a main bronchus"));
    if (now.place == TipPlace::oesophagus && place_ != TipPlace::oesophagus) tell(tr("Tube in the oesophagus"));
    if (now.place == TipPlace::outside && (in_airway(place_) || place_ == TipPlace::oesophagus)) tell(tr("Tube out"));
    place_ = now.place;
  }
  if (now.detector_yellow && !yellow_) tell(tr("CO2 detector yellow"));
  if (now.spasm != spasm_) tell(now.spasm ? tr("Laryngospasm begins") : tr("Laryngospasm over"));
  yellow_ = now.detector_yellow;
  spasm_ = now.spasm;
  const QStringList alarms = alarms_of(now);
  for (const QString& alarm : alarms)
    if (!alarms_.contains(alarm)) tell(tr("Alarm: %1").arg(alarm));
  alarms_ = alarms;
}

void LiveEvents::watch_beside(DualTask& task) {
  std::vector<int> open;
  for (const DualTask::Open& one : task.open()) open.push_back(one.distraction);
  for (const int one : open)
    if (std::find(open_.begin(), open_.end(), one) == open_.end())
      tell(tr("Beside the hands: %1").arg(plain_of(task.distractions()[static_cast<std::size_t>(one - 1)].text)));
  open_ = open;
}

}  // namespace vallecula::gui

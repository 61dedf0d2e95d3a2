#include "gui/views/trial_readings.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "curricula/score/intubation_score.h"
#include "gui/session/trial_clock.h"
#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

/// How much of the glottis is seen now, the best so far, and from where on it counts.
class SightBar : public QWidget {
 public:
  explicit SightBar(QWidget* parent) : QWidget(parent) { setMinimumHeight(16); }
  void show_percent(double now, double best, double counts_from) {
    now_ = now;
    best_ = best;
    from_ = counts_from;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(0.5, 2.5, width() - 1.0, height() - 5.0);
    const auto at = [&](double percent) {
      return track.left() + track.width() * std::clamp(percent / 100.0, 0.0, 1.0);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::track());
    painter.drawRoundedRect(track, 4, 4);
    painter.setBrush(theme::accent());
    if (now_ > 0.0)
      painter.drawRoundedRect(QRectF(track.left(), track.top(), at(now_) - track.left(), track.height()), 3, 3);
    painter.setPen(QPen(theme::text(), 1.5));
    if (best_ > 0.0) painter.drawLine(QPointF(at(best_), track.top()), QPointF(at(best_), track.bottom()));
    painter.setPen(QPen(theme::target(), 2.0));
    painter.drawLine(QPointF(at(from_), track.top() - 2.0), QPointF(at(from_), track.bottom() + 2.0));
  }

 private:
  double now_ = 0.0, best_ = 0.0, from_ = 25.0;
};

StateWords words_for(engine::HapticState state, bool device_invalid) {
  switch (state) {
    case engine::HapticState::tracking:
      return {TrialReadings::tr("following your hand"), ""};
    case engine::HapticState::limited:
      return {TrialReadings::tr("at the device limit"),
              TrialReadings::tr("Device limit reached: the device cannot push back harder, so the blade stays where it "
                                "is. The grey blade shows your hand.")};
    case engine::HapticState::lost:
      return {device_invalid ? TrialReadings::tr("paused") : TrialReadings::tr("lost"),
              device_invalid
                  ? TrialReadings::tr("The device stopped answering. No force is shown until it is back.")
                  : TrialReadings::tr("The device stayed over its limit too long and let go. Bring the grey blade back "
                                      "to the steel one to take hold again.")};
    case engine::HapticState::recovering:
      return {TrialReadings::tr("taking hold again"),
              TrialReadings::tr("Taking hold again: the force returns gently.")};
  }
  return {};
}

QString banner_for(const engine::Snapshot& snapshot, const QString& fault, const QString& pause) {
  QStringList sentences;
  if (!pause.isEmpty())
    sentences << TrialReadings::tr("Paused. %1").arg(pause);
  else
    sentences << words_for(snapshot.state, (snapshot.faults & engine::kFaultDeviceInvalid) != 0).banner;
  if (!fault.isEmpty())
    sentences << TrialReadings::tr("A fault: %1. Reset to begin anew; what led to it is kept.").arg(fault);
  sentences.removeAll("");
  return sentences.join(" ");
}

QString tube_words(const engine::IntubationRecord& now, const std::optional<curricula::Mouth>& mouth,
                   const std::optional<double>& rule_m) {
  const bool catheter = now.in_hand == engine::InHand::catheter;
  if (now.at_mouth_m > 0.0) {
    const QString depth_cm = decimal(100.0 * now.at_mouth_m, 1);
    if (rule_m && !catheter)
      return TrialReadings::tr("%1 cm at the lips (rule: %2)").arg(depth_cm, decimal(100.0 * *rule_m, 1));
    return (catheter ? TrialReadings::tr("catheter %1 cm at the lips") : TrialReadings::tr("%1 cm at the lips"))
        .arg(depth_cm);
  }
  if (!mouth) return catheter ? TrialReadings::tr("catheter not in the mouth") : TrialReadings::tr("not in the mouth");
  double behind_m = 0.0, along_m = 0.0, away_m2 = 0.0;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double way_m = now.tip_m[a] - mouth->gum_middle_m[axis];
    behind_m += mouth->inward[axis] * way_m;
    along_m += mouth->axis[axis] * way_m;
    away_m2 += way_m * way_m;
  }
  const double aside_m = std::sqrt(std::max(0.0, away_m2 - along_m * along_m));
  // Farther to the side of its axis, which is about the operator's line of sight, than before it and than it is wide.
  if (behind_m > 0.0 || aside_m > std::max(mouth->radius_m, -along_m))
    return catheter ? TrialReadings::tr("catheter beside the mouth") : TrialReadings::tr("beside the mouth");
  return (catheter ? TrialReadings::tr("catheter %1 cm before the gums") : TrialReadings::tr("%1 cm before the gums"))
      .arg(decimal(-100.0 * behind_m, 1));
}

TrialReadings::TrialReadings(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setVerticalSpacing(4);
  grid->setHorizontalSpacing(24);
  const auto caption = [&](const QString& text, int row, int column) {
    auto* label = new QLabel(text, this);
    label->setObjectName("faint");
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    grid->addWidget(label, row, column);
    return label;
  };
  const auto figure = [&](int row, int column) {
    auto* label = new QLabel(this);
    label->setProperty("role", "figure");
    grid->addWidget(label, row, column);
    return label;
  };
  clock_caption_ = caption(tr("Attempt"), 0, 0);
  seen_caption_ = caption(tr("Glottis visible"), 0, 1);
  clock_ = figure(1, 0);
  seen_ = figure(1, 1);
  limit_ = new QLabel(this);
  limit_->setObjectName("faint");
  grid->addWidget(limit_, 2, 0);
  sight_ = new SightBar(this);
  grid->addWidget(sight_, 2, 1);
  tube_caption_ = caption(tr("Tube"), 3, 0);
  tube_ = new QLabel(this);
  grid->addWidget(tube_, 3, 1);
  caption(tr("Device"), 4, 0);
  state_ = new QLabel(this);
  grid->addWidget(state_, 4, 1);
  caption(tr("Computer"), 5, 0);
  computer_ = new QLabel(this);
  computer_->setObjectName("computer");
  grid->addWidget(computer_, 5, 1);
  caption(tr("Picture"), 6, 0);
  drawing_ = new QLabel(this);
  grid->addWidget(drawing_, 6, 1);
  for (QLabel* figure : {state_, computer_, drawing_, tube_}) {
    figure->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a narrow panel is not widened by them
    figure->setWordWrap(true);                                            // two lines where one is too short
    figure->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnMinimumWidth(0, 100);
  show_tube(false);
  clear();
}

void TrialReadings::show_tube(bool shown) {
  tube_->setVisible(shown);
  tube_caption_->setVisible(shown);
}

void TrialReadings::set_scenario(const curricula::Scenario& scenario, const std::optional<curricula::Mouth>& mouth) {
  mouth_ = mouth;
  sight_percent_ = scenario.sight_percent;
  attempt_limit_s_ = scenario.pass.attempt_time_s;
  // A help: an assessment has none.
  lips_rule_m_ = scenario.intubation && scenario.attempt.mode != curricula::Mode::assessment
                     ? std::optional<double>(curricula::lips_rule_m(scenario.manikin.weight_kg))
                     : std::nullopt;
  QString of_tube = tr(
      "In the mouth: the mark at the lips (cm), and how hard the tube pushes back on the hand (N). Before it: how far "
      "the tip is from the gums; to one eye a tube before the mouth looks like one in it.");
  if (lips_rule_m_)
    of_tube += '\n' + tr("Rule: the scenario's weight in kg (%1) and 6 cm at the upper lip. A help that hits about "
                         "half of all infants; "
                         "judged is where the tip lies.")
                          .arg(decimal(scenario.manikin.weight_kg, 1));
  tube_->setToolTip(of_tube);
  set_of_expert(false);
  const QString why = mouth ? QString()
                            : tr("Where this patient's mouth begins is not known: the clock counts from Start, and the "
                                 "result has no attempt's time.");
  for (QLabel* label : {clock_caption_, clock_, limit_}) label->setToolTip(why);
  clear();
}

void TrialReadings::clear() {
  best_percent_ = 0.0;
  attempt_start_s_ = mouth_ ? -1.0 : 0.0;
  attempt_s_ = last_in_s_ = 0.0;
  if (of_expert_) set_of_expert(false);
  show_clock();
  seen_->setText("0 %");
  sight_->show_percent(0.0, 0.0, sight_percent_);
  state_->setText(tr("ready"));
  state_->setStyleSheet(QString());
  tube_->setText(tr("ready"));
  pace_ = {};
  computer_->setText(tr("waits"));
  computer_->setStyleSheet(QString());
  computer_->setToolTip(QString());
  show_drawing(0.0, {});
}

void TrialReadings::set_of_expert(bool of_expert) {
  of_expert_ = of_expert;
  clock_caption_->setText(of_expert ? tr("Your attempt") : mouth_ ? tr("Attempt") : tr("From Start"));
  limit_->setText(of_expert ? tr("waits")
                  : mouth_  ? tr("at most %1 s").arg(attempt_limit_s_, 0, 'f', 0)
                            : tr("no attempt: mouth not known"));
  seen_caption_->setText(of_expert ? tr("Glottis visible: expert") : tr("Glottis visible"));
  if (!of_expert) drawing_->setStyleSheet(QString());
}

void TrialReadings::show_clock() {
  clock_->setText(QString("%1 s").arg(decimal(attempt_s_, 1)));
  const bool over = mouth_ && attempt_s_ > attempt_limit_s_;
  clock_->setStyleSheet(of_expert_ ? QString("color: %1").arg(theme::faint().name())
                        : over     ? QString("color: %1").arg(theme::over().name())
                                   : QString());
}

void TrialReadings::show_tube_of(const engine::Snapshot& snapshot) {
  if (!snapshot.has_intubation) return;
  const auto& now = snapshot.intubation;
  QString words = tube_words(now, mouth_, lips_rule_m_);
  if (force_shown_ && now.at_mouth_m > 0.0)
    words = tr("%1, %2 N on the hand").arg(words).arg(decimal(now.model_force_n.norm(), 1));
  tube_->setText(of_expert_ ? tr("expert: %1").arg(words) : words);
}

void TrialReadings::show_expert(const engine::Snapshot& snapshot) {
  if (!of_expert_) {
    set_of_expert(true);
    show_clock();
    for (QLabel* figure : {state_, computer_, drawing_}) {
      figure->setText(tr("waits"));
      figure->setStyleSheet(QString("color: %1").arg(theme::faint().name()));
      figure->setToolTip(QString());
    }
  }
  const double percent = 100.0 * snapshot.glottis_visible;
  seen_->setText(QString("%1 %").arg(percent, 0, 'f', 0));
  sight_->show_percent(percent, 0.0, sight_percent_);
  show_tube_of(snapshot);
}

void TrialReadings::go_on_from(const TrialReadings& other) {
  best_percent_ = other.best_percent_;
  attempt_start_s_ = other.attempt_start_s_;
  attempt_s_ = other.attempt_s_;
  last_in_s_ = other.last_in_s_;
}

void TrialReadings::show_snapshot(const engine::Snapshot& snapshot, double paused_s) {
  if (of_expert_) set_of_expert(false);
  const double percent = 100.0 * snapshot.glottis_visible;
  best_percent_ = std::max(best_percent_, percent);
  const engine::Vec3& tip = snapshot.proxy_pose.position;
  const double now_s = trial_clock_s(snapshot) - paused_s;
  if (!led_ && (!mouth_ || mouth_->holds({tip.x(), tip.y(), tip.z()}))) {
    const bool in_anew = snapshot.has_intubation && mouth_ && now_s - last_in_s_ > curricula::kOutForAnEntryS;
    if (attempt_start_s_ < 0.0 || in_anew) {
      attempt_start_s_ = now_s;
      attempt_s_ = 0.0;
    }
    // The pause is told a little newer than the snapshot: at its beginning that must not turn the clock back.
    attempt_s_ = std::max(attempt_s_, now_s - attempt_start_s_);
    last_in_s_ = std::max(last_in_s_, now_s);
  }
  show_clock();
  seen_->setText(QString("%1 %").arg(percent, 0, 'f', 0));
  sight_->show_percent(percent, best_percent_, sight_percent_);
  show_tube_of(snapshot);
  const bool invalid = (snapshot.faults & engine::kFaultDeviceInvalid) != 0;
  state_->setText(words_for(snapshot.state, invalid).name);
  state_->setStyleSheet(
      snapshot.state == engine::HapticState::tracking ? QString() : QString("color: %1").arg(theme::device().name()));
  const bool fast = pace_.keeps_up({snapshot.ticks, snapshot.deadline_misses, snapshot.overruns});
  computer_->setText(fast ? tr("keeps up with the hand") : tr("too slow: forces come late"));
  computer_->setStyleSheet(fast ? QString() : QString("color: %1").arg(theme::device().name()));
  const QString rate =
      snapshot.loop_rate_hz > 0.0 ? tr("%1 Hz").arg(snapshot.loop_rate_hz, 0, 'f', 0) : tr("measuring");
  computer_->setToolTip(
      tr("The force loop runs at %1. Of %2 forces %3 were written more than 1 ms after they were due, "
         "and for %4 the tissue's step was not finished in time.")
          .arg(rate)
          .arg(snapshot.ticks)
          .arg(snapshot.deadline_misses)
          .arg(snapshot.overruns));
}

void TrialReadings::show_drawing(double frames_per_second, const QString& reduced) {
  const QString rate = frames_per_second > 0.0 ? tr("%1 frames/s").arg(frames_per_second, 0, 'f', 0) : tr("standing");
  drawing_->setText(reduced.isEmpty() ? rate : tr("%1, less detail").arg(rate));
  const QString what =
      tr("Frames drawn a second, and what was left out of the picture so that hand and picture keep their time.");
  drawing_->setToolTip(reduced.isEmpty() ? what : what + "\n" + reduced);
  drawing_->setAccessibleDescription(drawing_->toolTip());
}

}  // namespace vallecula::gui

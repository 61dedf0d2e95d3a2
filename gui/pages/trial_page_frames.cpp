// What the trial page shows and says while a trial is open, frame by frame.
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QWindow>

#include "device/drivers/mouse_device.h"
#include "gui/pages/blade_control.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/help_panel.h"
#include "gui/pages/hints.h"
#include "gui/pages/parts_label.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/device_choice.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"
#include "gui/views/operator_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"

namespace vallecula::gui {
namespace {

constexpr int kRestMs = 500;
constexpr double kWaitToldS = 8.0;
constexpr double kLeveringToldS = 2.0;  // after it has ended: long enough to be read

/// For a device in the hand that is no mouse.
QString device_help(const device::DeviceInfo& info) {
  const QString help = TrialPage::tr("Enter starts the trial and takes hold again after a pause, Esc ends it.");
  const int clutch = clutch_button_in_hand(info);
  return clutch == 0
             ? help
             : help + " " +
                   TrialPage::tr("Button %1 of the device, held, frees your hand: the blade stays.").arg(clutch);
}

}  // namespace

void TrialPage::show_helps() {
  const auto& assistance = session_->scenario().assistance;
  if (assistance.ghost_path)
    operator_view_->show_ghost_path(session_->scene().tool.surface,
                                    scripted_hand("expert", session_->package(), session_->scenario()));
  if (assistance.glottis_highlight) operator_view_->highlight_glottis();
  since_shown_.start();
}

void TrialPage::show_help() {
  if (!session_) return;
  const device::DeviceInfo info = session_->device().info();
  const QString help = control_->steering()      ? control_->help()
                       : info.kind == "scripted" ? tr("Scripted hands are at work. Esc ends the trial.")
                       : info.kind == "recorded" ? tr("The hands of a recorded trial are at work. Esc ends the trial.")
                                                 : device_help(info);
  help_->set_parts(tr("%1   |   F1: all keys").arg(help).split(QRegularExpression("\\s+\\|\\s+")));
}

void TrialPage::steer() {
  auto* mouse = dynamic_cast<device::MouseDevice*>(&session_->device());
  if (mouse == nullptr) mouse = dynamic_cast<device::MouseDevice*>(session_->second_device());
  control_->steer(mouse);
}

void TrialPage::show_steered() {
  shown_in_hand_ = session_->takes_turns() ? session_->in_hand() : Tool::blade;
  const bool tube = shown_in_hand_ == Tool::tube;
  // Beside a device for the blade the mouse has the tube.
  const bool mouse_has_tube = dynamic_cast<device::MouseDevice*>(session_->second_device()) != nullptr;
  control_->set_tool(mouse_has_tube ? Tool::tube : shown_in_hand_);
  steered_->setText(tube ? tr("You hold: right hand, TUBE. The blade stays.")
                         : tr("You hold: left hand, BLADE. The tube stays."));
  QColor behind = theme::panel();
  behind.setAlpha(215);  // it lies over the picture
  steered_->setStyleSheet(
      QString("background: rgba(%2, %3, %4, %5); color: %1; border: 2px solid %1; border-radius: 5px; "
              "font-weight: bold; margin: 6px;")
          .arg(theme::device().name())
          .arg(behind.red())
          .arg(behind.green())
          .arg(behind.blue())
          .arg(behind.alpha()));
  show_help();
}

double TrialPage::run_s() const {
  return since_start_.isValid() ? 1e-3 * static_cast<double>(since_start_.elapsed()) : 0.0;
}

double TrialPage::frames_per_second() const { return run_s() > 0.0 ? frames_ / run_s() : 0.0; }

void TrialPage::picture_came() {
  if (!session_ || !running_) return;
  flow_.came(run_s());
  session_->picture_shown();
}

/// A window that is put away draws none. In practice that holds the trial; an assessment is not held by whoever is
/// assessed, only by a picture that stands by itself.
void TrialPage::watch_window() {
  const QWindow* shown = window()->windowHandle();
  if (shown != nullptr && shown->isExposed() && isVisible()) return;
  put_away_ = true;
  if (assessed()) session_->picture_shown();
}

/// A trial that waits for its picture is let go once pictures flow again; the hand takes hold as after any pause.
void TrialPage::let_go_of_what_is_seen_again() {
  const bool waits = session_->frozen_by(Holder::picture);
  if (waits) {
    control_->release_all();  // what was held when the picture stopped may have been let go of unseen
    hands_->release_all();
    seen_again_s_ = run_s();
  } else if (seen_again_s_ < 0.0) {
    put_away_ = false;
  }
  if (!waits || !flow_.flows(run_s())) return;
  hand_to_blade();
  session_->freeze(Holder::picture, false);
}

/// Told for a while after the hand has hold of it again.
QString TrialPage::waited_words() {
  if (seen_again_s_ < 0.0) return {};
  if (!session_->pause().empty()) seen_again_s_ = run_s();
  if (run_s() - seen_again_s_ > kWaitToldS) {
    seen_again_s_ = -1.0;
    return {};
  }
  const QString gap_s = QString::number(flow_.last_gap_s(), 'f', 0);
  return put_away_ ? tr("The trial waited for %1 s while its window was not to be seen.").arg(gap_s)
                   : tr("For %1 s no picture came to the screen; the trial waited. If it happens again, close other "
                        "programs.")
                         .arg(gap_s);
}

void TrialPage::draw_frame() {
  if (!session_) return;
  const double seconds = since_frame_.isValid() ? 1e-3 * static_cast<double>(since_frame_.restart()) : 0.0;
  if (!since_frame_.isValid()) since_frame_.start();
  operator_view_->set_ghost_time(1e-3 * static_cast<double>(since_shown_.elapsed()));
  try {
    if (!running_) return draw_at_rest();
    if (held_by_instructor() == end_->isEnabled()) {
      show_ways_out();
      if (!held_by_instructor()) hand_to_blade();  // before a hand that holds still takes hold by itself
    }
    watch_window();
    let_go_of_what_is_seen_again();
    if (expert_wanted_) {
      draw_expert();
      emit waited();
    } else {
      control_->advance(seconds > PictureFlow::kGapS ? 0.0 : seconds);  // nobody saw where a held key led
      const engine::Snapshot& snapshot = session_->latest();
      control_->feel(snapshot.model_force_n.norm(), session_->scene().haptics.device_limit_n);
      show_running(snapshot);
      ++frames_;
      emit frame(snapshot);
    }
    if (session_ && session_->finished()) end("finished");
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_trial();
    emit failed(message);
  }
}

/// Before the start nothing moves but the helps and the eye on its way: the rest is drawn now and then, for what was
/// switched on or sized anew meanwhile.
void TrialPage::draw_at_rest() {
  const engine::Snapshot& start = session_->at_start();
  const bool due = !since_rest_.isValid() || since_rest_.elapsed() >= kRestMs;
  if (!due && !operator_view_->moves()) return;
  operator_view_->update_from(start);
  operator_view_->draw();
  if (!due) return;
  since_rest_.start();
  panels_->show_pictures(start, session_->scenario().sight_percent);
}

void TrialPage::show_running(const engine::Snapshot& snapshot) {
  operator_view_->update_from(snapshot);
  operator_view_->draw();
  panels_->readings_panel().set_led(session_->led_in());
  panels_->show_snapshot(snapshot, session_->scenario().sight_percent, session_->paused_s(), session_->peaks());
  panels_->readings_panel().show_drawing(flow_.per_second(), GlView::governor().reduced());
  hands_->show_snapshot(snapshot);
  helps_->refresh();
  const QString pause =
      session_->starting() ? tr("The trial begins as soon as its log is on the disk.") : in_words(session_->pause());
  const QString refused = end_refused_ ? " " + tr("Until then it is not ended here: ask your instructor.") : QString();
  sound_->hear(snapshot, !pause.isEmpty());
  if (session_->takes_turns() && session_->in_hand() != shown_in_hand_) show_steered();
  show_words(snapshot, pause.isEmpty() ? QString() : pause + refused);
}

/// The infant's need comes before what the device wants, a fault and a pause before both: in those nothing goes on.
void TrialPage::show_words(const engine::Snapshot& snapshot, const QString& pause) {
  const QString fault = in_words(session_->fault()), waited = waited_words();
  const QString alert = banner_for(snapshot, fault, pause);
  const curricula::Scenario& scenario = session_->scenario();
  const bool assisted = curricula::rules_of(scenario.attempt.mode).assistance;
  const bool hinted = snapshot.has_intubation && assisted;
  if (session_->led_in() && pause.isEmpty())
    return show_banner({tr("The blade is being led to the vallecula; then it is yours."), true});
  if (hinted && pause.isEmpty() && fault.isEmpty()) {
    const QString need = need_of(snapshot, operator_view_->blade_in());
    if (!need.isEmpty()) return show_banner(need_before(snapshot, need, alert));
  }
  if (!alert.isEmpty()) return show_banner({alert, true});
  const double gum_n = snapshot.loads[static_cast<std::size_t>(engine::Structure::gum)].force_n.norm();
  if (const QString levers = levering_words(gum_n, scenario.targets.gum_force_n); !levers.isEmpty()) {
    levers_ = levers;
    levers_until_s_ = run_s() + kLeveringToldS;
  }
  if (assisted && run_s() < levers_until_s_) return show_banner({levers_, true});
  if (!waited.isEmpty() || !hinted) return show_banner({waited});
  show_banner({hint_for(snapshot, scenario.sight_percent, operator_view_->blade_in(),
                        key_to_the_tube(session_->takes_turns(), session_->in_hand()))});
}

void TrialPage::show_banner(const Banner& banner) {
  const QString style =
      banner.loud ? QString("background: %1; color: %2; padding: 6px 10px; border-radius: 5px; font-weight: bold;")
                        .arg(theme::device().name(), theme::ground().name())
                  : QString("padding: 6px 10px; font-size: %1pt;").arg(theme::points(11.0));
  if (banner_->styleSheet() != style) banner_->setStyleSheet(style);
  if (banner_->text() != banner.words) banner_->setText(banner.words);
}

bool TrialPage::held_by_instructor() const { return session_ && running_ && session_->frozen_by(Holder::instructor); }

void TrialPage::show_ways_out() {
  const bool held = held_by_instructor();
  if (!held) end_refused_ = false;
  const QString why = tr("An instructor holds the trial: it is ended once they let it go on");
  end_->setEnabled(running_ && !held);
  end_->setToolTip(held ? why : tr("Ends the trial and scores it (Esc)"));
  leave_->setEnabled(!ending_ && !held && !(running_ && assessed()));
  leave_->setToolTip(held ? why : tr("Back to where this trial was chosen (Esc, before the start)"));
}

void TrialPage::show_buttons() {
  start_->setEnabled(session_ != nullptr && !running_ && !ending_);
  reset_->setEnabled(running_ && !assessed());
  // What was begun as an assessment counts: it is neither begun anew nor thrown away.
  reset_->setVisible(!assessed());
  hands_->set_running(running_);
  show_ways_out();
  using Zoom = OperatorView::Zoom;
  zoom_->setText(operator_view_->zoom() == Zoom::automatic ? tr("View: auto")
                 : operator_view_->zoom() == Zoom::face    ? tr("View: face")
                                                           : tr("View: mouth"));
  offer_helps();
}

}  // namespace vallecula::gui

// An expert's loop through the trainee's own views, while the trial waits.
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <cmath>

#include "gui/pages/background.h"
#include "gui/pages/blade_control.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/help_panel.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/expert_loop.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"
#include "gui/views/operator_view.h"
#include "gui/views/theme.h"
#include "gui/views/video_view.h"

namespace vallecula::gui {

void TrialPage::offer_helps() {
  const QString waits = session_ && running_ ? QString() : tr("Once the trial runs");
  const QString counts = assessed() ? tr("Not in an assessment") : QString();
  const QString shown =
      session_ && session_->scenario().assistance.expert_loop ? QString() : tr("This scenario does not show it.");
  const auto first = [](std::initializer_list<QString> reasons) {
    for (const QString& reason : reasons)
      if (!reason.isEmpty()) return reason;
    return QString();
  };
  helps_->offer(first({counts, waits}), first({counts, shown, waits}), running_);
}

void TrialPage::show_expert() {
  if (!session_ || !running_ || ending_ || expert_wanted_) return;
  try {
    session_->freeze(Holder::expert, true);
  } catch (const std::exception& error) {
    return show_banner({in_words(error.what()), true});
  }
  expert_wanted_ = true;
  control_->steer(nullptr);  // whatever the mouse does now is no steering
  hands_->release_all();
  session_->actions().hold(engine::kActionAided, true);
  expert_sign_->setStyleSheet(QString("background: %1; color: %2; padding: 8px 18px; border-radius: 5px; margin: 8px; "
                                      "font-weight: bold; font-size: %3pt;")
                                  .arg(theme::device().name(), theme::ground().name())
                                  .arg(theme::points(13.0)));
  expert_sign_->setText(tr("Expert - your trial waits"));
  expert_sign_->show();
  steered_->hide();  // nothing is steered meanwhile, and the sign stands there
  helps_->expert()->setText(tr("Back to my trial (G)"));
  show_banner({tr("An expert's hands at this patient, computed for it. Esc or G: back to your trial."), true});
  since_expert_.invalidate();
  if (expert_ || expert_coming_) return;
  expert_coming_ = true;
  run_in_background<std::shared_ptr<ExpertLoop>>(
      this,
      [session = session_]() mutable {
        const auto mine = std::move(session);  // not kept until the thread is tidied away
        return std::make_shared<ExpertLoop>(*mine);
      },
      [this, of = session_.get()](std::shared_ptr<ExpertLoop> loop) {
        if (session_.get() == of) take_expert(std::move(loop));
      },
      [this, of = session_.get()](const QString& message) {
        if (session_.get() != of) return;
        expert_coming_ = false;
        end_expert();
        show_banner({tr("The expert cannot be shown: %1").arg(message), true});
      });
}

void TrialPage::take_expert(std::shared_ptr<ExpertLoop> loop) {
  expert_coming_ = false;
  if (expert_wanted_) expert_ = std::move(loop);  // else its computing would take time from the trial
}

void TrialPage::draw_expert() {
  sound_->hear({}, true);
  const double now_s = since_expert_.isValid() ? 1e-3 * static_cast<double>(since_expert_.elapsed()) : 0.0;
  const engine::Snapshot* snapshot = expert_ ? expert_->frame(now_s) : nullptr;
  if (snapshot == nullptr) {
    const QString remark = expert_ && expert_->finished() ? in_words(expert_->remark()) : QString();
    expert_sign_->setText(remark.isEmpty() ? tr("Expert - being computed; your trial waits") : remark);
    operator_view_->draw();
    return;
  }
  if (!since_expert_.isValid()) since_expert_.start();
  const double whole_s = expert_->duration_s();
  expert_sign_->setText(tr("Expert - your trial waits\n%1 of %2 s   |   Esc or G: back to your trial")
                            .arg(std::fmod(now_s, whole_s), 0, 'f', 0)
                            .arg(whole_s, 0, 'f', 0));
  operator_view_->update_from(*snapshot);
  operator_view_->draw();
  panels_->show_expert(*snapshot, session_->scenario().sight_percent);
}

void TrialPage::end_expert() {
  if (!expert_wanted_) return;
  expert_wanted_ = false;
  expert_sign_->hide();
  steered_->setVisible(session_->takes_turns());
  session_->actions().hold(engine::kActionAided, false);
  helps_->expert()->setText(tr("Expert (G)"));
  if (expert_ && !expert_->finished()) expert_.reset();  // its computing would take time from the trial
  hand_to_blade();
  session_->freeze(Holder::expert, false);  // unless an instructor holds it, the hand takes hold as after any pause
  steer();
  show_steered();
  operator_view_->update_from(session_->latest());
  operator_view_->settle();
}

}  // namespace vallecula::gui

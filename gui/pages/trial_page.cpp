#include "gui/pages/trial_page.h"

#include <QLabel>
#include <stdexcept>
#include <string>
#include <utility>

#include "device/drivers/mouse_device.h"
#include "gui/pages/background.h"
#include "gui/pages/blade_control.h"
#include "gui/pages/distraction_panel.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/help_panel.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_panels.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/expert_loop.h"
#include "gui/session/patient_fit.h"
#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"
#include "gui/views/operator_view.h"

namespace vallecula::gui {
TrialPage::~TrialPage() {
  for (const auto& thread : {scoring_, leaving_})
    if (thread) thread->wait();  // results and logs are whole then
}

bool TrialPage::assessed() const {
  return session_ && session_->scenario().attempt.mode == curricula::Mode::assessment;
}

void TrialPage::open(std::shared_ptr<TrialSession> session, std::shared_ptr<PatientLook> look) {
  close_trial();
  session_ = std::move(session);
  look_ = std::move(look);
  const auto& scenario = session_->scenario();
  title_->setText(course_words(scenario.title));
  title_->setToolTip(html_of(scenario.briefing));
  const auto& intubation = session_->scene().intubation;
  operator_view_->show_patient(look_, session_->scene().tool.surface, intubation ? &*intubation : nullptr);
  show_helps();
  panels_->open(*session_, look_);
  operator_view_->update_from(session_->at_start());  // the look is as the last trial left it
  since_rest_.invalidate();
  sound_->open(intubation.has_value());
  hands_->setVisible(intubation.has_value());
  hands_->serve(intubation ? &session_->actions() : nullptr, session_->takes_turns());
  helps_->serve(&session_->actions());
  steered_->setVisible(session_->takes_turns());
  steer();
  control_->set_gain(mouse_gain());
  introduction_->hide();
  if (control_->steering()) introduction_->show_if_wanted(intubation.has_value(), session_->scenario().assistance);
  show_steered();
  QStringList warned;
  for (const auto& misfit : misfits(session_->package(), scenario)) warned << QString::fromStdString(misfit);
  show_banner({warned.join("\n"), !warned.isEmpty()});
  show_buttons();
  timer_.start();
  setFocus();
  emit opened();
}

void TrialPage::start() {
  if (!session_ || running_ || ending_) return;
  introduction_->dismiss();
  close_key_list(this);  // read before it; opened again it holds the trial
  try {
    session_->start();
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
    return;
  }
  running_ = true;
  session_->picture_expected();
  frames_ = 0;
  since_start_.start();
  flow_.begin(run_s());
  seen_again_s_ = levers_until_s_ = -1.0;
  since_shown_.start();
  since_frame_.start();
  show_buttons();
  setFocus();
  emit started();
}

void TrialPage::set_frame_hook(const std::function<void(const engine::Snapshot&)>& hook) {
  disconnect(frame_hook_);
  frame_hook_ = hook ? connect(this, &TrialPage::frame, this, hook) : QMetaObject::Connection();
}

void TrialPage::let_go() {
  const bool was_open = session_ != nullptr;
  expert_wanted_ = expert_coming_ = false;
  expert_sign_->hide();
  expert_.reset();
  std::shared_ptr<TrialSession> left = std::move(session_);
  session_.reset();
  if (was_open) left->halt();
  show_buttons();
  if (!was_open) return;
  emit closed();
  put_away(std::move(left));
}

/// The last of a session may wait for records, disk and its device's driver: not here.
void TrialPage::put_away(std::shared_ptr<TrialSession> session) {
  const auto away = std::make_shared<std::promise<void>>();
  const std::shared_future<void> before = std::exchange(gone_, away->get_future().share());
  leaving_ = run_in_background<bool>(
      this,
      [session = std::move(session), away, before]() mutable {
        session.reset();
        if (before.valid()) before.wait();
        away->set_value();
        return true;
      },
      [](bool) {}, [](const QString&) {});
}

void TrialPage::reset() { begin_anew(false); }
void TrialPage::begin_at_vallecula() { begin_anew(true); }

void TrialPage::begin_anew(bool at_vallecula) {
  if (!session_ || ending_ || assessed()) return;
  end_expert();
  try {
    const auto between = [this] {  // the hands begin anew as well, once the old attempt is no longer recorded
      const auto place = [](device::HapticDevice* device, const device::Keyframe& begin) {
        if (auto* mouse = dynamic_cast<device::MouseDevice*>(device))
          mouse->place(begin.position_m, begin.rotation_wxyz);
      };
      place(&session_->device(), starting_pose(session_->package(), session_->scenario()));
      if (const auto& intubation = session_->scene().intubation)
        place(session_->second_device(), starting_tube_pose(session_->package(), *intubation));
    };
    at_vallecula ? session_->reset_at_vallecula(between) : session_->reset(between);
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_trial();
    emit failed(message);
    return;
  }
  if (running_) {
    since_start_.restart();
    session_->picture_expected();
  }
  flow_.begin(run_s());
  seen_again_s_ = levers_until_s_ = -1.0;
  since_shown_.restart();
  panels_->distractions().serve(&session_->dual_task(), session_->by_person());
  frames_ = 0;
  panels_->clear();
  show_banner({});
  steer();
  if (session_->scene().intubation) hands_->serve(&session_->actions(), session_->takes_turns());
  show_steered();
  setFocus();
}

/// In a pause the tissue moves the blade on, and no hand feels it. A mouse stands nowhere in the room: it takes hold
/// where the blade is now, instead of pulling from where it was with more than any device could show. With the tube in
/// the hand the blade is nobody's, and stays.
void TrialPage::hand_to_blade() {
  auto* mouse = dynamic_cast<device::MouseDevice*>(&session_->device());
  if (mouse == nullptr || session_->latest().step < 0 || session_->led_in()) return;
  if (session_->pause().empty() && !session_->frozen()) return;  // the hand has hold of it: it would let the lift go
  if (session_->takes_turns() && session_->in_hand() != Tool::blade) return;
  const engine::Pose& blade = session_->latest().proxy_pose;
  const engine::Vec3& p = blade.position;
  const engine::Quat& q = blade.rotation;
  mouse->place({p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()});
  session_->actions().take_hold();  // what was taken by X or after a lead-in hangs at the mouse from where it was taken
}

void TrialPage::end(const QString& how) {
  if (!session_ || !running_ || ending_) return;
  end_expert();
  close_key_list(this);
  ending_ = true;
  running_ = false;
  timer_.stop();
  control_->steer(nullptr);
  hands_->serve(nullptr, false);
  helps_->serve(nullptr);
  panels_->close_trial();
  show_banner({tr("Scoring the trial ..."), true});
  show_buttons();
  scoring_ = run_in_background<TrialOutcome>(
      this,
      [session = session_, how]() mutable {
        const auto mine = std::move(session);  // not kept until the thread is tidied away
        return mine->finish(how.toStdString());
      },
      [this](TrialOutcome outcome) {
        ending_ = false;
        let_go();
        emit finished(outcome);
      },
      [this](const QString& message) {
        ending_ = false;
        let_go();
        emit failed(message);
      });
}

void TrialPage::close_trial() {
  close_key_list(this);
  timer_.stop();
  control_->steer(nullptr);
  hands_->serve(nullptr, false);
  helps_->serve(nullptr);
  panels_->close_trial();
  running_ = false;
  let_go();
}

void TrialPage::set_device_note(const QString& note) {
  device_note_->setText(note);
  device_note_->setVisible(!note.isEmpty());
}

const curricula::Scenario& TrialPage::scenario() const {
  if (!session_) throw std::logic_error("no trial is open");
  return session_->scenario();
}

const pipeline::PatientPackage& TrialPage::patient() const {
  if (!session_) throw std::logic_error("no trial is open");
  return session_->package();
}

SagittalView& TrialPage::sagittal_view() { return panels_->sagittal_view(); }

void TrialPage::say(const QString& line) {
  panels_->say(line);
  if (!session_ || !running_) return;
  session_->actions().hold(engine::kActionAided, true);  // what was said is nobody's business, that it was is the log's
  QTimer::singleShot(1000, this, [this, to = std::weak_ptr<TrialSession>(session_)] {
    if (const auto session = to.lock(); session && session == session_ && !expert_wanted_)
      session->actions().hold(engine::kActionAided, false);
  });
}

}  // namespace vallecula::gui

#include "gui/pages/trial_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <stdexcept>
#include <string>

#include "device/drivers/mouse_device.h"
#include "gui/pages/background.h"
#include "gui/pages/blade_control.h"
#include "gui/pages/distraction_panel.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/hints.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/trial_side.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/patient_fit.h"
#include "gui/session/scripted_hands.h"
#include "gui/session/user_settings.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"

namespace vallecula::gui {
namespace {

// 22 frames a second are enough for the eye and leave the haptic threads their cores; the cut changes slower.
constexpr int kFrameMs = 45;

/// For a device in the hand that is no mouse.
QString device_help(const device::DeviceInfo& info) {
  const int clutch = clutch_button_in_hand(info);
  return "Enter starts the trial and takes hold again after a pause, Esc ends it." +
         (clutch == 0 ? QString()
                      : QString(" Button %1 of the device, held, frees your hand: the blade stays.").arg(clutch));
}

}  // namespace

TrialPage::TrialPage(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  operator_view_ = new OperatorView(this);
  operator_view_->setMinimumSize(480, 340);
  control_ = new BladeControl(operator_view_);
  introduction_ = new MouseIntroduction(this);
  connect(control_, &BladeControl::gain_changed, this, [this](double gain) {
    keep_mouse_gain(gain);
    show_help();
  });
  title_ = new QLabel(this);
  title_->setObjectName("heading");
  monitor_ = new MonitorPanel(this);
  hands_ = new HandPanel(this);
  steered_ = new QLabel(this);
  steered_->setMargin(6);
  steered_->setAttribute(Qt::WA_TransparentForMouseEvents);
  banner_ = new QLabel(this);
  banner_->setWordWrap(true);
  banner_->setMinimumHeight(2 * banner_->fontMetrics().lineSpacing() + 16);  // two lines and their padding
  banner_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  auto* main = new QVBoxLayout;
  main->setSpacing(6);
  main->addWidget(title_);
  main->addWidget(monitor_);
  auto* picture = new QGridLayout;  // the introduction and whose hand is steered lie over the view
  picture->addWidget(operator_view_, 0, 0);
  picture->addWidget(steered_, 0, 0, Qt::AlignTop | Qt::AlignLeft);
  picture->addWidget(introduction_, 0, 0, Qt::AlignCenter);
  main->addLayout(picture, 1);
  main->addWidget(hands_);
  main->addWidget(banner_);
  side_ = new TrialSide(this);
  auto* columns = new QHBoxLayout;
  columns->addLayout(main, 17);
  columns->addWidget(side_, 10);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(10, 8, 10, 8);
  all->addLayout(columns, 1);
  all->addWidget(make_foot());
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &TrialPage::draw_frame);
  for (QWidget* second_half :
       {static_cast<QWidget*>(monitor_), static_cast<QWidget*>(hands_), static_cast<QWidget*>(steered_)})
    second_half->hide();
  show_banner("", "");
  show_buttons();
}

TrialPage::~TrialPage() {
  if (scoring_) scoring_->wait();  // its results are whole then
}

bool TrialPage::assessed() const {
  return session_ && session_->scenario().attempt.mode == curricula::Mode::assessment;
}

QWidget* TrialPage::make_foot() {
  auto* foot = new QWidget(this);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 2, 0, 0);
  help_ = new QLabel(foot);
  help_->setObjectName("faint");
  help_->setWordWrap(true);
  start_ = new QPushButton("Start", foot);
  start_->setObjectName("primary");
  end_ = new QPushButton("End", foot);
  reset_ = new QPushButton("Reset", foot);
  zoom_ = new QPushButton(foot);
  leave_ = new QPushButton("Back", foot);
  device_note_ = new QLabel(foot);
  device_note_->setObjectName("faint");
  device_note_->hide();
  row->addWidget(help_, 1);
  row->addWidget(device_note_);
  for (auto* button : {zoom_, reset_, end_, start_, leave_}) {
    button->setFocusPolicy(Qt::NoFocus);  // keys are the blade's
    row->addWidget(button);
  }
  start_->setToolTip("Enter");
  end_->setToolTip("Esc");
  reset_->setToolTip("R");
  zoom_->setToolTip("Z");
  connect(start_, &QPushButton::clicked, this, &TrialPage::start);
  connect(end_, &QPushButton::clicked, this, [this] { end("ended by trainee"); });
  connect(reset_, &QPushButton::clicked, this, &TrialPage::reset);
  connect(leave_, &QPushButton::clicked, this, &TrialPage::left);
  connect(zoom_, &QPushButton::clicked, this, [this] {
    using Zoom = OperatorView::Zoom;
    operator_view_->set_zoom(operator_view_->zoom() == Zoom::automatic ? Zoom::face
                             : operator_view_->zoom() == Zoom::face    ? Zoom::mouth
                                                                       : Zoom::automatic);
    show_buttons();
  });
  return foot;
}

void TrialPage::open(std::shared_ptr<TrialSession> session, std::shared_ptr<PatientLook> look) {
  close_trial();
  session_ = std::move(session);
  look_ = std::move(look);
  const auto& scenario = session_->scenario();
  title_->setText(QString::fromStdString(scenario.title));
  title_->setToolTip(html_of(scenario.briefing));
  const auto& intubation = session_->scene().intubation;
  operator_view_->show_patient(look_, session_->scene().tool.surface, intubation ? &*intubation : nullptr);
  show_helps();
  side_->open(*session_, look_);
  monitor_->clear();
  monitor_->setVisible(intubation.has_value());
  hands_->setVisible(intubation.has_value());
  hands_->serve(intubation ? &session_->actions() : nullptr, session_->takes_turns());
  steered_->setVisible(session_->takes_turns());
  steer();
  control_->set_gain(mouse_gain());
  introduction_->hide();
  if (control_->steering()) introduction_->show_if_wanted(intubation.has_value(), session_->scenario().assistance);
  show_steered();
  QStringList warned;
  for (const auto& misfit : misfits(session_->package(), scenario)) warned << QString::fromStdString(misfit);
  show_banner(warned.join("\n"), "");
  show_buttons();
  timer_.start();
  setFocus();
  emit opened();
}

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
  help_->setText(control_->steering()      ? control_->help()
                 : info.kind == "scripted" ? "Scripted hands are at work. Esc ends the trial."
                 : info.kind == "recorded" ? "The hands of a recorded trial are at work. Esc ends the trial."
                                           : device_help(info));
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
  steered_->setText(tube ? "You hold: right hand, TUBE. The blade stays."
                         : "You hold: left hand, BLADE. The tube stays.");
  steered_->setStyleSheet(
      QString("background: rgba(16, 20, 25, 200); color: %1; border: 2px solid %1; border-radius: 5px; "
              "font-weight: bold; margin: 6px;")
          .arg(theme::device().name()));
  show_help();
}

void TrialPage::start() {
  if (!session_ || running_ || ending_) return;
  introduction_->dismiss();
  try {
    session_->start();
  } catch (const std::exception& error) {
    emit failed(QString::fromUtf8(error.what()));
    return;
  }
  running_ = true;
  frames_ = 0;
  since_start_.start();
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
  session_.reset();
  show_buttons();
  if (was_open) emit closed();
}

void TrialPage::reset() {
  if (!session_ || ending_ || assessed()) return;
  try {
    session_->reset([this] {  // the hands begin anew as well, once the old attempt is no longer recorded
      const auto place = [](device::HapticDevice* device, const device::Keyframe& begin) {
        if (auto* mouse = dynamic_cast<device::MouseDevice*>(device))
          mouse->place(begin.position_m, begin.rotation_wxyz);
      };
      place(&session_->device(), starting_pose(session_->package(), session_->scenario()));
      if (const auto& intubation = session_->scene().intubation)
        place(session_->second_device(), starting_tube_pose(session_->package(), *intubation));
    });
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_trial();
    emit failed(message);
    return;
  }
  if (running_) since_start_.restart();
  since_shown_.restart();
  side_->distractions().serve(&session_->dual_task(), session_->by_person());
  frames_ = 0;
  side_->clear();
  monitor_->clear();
  show_banner("", "");
  steer();
  if (session_->scene().intubation) hands_->serve(&session_->actions(), session_->takes_turns());
  show_steered();
  setFocus();
}

void TrialPage::end(const QString& how) {
  if (!session_ || !running_ || ending_) return;
  ending_ = true;
  running_ = false;
  timer_.stop();
  control_->steer(nullptr);
  hands_->serve(nullptr, false);
  side_->distractions().serve(nullptr, false);
  show_banner("Scoring the trial ...", "");
  show_buttons();
  scoring_ = run_in_background<TrialOutcome>(
      this, [session = session_, how] { return session->finish(how.toStdString()); },
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
  timer_.stop();
  control_->steer(nullptr);
  hands_->serve(nullptr, false);
  side_->distractions().serve(nullptr, false);
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

SagittalView& TrialPage::sagittal_view() { return side_->sagittal_view(); }

double TrialPage::frames_per_second() const {
  return since_start_.isValid() && since_start_.elapsed() > 0
             ? 1e3 * frames_ / static_cast<double>(since_start_.elapsed())
             : 0.0;
}

void TrialPage::draw_frame() {
  if (!session_) return;
  const double seconds = since_frame_.isValid() ? 1e-3 * static_cast<double>(since_frame_.restart()) : 0.0;
  if (!since_frame_.isValid()) since_frame_.start();
  operator_view_->set_ghost_time(1e-3 * static_cast<double>(since_shown_.elapsed()));
  try {
    if (!running_) {  // before the start: the patient at rest
      operator_view_->draw();
      side_->draw_at_rest();
      return;
    }
    control_->advance(seconds);
    const engine::Snapshot& snapshot = session_->latest();
    operator_view_->update_from(snapshot);
    operator_view_->draw();
    side_->show_snapshot(snapshot, session_->scenario().sight_percent, session_->paused_s());
    monitor_->show_snapshot(snapshot);
    hands_->show_snapshot(snapshot);
    if (session_->takes_turns() && session_->in_hand() != shown_in_hand_) show_steered();
    const bool hinted = curricula::rules_of(session_->scenario().attempt.mode).assistance;  // a help like the others
    show_banner(
        banner_for(snapshot, QString::fromStdString(session_->fault()), QString::fromStdString(session_->pause())),
        snapshot.has_intubation && hinted ? hint_for(snapshot, session_->scenario().sight_percent, operator_view_->blade_in(),
                                           session_->takes_turns() ? QString("X") : QString())
                                : QString());
    ++frames_;
    emit frame(snapshot);
    if (session_->finished()) end("finished");
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_trial();
    emit failed(message);
  }
}

void TrialPage::show_banner(const QString& alert, const QString& hint) {
  const QString& text = alert.isEmpty() ? hint : alert;
  if (banner_->text() == text && !banner_->styleSheet().isEmpty()) return;
  banner_->setText(text);
  banner_->setStyleSheet(
      alert.isEmpty()
          ? QString("padding: 6px 10px; font-size: 11pt;")
          : QString("background: %1; color: #06202f; padding: 6px 10px; border-radius: 5px; font-weight: bold;")
                .arg(theme::device().name()));
}

void TrialPage::show_buttons() {
  start_->setEnabled(session_ != nullptr && !running_ && !ending_);
  end_->setEnabled(running_);
  reset_->setEnabled(running_);
  // What was begun as an assessment counts: it is neither begun anew nor thrown away.
  reset_->setVisible(!assessed());
  leave_->setEnabled(!ending_ && !(running_ && assessed()));
  using Zoom = OperatorView::Zoom;
  zoom_->setText(operator_view_->zoom() == Zoom::automatic ? "View: auto"
                 : operator_view_->zoom() == Zoom::face    ? "View: face"
                                                           : "View: mouth");
}

}  // namespace vallecula::gui

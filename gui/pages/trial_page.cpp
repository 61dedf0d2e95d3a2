#include "gui/pages/trial_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <map>
#include <stdexcept>
#include <string>

#include "device/drivers/mouse_device.h"
#include "gui/pages/background.h"
#include "gui/pages/blade_control.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/report/markdown.h"
#include "gui/session/device_choice.h"
#include "gui/session/patient_fit.h"
#include "gui/session/user_settings.h"
#include "gui/views/force_bars.h"
#include "gui/views/operator_view.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"

namespace vallecula::gui {
namespace {

// 22 frames a second are enough for the eye and leave the haptic threads their cores; the cut changes slower.
constexpr int kFrameMs = 45;
constexpr int kSagittalMs = 140;

double load(const engine::Snapshot& snapshot, engine::Structure structure) {
  return snapshot.loads[static_cast<std::size_t>(structure)].force_n.norm();
}

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
  operator_view_->setMinimumSize(480, 400);
  control_ = new BladeControl(operator_view_);
  introduction_ = new MouseIntroduction(this);
  connect(control_, &BladeControl::gain_changed, this, [this](double gain) {
    keep_mouse_gain(gain);
    show_help();
  });
  title_ = new QLabel(this);
  title_->setObjectName("heading");
  banner_ = new QLabel(this);
  banner_->setWordWrap(true);
  banner_->setMinimumHeight(2 * banner_->fontMetrics().lineSpacing() + 16);  // two lines and their padding
  banner_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  auto* main = new QVBoxLayout;
  main->setSpacing(6);
  main->addWidget(title_);
  auto* picture = new QGridLayout;  // the introduction lies over the view
  picture->addWidget(operator_view_, 0, 0);
  picture->addWidget(introduction_, 0, 0, Qt::AlignCenter);
  main->addLayout(picture, 1);
  main->addWidget(banner_);
  auto* columns = new QHBoxLayout;
  columns->addLayout(main, 17);
  columns->addWidget(make_side(), 10);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(10, 8, 10, 8);
  all->addLayout(columns, 1);
  all->addWidget(make_foot());
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &TrialPage::frame);
  show_banner("");
  show_buttons();
}

TrialPage::~TrialPage() = default;

QWidget* TrialPage::make_side() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* caption = new QLabel("Mid-sagittal cut", side);
  caption->setObjectName("heading");
  sagittal_view_ = new SagittalView(side);
  sagittal_view_->setMinimumSize(320, 280);
  bars_ = new ForceBars(side);
  auto* bars_panel = new QFrame(side);
  bars_panel->setObjectName("panel");
  (new QVBoxLayout(bars_panel))->addWidget(bars_);
  auto* readings_panel = new QFrame(side);
  readings_panel->setObjectName("panel");
  readings_ = new TrialReadings(readings_panel);
  auto* inside = new QVBoxLayout(readings_panel);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addWidget(readings_);
  column->addWidget(caption);
  column->addWidget(sagittal_view_, 1);
  column->addWidget(bars_panel);
  column->addWidget(readings_panel);
  return side;
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
  row->addWidget(help_, 1);
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
  operator_view_->show_patient(look_, session_->scene().tool.surface);
  sagittal_view_->show_patient(look_, session_->scene().tool.surface);
  bars_->set_marks(
      {scenario.targets.tongue_force_n, scenario.targets.gum_force_n, session_->scene().haptics.device_limit_n});
  std::map<std::string, std::array<double, 3>> landmarks_m;
  for (const auto& [name, point] : look_->package.landmarks)
    landmarks_m[name] = {1e-3 * point[0], 1e-3 * point[1], 1e-3 * point[2]};
  readings_->set_scenario(scenario, curricula::mouth_from_landmarks(landmarks_m));
  auto* mouse = dynamic_cast<device::MouseDevice*>(&session_->device());
  control_->steer(mouse);
  control_->set_gain(mouse_gain());
  introduction_->hide();
  if (mouse != nullptr) introduction_->show_if_wanted();
  show_help();
  QStringList warned;
  for (const auto& misfit : misfits(session_->package(), scenario)) warned << QString::fromStdString(misfit);
  show_banner(warned.join("\n"));
  show_buttons();
  timer_.start();
  setFocus();
}

void TrialPage::show_help() {
  if (!session_) return;
  const device::DeviceInfo info = session_->device().info();
  help_->setText(control_->steering()      ? control_->help()
                 : info.kind == "scripted" ? "A scripted hand holds the blade. Esc ends the trial."
                 : info.kind == "recorded" ? "The hand of a recorded trial holds the blade. Esc ends the trial."
                                           : device_help(info));
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
  since_frame_.start();
  show_buttons();
  setFocus();
}

void TrialPage::reset() {
  if (!session_ || ending_) return;
  try {
    session_->reset([this] {
      auto* mouse = dynamic_cast<device::MouseDevice*>(&session_->device());
      if (mouse == nullptr) return;  // the hand begins anew as well, once the old attempt is no longer recorded
      const device::Keyframe begin = starting_pose(session_->package(), session_->scenario());
      mouse->place(begin.position_m, begin.rotation_wxyz);
    });
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_trial();
    emit failed(message);
    return;
  }
  if (running_) since_start_.restart();
  frames_ = 0;
  bars_->clear();
  readings_->clear();
  show_banner("");
  control_->steer(dynamic_cast<device::MouseDevice*>(&session_->device()));
  setFocus();
}

void TrialPage::end(const QString& how) {
  if (!session_ || !running_ || ending_) return;
  ending_ = true;
  running_ = false;
  timer_.stop();
  control_->steer(nullptr);
  show_banner("Scoring the trial ...");
  show_buttons();
  run_in_background<TrialOutcome>(
      this, [session = session_, how] { return session->finish(how.toStdString()); },
      [this](TrialOutcome outcome) {
        ending_ = false;
        session_.reset();
        show_buttons();
        emit finished(outcome);
      },
      [this](const QString& message) {
        ending_ = false;
        session_.reset();
        show_buttons();
        emit failed(message);
      });
}

void TrialPage::close_trial() {
  timer_.stop();
  control_->steer(nullptr);
  running_ = false;
  session_.reset();
  show_buttons();
}

const curricula::Scenario& TrialPage::scenario() const {
  if (!session_) throw std::logic_error("no trial is open");
  return session_->scenario();
}

const pipeline::PatientPackage& TrialPage::patient() const {
  if (!session_) throw std::logic_error("no trial is open");
  return session_->package();
}

double TrialPage::frames_per_second() const {
  return since_start_.isValid() && since_start_.elapsed() > 0
             ? 1e3 * frames_ / static_cast<double>(since_start_.elapsed())
             : 0.0;
}

void TrialPage::frame() {
  if (!session_) return;
  const double seconds = since_frame_.isValid() ? 1e-3 * static_cast<double>(since_frame_.restart()) : 0.0;
  if (!since_frame_.isValid()) since_frame_.start();
  try {
    if (!running_) {  // before the start: the patient at rest
      operator_view_->draw();
      if (!since_sagittal_.isValid() || since_sagittal_.elapsed() > 500) {
        since_sagittal_.restart();
        sagittal_view_->draw();
      }
      return;
    }
    control_->advance(seconds);
    const engine::Snapshot& snapshot = session_->latest();
    operator_view_->update_from(snapshot);
    operator_view_->draw();
    if (!since_sagittal_.isValid() || since_sagittal_.elapsed() >= kSagittalMs) {
      since_sagittal_.restart();
      sagittal_view_->update_from(snapshot, session_->scenario().sight_percent);
      sagittal_view_->draw();
    }
    readings_->show_snapshot(snapshot, session_->paused_s());
    bars_->show_forces(load(snapshot, engine::Structure::tongue), load(snapshot, engine::Structure::gum));
    show_banner(
        banner_for(snapshot, QString::fromStdString(session_->fault()), QString::fromStdString(session_->pause())));
    ++frames_;
    if (frame_hook_) frame_hook_(snapshot);
    if (session_->finished()) end("finished");
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_trial();
    emit failed(message);
  }
}

void TrialPage::show_banner(const QString& text) {
  if (banner_->text() == text && !banner_->styleSheet().isEmpty()) return;
  banner_->setText(text);
  banner_->setStyleSheet(
      text.isEmpty()
          ? QString("padding: 6px 10px;")
          : QString("background: %1; color: #06202f; padding: 6px 10px; border-radius: 5px; font-weight: bold;")
                .arg(theme::kDevice.name()));
}

void TrialPage::show_buttons() {
  start_->setEnabled(session_ != nullptr && !running_ && !ending_);
  end_->setEnabled(running_);
  reset_->setEnabled(running_);
  leave_->setEnabled(!ending_);
  using Zoom = OperatorView::Zoom;
  zoom_->setText(operator_view_->zoom() == Zoom::automatic ? "View: auto"
                 : operator_view_->zoom() == Zoom::face    ? "View: face"
                                                           : "View: mouth");
}

void TrialPage::keyPressEvent(QKeyEvent* event) {
  const bool entered = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool only_read = entered && !introduction_->isHidden();  // Enter closes what was read, and begins nothing yet
  introduction_->dismiss();  // whoever presses other keys knows them; those do their work as well
  if (only_read) return;
  if (control_->steering() && control_->key(event, true)) return;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (running_)
        session_->confirm();
      else
        start_->click();
      return;
    case Qt::Key_Escape:
      if (running_)
        end_->click();
      else
        leave_->click();
      return;
    case Qt::Key_R:
      reset_->click();
      return;
    case Qt::Key_Z:
      zoom_->click();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void TrialPage::keyReleaseEvent(QKeyEvent* event) {
  if (control_->steering() && control_->key(event, false)) return;
  QWidget::keyReleaseEvent(event);
}

void TrialPage::focusOutEvent(QFocusEvent* event) {
  control_->release_all();  // a key let go elsewhere would lift for ever
  QWidget::focusOutEvent(event);
}

void TrialPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  setFocus();
}

}  // namespace vallecula::gui

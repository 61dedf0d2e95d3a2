#include "gui/instructor/device_check.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRandomGenerator>
#include <QStyle>
#include <QVBoxLayout>

#include "device/drivers/mouse_device.h"
#include "device/factory.h"
#include "gui/instructor/reach_pad.h"
#include "gui/pages/background.h"
#include "gui/session/user_settings.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {
namespace {

constexpr int kLookMs = 33;
constexpr double kKeyStepM = 0.002, kFineKeyStepM = 0.0005;  ///< of the mouse's blade, an arrow key

struct Look {
  const char *mark, *role;
};

Look look_of(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::good:
      return {"\xe2\x9c\x93", "good"};
    case CheckVerdict::bad:
      return {"\xe2\x9c\x97", "warning"};
    case CheckVerdict::under_way:
      return {"\xe2\x96\xb6", ""};
    case CheckVerdict::skipped:
      return {"\xe2\x80\x93", "faint"};
    case CheckVerdict::to_come:
      break;
  }
  return {"\xc2\xb7", "faint"};
}

void set_role(QLabel* label, const char* role) {
  if (label->property("role").toString() == role) return;
  label->setProperty("role", role);
  label->style()->unpolish(label);
  label->style()->polish(label);
}

}  // namespace

DeviceCheck::DeviceCheck(const QString& name, Maker make, QWidget* parent, std::function<int()> random)
    : QDialog(parent), name_(name), make_(std::move(make)), random_(std::move(random)) {
  if (!random_) random_ = [] { return static_cast<int>(QRandomGenerator::global()->bounded(2)); };
  setWindowTitle(tr("Device check"));
  title_ = new QLabel(tr("Device check"), this);
  title_->setObjectName("title");
  pad_ = new ReachPad(this);
  ask_ = new QLabel(this);
  ask_->setObjectName("heading");
  ask_->setWordWrap(true);
  ask_->setMinimumHeight(3 * ask_->fontMetrics().lineSpacing());
  auto* upper = new QHBoxLayout;
  upper->setSpacing(18);
  upper->addWidget(make_lines(), 3);
  upper->addWidget(pad_, 2);
  push_ = new QPushButton(tr("&Push"), this);
  push_->setObjectName("primary");
  push_->setToolTip(tr("Enter: the device pushes once, gently, and you say which way"));
  centre_ = new QPushButton(tr("Count from &here"), this);
  centre_->setToolTip(tr("Where you are with it now becomes the middle of the mouth"));
  cannot_ = new QPushButton(tr("I &cannot do this"), this);
  cannot_->setToolTip(tr("This step is noted as not done, and the next one comes"));
  again_ = new QPushButton(tr("Check &again"), this);
  close_ = new QPushButton(tr("Close"), this);
  close_->setToolTip(tr("Esc"));
  answers_ = make_answers();
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {centre_, cannot_, push_}) row->addWidget(button);
  row->addStretch(1);
  for (QPushButton* button : {again_, close_}) row->addWidget(button);
  for (QPushButton* button : {push_, centre_, cannot_, again_, close_}) button->setAutoDefault(false);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(24, 18, 24, 16);
  all->setSpacing(10);
  all->addWidget(title_);
  all->addLayout(upper, 1);
  all->addWidget(ask_);
  all->addWidget(answers_);
  all->addLayout(row);
  resize(920, 560);
  connect(push_, &QPushButton::clicked, this, [this] {
    if (run_) run_->push();
  });
  connect(centre_, &QPushButton::clicked, this, [this] {
    if (run_) run_->centre();
  });
  connect(cannot_, &QPushButton::clicked, this, [this] {
    if (run_) run_->cannot();
  });
  connect(again_, &QPushButton::clicked, this, &DeviceCheck::begin);
  connect(close_, &QPushButton::clicked, this, &QDialog::accept);
  connect(pad_, &ReachPad::dragged, this, [this](double right_m, double up_m) {
    if (mouse_ != nullptr) mouse_->move(right_m, up_m);
  });
  connect(pad_, &ReachPad::wheeled, this, [this](double away_m) {
    if (mouse_ != nullptr) mouse_->advance(away_m);
  });
  clock_.setInterval(kLookMs);
  connect(&clock_, &QTimer::timeout, this, &DeviceCheck::look);
  begin();
}

DeviceCheck::~DeviceCheck() {
  if (opener_) opener_->wait();
}

void DeviceCheck::done(int result) {
  closing_ = true;
  if (opening_) {  // it is closed once it is known what there is to let go
    ask_->setText(tr("Closing the device ..."));
    return;
  }
  release();
  QDialog::done(result);
}

void DeviceCheck::release() {
  clock_.stop();
  run_.reset();
  mouse_ = nullptr;
  probe_.reset();
}

QWidget* DeviceCheck::make_lines() {
  auto* lines = new QWidget(this);
  auto* grid = new QGridLayout(lines);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(9);
  grid->setHorizontalSpacing(12);
  grid->setColumnStretch(2, 1);
  for (int i = 0; i < kCheckSteps; ++i) {
    const auto at = static_cast<std::size_t>(i);
    marks_[at] = new QLabel(lines);
    marks_[at]->setMinimumWidth(18);
    auto* title = new QLabel(CheckRun::title(static_cast<CheckStep>(i)), lines);
    words_[at] = new QLabel(lines);
    words_[at]->setWordWrap(true);
    words_[at]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words_[at]->setAccessibleName(title->text());
    grid->addWidget(marks_[at], i, 0, Qt::AlignTop);
    grid->addWidget(title, i, 1, Qt::AlignTop);
    grid->addWidget(words_[at], i, 2, Qt::AlignTop);
  }
  grid->setRowStretch(kCheckSteps, 1);
  return lines;
}

QWidget* DeviceCheck::make_answers() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  const struct {
    int axis, sign;
    QKeySequence key;
  } ways[] = {{0, -1, Qt::Key_Left},   {0, 1, Qt::Key_Right},    {1, 1, Qt::Key_Up}, {1, -1, Qt::Key_Down},
              {2, -1, Qt::Key_PageUp}, {2, 1, Qt::Key_PageDown}, {0, 0, Qt::Key_0}};
  for (const auto& way : ways) {
    auto* button = new QPushButton(way.sign == 0 ? tr("Nothing") : direction_words(way.axis, way.sign), row);
    button->setShortcut(way.key);
    button->setToolTip(way.key.toString(QKeySequence::NativeText));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, axis = way.axis, sign = way.sign] {
      if (run_) run_->felt(axis, sign);
    });
    layout->addWidget(button);
  }
  layout->addStretch(1);
  return row;
}

void DeviceCheck::begin() {
  if (opening_) return;
  release();  // before it is opened anew
  opening_ = true;
  show_lines({});
  ask_->setText(tr("Opening the device ..."));
  for (QWidget* one : {static_cast<QWidget*>(push_), static_cast<QWidget*>(centre_), static_cast<QWidget*>(cannot_),
                       static_cast<QWidget*>(again_), answers_})
    one->setEnabled(false);
  opener_ = run_in_background<std::unique_ptr<device::HapticDevice>>(
      this, make_,
      [this](std::unique_ptr<device::HapticDevice> device) {
        opening_ = false;
        if (closing_) {
          device.reset();
          done(QDialog::Rejected);
          return;
        }
        mouse_ = dynamic_cast<device::MouseDevice*>(device.get());
        if (mouse_ != nullptr) mouse_->set_view_axes({-1, 0, 0}, {0, -1, 0}, {0, 0, -1});
        const device::DeviceInfo info = device->info();
        title_->setText(tr("Check of %1").arg(capitalised(QString::fromStdString(info.model))));
        probe_ = std::make_unique<DeviceProbe>(std::move(device), guard_settings(info));
        run_ = std::make_unique<CheckRun>(*probe_, clutch_button_in_hand(info), random_);
        pad_->setFocus();
        clock_.start();
      },
      [this](const QString& message) {
        opening_ = false;
        end(CheckRun::not_opened(message));
        if (closing_) done(QDialog::Rejected);
      });
}

void DeviceCheck::look() {
  run_->look();
  show_run();
  if (run_->over()) end(run_->lines());
}

void DeviceCheck::show_run() {
  show_lines(run_->lines());
  pad_->show_tip(run_->state().tool_m, run_->reached(), run_->step() == CheckStep::reach);
  ask_->setText(run_->ask());
  push_->setEnabled(run_->may_push());
  answers_->setEnabled(run_->may_answer());
  centre_->setEnabled(run_->step() == CheckStep::reach);
  cannot_->setEnabled(run_->step() != CheckStep::rate);
}

void DeviceCheck::show_lines(const std::array<CheckLine, kCheckSteps>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Look look = look_of(lines[i].verdict);
    marks_[i]->setText(QString::fromUtf8(look.mark));
    set_role(marks_[i], look.role);
    words_[i]->setText(lines[i].words);
    set_role(words_[i], lines[i].verdict == CheckVerdict::bad ? "warning" : "faint");
  }
}

void DeviceCheck::end(const std::array<CheckLine, kCheckSteps>& lines) {
  const auto told = lines;  // they may be the run's
  release();
  show_lines(told);
  CheckResult result;
  result.device = name_;
  result.at = QDateTime::currentDateTime();
  result.lines = told;
  for (QWidget* one :
       {static_cast<QWidget*>(push_), static_cast<QWidget*>(centre_), static_cast<QWidget*>(cannot_), answers_})
    one->setEnabled(false);
  again_->setEnabled(true);
  close_->setFocus();
  ask_->setText(result.bad() == 0 ? tr("All is as it should be.")
                                  : tr("Not as it should be: %1 of %2.").arg(result.bad()).arg(kCheckSteps));
  emit checked(result);
}

bool DeviceCheck::move_by_key(int key, bool finely) {
  if (mouse_ == nullptr) return false;
  const double step_m = finely ? kFineKeyStepM : kKeyStepM;
  if (key == Qt::Key_Left || key == Qt::Key_Right)
    mouse_->move(key == Qt::Key_Left ? -step_m : step_m, 0.0);
  else if (key == Qt::Key_Up || key == Qt::Key_Down)
    mouse_->move(0.0, key == Qt::Key_Up ? step_m : -step_m);
  else if (key == Qt::Key_PageUp || key == Qt::Key_PageDown)
    mouse_->advance(key == Qt::Key_PageUp ? step_m : -step_m);
  else
    return false;
  return true;
}

void DeviceCheck::keyPressEvent(QKeyEvent* event) {
  if (move_by_key(event->key(), (event->modifiers() & Qt::ShiftModifier) != 0)) return;
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && run_) {
    run_->push();
    return;
  }
  QDialog::keyPressEvent(event);
}

const CheckResult* DeviceChecks::find(const QString& device) const {
  const auto found = kept_.find(device);
  return found == kept_.end() ? nullptr : &found->second;
}

bool DeviceChecks::due(const QString& device) const {
  if (find(device) != nullptr) return false;
  for (const device::DeviceKind& kind : device::device_kinds())
    if (kind.kind == device.section(':', 0, 0).toStdString()) return kind.hardware;
  return false;
}

QString DeviceChecks::words(const QString& device, const QDateTime& now) const {
  const CheckResult* result = find(device);
  if (result == nullptr) return due(device) ? tr("Device not checked") : QString();
  const int minutes = static_cast<int>(result->at.secsTo(now) / 60);
  const QString when = minutes < 1 ? tr("Device checked just now") : tr("Device checked %1 min ago").arg(minutes);
  return result->bad() == 0 ? when
                            : tr("%1: %2 of %3 not as it should be").arg(when).arg(result->bad()).arg(kCheckSteps);
}

}  // namespace vallecula::gui

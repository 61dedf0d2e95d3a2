#include "gui/instructor/instructor_controls.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <memory>
#include <tuple>

#include "engine/tube/intubation_record.h"

namespace vallecula::gui {

InstructorControls::InstructorControls(QWidget* parent) : QWidget(parent) {
  freeze_ = new QPushButton(tr("&Freeze"), this);
  freeze_->setCheckable(true);
  freeze_->setToolTip(tr("The trial's clock stands, no force is shown, the tools stay where they are (F5)"));
  freeze_->setShortcut(Qt::Key_F5);
  connect(freeze_, &QPushButton::clicked, this, &InstructorControls::freeze_wanted);
  auto* grid = new QGridLayout;
  grid->setSpacing(6);
  const auto put = [&](int row, int column, QPushButton* button) { grid->addWidget(button, row, column); };
  put(0, 0,
      vital_button(tr("SpO2 \xe2\x96\xbc"), tr("Held, the saturation falls (%)"), engine::kInstructorSaturationDown));
  put(0, 1,
      vital_button(tr("SpO2 \xe2\x96\xb2"), tr("Held, the saturation rises (%)"), engine::kInstructorSaturationUp));
  put(0, 2, freeze_);
  put(1, 0,
      vital_button(tr("Heart \xe2\x96\xbc"), tr("Held, the heart slows (beats a minute)"),
                   engine::kInstructorHeartDown));
  put(1, 1,
      vital_button(tr("Heart \xe2\x96\xb2"), tr("Held, the heart quickens (beats a minute)"),
                   engine::kInstructorHeartUp));
  put(1, 2,
      vital_button(tr("Laryngospasm"), tr("Pressed, the cords close; pressed again, they are let go"),
                   engine::kInstructorSpasm));
  line_ = new QComboBox(this);
  line_->setEditable(true);
  line_->setInsertPolicy(QComboBox::NoInsert);
  line_->setAccessibleName(tr("What the team says"));
  line_->setToolTip(tr("A ready sentence, or your own; Enter has the team say it on the trainee's screen"));
  line_->lineEdit()->setMaxLength(120);
  line_->lineEdit()->setPlaceholderText(tr("The team says ..."));
  line_->setMinimumContentsLength(12);
  line_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  line_->addItems({tr("What do you see?"), tr("Saturation is falling."), tr("Heart rate below 100."),
                   tr("Thirty seconds."), tr("Shall I press on the larynx?"), tr("Suction is ready."),
                   tr("Shall we ventilate by mask?"), tr("Stop, please.")});
  line_->setCurrentIndex(-1);
  say_ = new QPushButton(tr("&Say"), this);
  auto* team = new QHBoxLayout;
  team->addWidget(line_, 1);
  team->addWidget(say_);
  rules_ = new QLabel(this);
  rules_->setObjectName("faint");
  rules_->setWordWrap(true);
  message_ = new QLabel(this);
  message_->setObjectName("controls_message");
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  message_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addLayout(grid);
  column->addLayout(team);
  column->addWidget(rules_);
  column->addWidget(message_);
  connect(say_, &QPushButton::clicked, this, &InstructorControls::say);
  connect(line_->lineEdit(), &QLineEdit::returnPressed, this, &InstructorControls::say);
  connect(line_->lineEdit(), &QLineEdit::textChanged, this,
          [this](const QString& text) { say_->setEnabled(line_->isEnabled() && !text.trimmed().isEmpty()); });
  allow({});
}

/// The servo's thread reads what is held a thousand times a second; a click is held long enough to do something.
QPushButton* InstructorControls::vital_button(const QString& text, const QString& tip, std::uint32_t action) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(tip);
  button->setAutoDefault(false);
  vital_.push_back({button, action, tip});
  if (action == engine::kInstructorSpasm) {
    button->setCheckable(true);
    connect(button, &QPushButton::toggled, this, [this, action](bool on) { emit vital_sign(action, on); });
    return button;
  }
  const auto since = std::make_shared<QElapsedTimer>();
  connect(button, &QPushButton::pressed, this, [this, action, since] {
    since->start();
    emit vital_sign(action, true);
  });
  connect(button, &QPushButton::released, this, [this, button, action, since] {
    const int left_ms = kLeastHoldMs - static_cast<int>(since->elapsed());
    QTimer::singleShot(std::max(0, left_ms), button, [this, button, action] {
      if (!button->isDown()) emit vital_sign(action, false);
    });
  });
  return button;
}

bool InstructorControls::Trial::operator==(const Trial& other) const {
  const auto all = [](const Trial& t) {
    return std::make_tuple(t.open, t.running, t.stands, t.vital_signs, t.spasm, t.assessment, t.instructor);
  };
  return all(*this) == all(other);
}

QString InstructorControls::refusal(const Trial& trial, std::uint32_t action) const {
  if (!trial.running) return tr("Once a trial runs");
  if (!trial.vital_signs) return tr("This scenario has no infant's vital signs.");
  if (trial.assessment && !trial.instructor) return tr("In an assessment for an instructor who is signed in here");
  if (action == engine::kInstructorSpasm && !trial.spasm) return tr("This infant is relaxed: its cords do not close");
  // What is held down acts by the infant's clock.
  if (trial.stands) return tr("The infant's clock stands: once the trial goes on (F5: Freeze, Continue)");
  return {};
}

bool InstructorControls::leave_line() {
  if (!line_->hasFocus() && !line_->lineEdit()->hasFocus()) return false;
  setFocus();
  return true;
}

void InstructorControls::allow(const Trial& trial) {
  if (allowed_ && *allowed_ == trial) return;
  allowed_ = trial;
  const bool helps = trial.running && !trial.assessment;
  freeze_->setEnabled(helps);
  for (const Vital& vital : vital_) {
    const QString refused = refusal(trial, vital.action);
    vital.button->setEnabled(refused.isEmpty());
    vital.button->setToolTip(refused.isEmpty() ? vital.tip : refused);
  }
  line_->setEnabled(helps);
  say_->setEnabled(helps && !line_->currentText().trimmed().isEmpty());
  rules_->setText(
      !trial.open
          ? tr("No trial runs. One begins in the other window, by Practise or Course and there by Start; what is here "
               "then acts on it.")
      : !trial.running ? tr("The trial is prepared: Start in the other window begins it, or Enter there.")
      : trial.assessment && !trial.instructor
          ? tr("Assessment: its forces, figures and events are for an instructor who is signed in here, and so are its "
               "vital signs. It is not held up, and the team says nothing, for a line would be a help.")
      : trial.assessment
          ? tr("Assessment: it is not held up, and the team says nothing, for a line would be a help. A trial whose "
               "vital signs you change counts neither way.")
      : !trial.vital_signs ? tr("This scenario has no infant's vital signs.")
      : trial.stands       ? tr("The infant's clock stands: its vital signs are changed once the trial goes on.")
                           : tr("Vital signs you change are recorded; the trial then counts neither way."));
  tell({});
}

void InstructorControls::show_frozen(bool frozen) {
  if (freeze_->isChecked() == frozen && freeze_->property("frozen").toBool() == frozen) return;
  freeze_->setProperty("frozen", frozen);
  freeze_->setChecked(frozen);
  freeze_->setText(frozen ? tr("&Continue") : tr("&Freeze"));
  freeze_->setShortcut(Qt::Key_F5);  // the text took it
}

void InstructorControls::tell(const QString& message) {
  message_->setText(message);
  message_->setVisible(!message.isEmpty());
}

void InstructorControls::release_all() {
  for (const Vital& vital : vital_) {
    if (vital.button->isCheckable()) vital.button->setChecked(false);
    vital.button->setDown(false);
    emit vital_sign(vital.action, false);
  }
}

void InstructorControls::say() {
  const QString line = line_->currentText().trimmed();
  if (line.isEmpty() || !line_->isEnabled()) return;
  emit say_wanted(line);
  line_->setCurrentIndex(-1);
  line_->clearEditText();
}

}  // namespace vallecula::gui

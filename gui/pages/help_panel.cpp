#include "gui/pages/help_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "gui/pages/wrap_row.h"
#include "gui/session/expert_loop.h"

namespace vallecula::gui {

HelpPanel::HelpPanel(QWidget* parent) : QWidget(parent) {
  auto* row = new WrapRow(this);
  row->setSpacing(6);
  const auto button = [&](const QString& text) {
    auto* made = new QPushButton(text, this);
    made->setFocusPolicy(Qt::NoFocus);  // keys are the hands'
    made->setStyleSheet("padding: 5px 6px;");
    row->addWidget(made);
    return made;
  };
  vallecula_ = button(tr("From vallecula (F)"));
  expert_ = button(tr("Expert (G)"));
  extend_ = button(tr("Extend head (H)"));
  extend_->setCheckable(true);
  connect(extend_, &QPushButton::clicked, this, &HelpPanel::extend);
  auto* head = new QWidget(this);
  head->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  auto* arrows = new QHBoxLayout(head);
  arrows->setContentsMargins(6, 0, 0, 0);
  arrows->setSpacing(6);
  auto* eye = new QLabel(tr("My head"), head);
  eye->setObjectName("faint");
  arrows->addWidget(eye);
  row->addWidget(head);
  using engine::Action;
  const auto arrow = [&](int right, int up, Action action, Action opposite, Qt::ArrowType sign, const QString& name,
                         const QString& key) {
    auto* made = new QToolButton(head);
    made->setArrowType(sign);
    made->setCheckable(true);
    made->setFocusPolicy(Qt::NoFocus);
    made->setAccessibleName(name);
    arrows->addWidget(made);
    connect(made, &QToolButton::clicked, this, [this, right, up] { move_eye(right, up); });
    return Eye{right, up, action, opposite, made, tr("%1: 2 cm, and back when pressed again (%2)").arg(name, key)};
  };
  eyes_ = {
      arrow(-1, 0, Action::kActionEyeLeft, Action::kActionEyeRight, Qt::LeftArrow, tr("My head to the left"),
            tr("Ctrl+Left")),
      arrow(0, 1, Action::kActionEyeUp, Action::kActionEyeDown, Qt::UpArrow, tr("My head up"), tr("Ctrl+Up")),
      arrow(0, -1, Action::kActionEyeDown, Action::kActionEyeUp, Qt::DownArrow, tr("My head down"), tr("Ctrl+Down")),
      arrow(1, 0, Action::kActionEyeRight, Action::kActionEyeLeft, Qt::RightArrow, tr("My head to the right"),
            tr("Ctrl+Right"))};
  offer({}, {}, false);
}

void HelpPanel::serve(HandActions* actions) {
  actions_ = actions;
  refresh();
}

void HelpPanel::offer(const QString& no_vallecula, const QString& no_expert, bool running) {
  const auto set = [](QAbstractButton* button, const QString& refused, const QString& tip) {
    button->setEnabled(refused.isEmpty());
    button->setToolTip(refused.isEmpty() ? tip : refused);
  };
  set(vallecula_, no_vallecula,
      tr("Begins anew with the blade's tip in the vallecula (F). What was done until now is kept; the new trial does "
         "not "
         "count towards mastery."));
  set(expert_, no_expert,
      tr("Up to %1 s of an expert's hands at this patient, over and over, while your trial waits (G)")
          .arg(kLoopS, 0, 'f', 0));
  const QString waits = running ? QString() : tr("Once the trial runs");
  set(extend_, waits,
      tr("The infant's head is extended on the neck by 10 degrees, as by a shoulder roll, and back (H)"));
  for (const Eye& eye : eyes_) {
    eye.button->setEnabled(running);
    eye.button->setToolTip(running ? eye.tip : waits);
  }
}

void HelpPanel::step(engine::Action there, engine::Action other) {
  if (actions_ == nullptr) return;
  if (held(other))
    actions_->hold(other, false);
  else
    actions_->hold(there, !held(there));
}

void HelpPanel::move_eye(int right, int up) {
  for (const Eye& eye : eyes_)
    if (eye.right == right && eye.up == up && eye.button->isEnabled()) step(eye.action, eye.opposite);
  refresh();
}

void HelpPanel::extend() {
  if (actions_ != nullptr && extend_->isEnabled()) actions_->hold(engine::kActionExtend, !held(engine::kActionExtend));
  refresh();
}

void HelpPanel::refresh() {
  for (const Eye& eye : eyes_) eye.button->setChecked(held(eye.action));
  extend_->setChecked(held(engine::kActionExtend));
}

}  // namespace vallecula::gui

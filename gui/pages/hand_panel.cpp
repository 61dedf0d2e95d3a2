#include "gui/pages/hand_panel.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPushButton>
#include <algorithm>

#include "gui/pages/wrap_row.h"

namespace vallecula::gui {

HandPanel::HandPanel(QWidget* parent) : QWidget(parent) {
  auto* row = new WrapRow(this);
  row->setSpacing(6);
  const auto button = [&](const QString& text, const QString& tip) {
    auto* made = new QPushButton(text, this);
    made->setFocusPolicy(Qt::NoFocus);  // keys are the hands'
    tips_[made] = tip;
    made->setStyleSheet("padding: 5px 4px;");
    made->setMinimumWidth(80);
    row->addWidget(made);
    return made;
  };
  using engine::Action;
  held_ = {{{Action::kActionBreath,
             button(tr("Breath (B)"), tr("Held: 40 a minute, by mask, or by the tube once it is in")),
             {Qt::Key_B, Qt::Key_Space}},
            {Action::kActionSuction,
             button(tr("Suction (V)"), tr("Held, with the catheter's tip in the secretions")),
             {Qt::Key_V, 0}},
            {Action::kActionPress,
             button(tr("Press larynx (L)"), tr("Held: the assistant presses on the larynx")),
             {Qt::Key_L, 0}},
            {Action::kActionStyletOut,
             button(tr("Stylet out (T)"), tr("Draws the stylet out of the tube, for good")),
             {Qt::Key_T, 0}}}};
  for (const Held& held : held_) {
    connect(held.button, &QPushButton::pressed, this, [this, held] { hold(held, true); });
    connect(held.button, &QPushButton::released, this, [this, held] { hold(held, false); });
  }
  catheter_ =
      button(tr("Catheter (C)"), tr("Takes the suction catheter in place of the tube, and back: outside the mouth"));
  other_hand_ =
      button(tr("Other hand (X)"), tr("Steers the other hand; what this one holds stays where it is (X or Tab)"));
  once_ = {{{catheter_, {Qt::Key_C, 0, 0}}, {other_hand_, {Qt::Key_X, Qt::Key_Tab, Qt::Key_Backtab}}}};
  connect(catheter_, &QPushButton::clicked, this, &HandPanel::change_catheter);
  connect(other_hand_, &QPushButton::clicked, this, [this] {
    if (actions_ != nullptr) actions_->change_hand();
  });
  set_running(false);
}

void HandPanel::serve(HandActions* actions, bool switches) {
  release_all();
  if (actions_ != nullptr) actions_->release_all();
  actions_ = actions;
  setEnabled(actions != nullptr);
  other_hand_->setVisible(switches);
}

/// As wide as the longest it will say: nothing beside it moves when it does.
void HandPanel::keep_room() {
  const QString now = catheter_->text();
  int most = 0;
  for (const QString& text :
       {tr("Tube out first (C)"), tr("Catheter out first (C)"), tr("Tube (C)"), tr("Catheter (C)")}) {
    catheter_->setText(text);
    most = std::max(most, catheter_->sizeHint().width());
  }
  catheter_->setText(now);
  catheter_->setMinimumWidth(most);
}

void HandPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  keep_room();
}

void HandPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) keep_room();
}

void HandPanel::set_running(bool running) {
  for (const auto& [button, tip] : tips_) {
    button->setEnabled(running);
    button->setToolTip(running ? tip : tr("Once the trial runs. %1").arg(tip));
  }
}

void HandPanel::hold(const Held& held, bool on) {
  if (actions_ != nullptr) actions_->hold(held.action, on);
}

void HandPanel::change_catheter() {
  if (actions_ != nullptr) actions_->hold(engine::kActionCatheter, !actions_->held(engine::kActionCatheter));
}

bool HandPanel::key(QKeyEvent* event, bool pressed) {
  if (actions_ == nullptr) return false;
  for (const Held& held : held_)
    if (event->key() == held.keys[0] || event->key() == held.keys[1]) {
      if (event->isAutoRepeat()) return true;
      if (pressed && !held.button->isEnabled()) return true;  // what is grey does nothing; what was held is let go of
      held.button->setDown(pressed);
      hold(held, pressed);
      return true;
    }
  for (const Once& once : once_) {
    if (!once.button->isVisibleTo(this)) continue;  // there is one hand to a device
    if (std::find(once.keys.begin(), once.keys.end(), event->key()) == once.keys.end()) continue;
    if (pressed && !event->isAutoRepeat()) once.button->click();
    return true;
  }
  return false;
}

std::vector<KeyRow> HandPanel::keys() const {
  if (actions_ == nullptr) return {};
  std::vector<KeyRow> rows;
  const auto add = [&](const auto& keys, QPushButton* button) {
    QStringList names;
    for (const int key : keys)
      if (key != 0) names << key_name(key);
    rows.push_back({names.join(", "), tips_.at(button)});
  };
  for (const Held& held : held_) add(held.keys, held.button);
  for (const Once& once : once_)
    if (once.button->isVisibleTo(this)) add(once.keys, once.button);
  return rows;
}

void HandPanel::release_all() {
  for (const Held& held : held_) {
    held.button->setDown(false);
    hold(held, false);
  }
}

void HandPanel::show_snapshot(const engine::Snapshot& snapshot) {
  if (!snapshot.has_intubation) return;
  using engine::InHand;
  const InHand in_hand = snapshot.intubation.in_hand;
  const bool wanted = actions_ != nullptr && actions_->held(engine::kActionCatheter), has = in_hand == InHand::catheter;
  catheter_->setText(wanted != has ? (wanted ? tr("Tube out first (C)") : tr("Catheter out first (C)"))
                     : has         ? tr("Tube (C)")
                                   : tr("Catheter (C)"));
  for (const Held& held : held_) {
    if (held.action == engine::kActionSuction) held.button->setEnabled(has);
    if (held.action == engine::kActionStyletOut) held.button->setEnabled(in_hand == InHand::tube_with_stylet);
  }
}

}  // namespace vallecula::gui

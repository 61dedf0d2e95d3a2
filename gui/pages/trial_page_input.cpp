// Keys on the trial page, and whom they belong to.
#include <QDialog>
#include <QKeyEvent>
#include <QPushButton>

#include "gui/pages/blade_control.h"
#include "gui/pages/distraction_panel.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/help_panel.h"
#include "gui/pages/key_list.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/views/operator_view.h"

namespace vallecula::gui {

/// The page's own keys: what is done, and what the list of keys says of it, from one table.
struct TrialPage::PageKey {
  int key;  ///< Qt::Key, with modifiers
  void (TrialPage::*act)();
  const char* what;
};

const std::vector<TrialPage::PageKey>& TrialPage::page_keys() {
  static const std::vector<PageKey> keys{
      {Qt::Key_Return, &TrialPage::enter_pressed, QT_TR_NOOP("starts the trial; takes hold again after a pause")},
      {Qt::Key_Enter, &TrialPage::enter_pressed, nullptr},
      {Qt::Key_Escape, &TrialPage::escape_pressed, QT_TR_NOOP("ends the trial; before it, goes back")},
      {Qt::Key_R, &TrialPage::reset_pressed, QT_TR_NOOP("begins anew; what was done is kept")},
      {Qt::Key_F, &TrialPage::vallecula_pressed, QT_TR_NOOP("begins anew with the blade's tip in the vallecula")},
      {Qt::Key_G, &TrialPage::expert_pressed, QT_TR_NOOP("an expert at this patient while the trial waits, and back")},
      {Qt::CTRL + Qt::Key_Left, &TrialPage::eye_left, QT_TR_NOOP("your own head 2 cm to the left, and back")},
      {Qt::CTRL + Qt::Key_Right, &TrialPage::eye_right, QT_TR_NOOP("your own head 2 cm to the right, and back")},
      {Qt::CTRL + Qt::Key_Up, &TrialPage::eye_up, QT_TR_NOOP("your own head 2 cm up, and back")},
      {Qt::CTRL + Qt::Key_Down, &TrialPage::eye_down, QT_TR_NOOP("your own head 2 cm down, and back")},
      {Qt::Key_H, &TrialPage::extend_head, QT_TR_NOOP("extends the infant's head by 10 degrees, and back")},
      {Qt::Key_Z, &TrialPage::change_zoom, QT_TR_NOOP("how near the view is: by itself, the face, the mouth")},
      {Qt::Key_M, &TrialPage::change_sound, QT_TR_NOOP("the monitor's sound, on or off")},
      {Qt::Key_F1, &TrialPage::keys_pressed, QT_TR_NOOP("this list, and closes it")}};
  return keys;
}

const TrialPage::PageKey* TrialPage::page_key(const QKeyEvent& event) const {
  const int key = event.key() | static_cast<int>(event.modifiers() & Qt::ControlModifier);
  for (const PageKey& mine : page_keys())
    if (mine.key == key) return &mine;
  return nullptr;
}

void TrialPage::keyPressEvent(QKeyEvent* event) {
  const bool entered = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool only_read = entered && !introduction_->isHidden();  // Enter closes what was read, and begins nothing yet
  introduction_->dismiss();  // whoever presses other keys knows them; those do their work as well
  if (only_read) return;
  const PageKey* mine = page_key(*event);
  // Plain keys are first the hands' and the questions'; with Ctrl they are the page's.
  if ((mine == nullptr || mine->key == event->key()) && takes_key(event, true)) return;
  if (mine == nullptr) return QWidget::keyPressEvent(event);
  if (!event->isAutoRepeat()) (this->*mine->act)();
}

void TrialPage::keyReleaseEvent(QKeyEvent* event) {
  if (takes_key(event, false)) return;
  QWidget::keyReleaseEvent(event);
}

bool TrialPage::takes_key(QKeyEvent* event, bool pressed) {
  return panels_->distractions().key(event, pressed) || (control_->steering() && control_->key(event, pressed)) ||
         hands_->key(event, pressed);
}

void TrialPage::enter_pressed() {
  if (expert_wanted_) return end_expert();
  if (!running_) return start_->click();
  hand_to_blade();
  session_->confirm();
}

void TrialPage::refuse_to_end() { end_refused_ = true; }  // the banner says why

void TrialPage::escape_pressed() {
  if (close_key_list(this)) return;  // it says so, wherever the keys go
  if (expert_wanted_) return end_expert();
  if (held_by_instructor()) return refuse_to_end();
  (running_ ? end_ : leave_)->click();
}

void TrialPage::expert_pressed() {
  if (expert_wanted_)
    end_expert();
  else if (helps_->expert()->isEnabled())
    show_expert();
}

void TrialPage::vallecula_pressed() { helps_->vallecula()->click(); }
void TrialPage::reset_pressed() { reset_->click(); }
void TrialPage::change_sound() {
  if (sound_->isVisibleTo(this)) sound_->toggle();
}
void TrialPage::eye_left() { helps_->move_eye(-1, 0); }
void TrialPage::eye_right() { helps_->move_eye(1, 0); }
void TrialPage::eye_up() { helps_->move_eye(0, 1); }
void TrialPage::eye_down() { helps_->move_eye(0, -1); }
void TrialPage::extend_head() { helps_->extend(); }

/// The key that opened it closes it, wherever the keys go.
void TrialPage::keys_pressed() {
  if (!close_key_list(this)) list_keys();
}

/// While it is read the clock of a person's practice stands.
void TrialPage::list_keys() {
  const bool holds = session_ && running_ && session_->by_person() && !assessed();
  const QString note =
      holds ? tr("Your trial waits while this list is open. F1 or Esc closes it; then it goes on as after any pause.")
      : running_ && assessed() ? tr("The clock runs on: an assessment is not held up.")
                               : QString();
  QDialog* list = show_key_list(this, keys(), note);
  if (list == nullptr || !holds) return;
  connect(list, &QDialog::finished, this, &TrialPage::end_reading);
  session_->freeze(Holder::reader, true);
  control_->release_all();  // what was held when the list came up is let go of elsewhere
  hands_->release_all();
}

void TrialPage::end_reading() {
  if (!session_ || !session_->frozen_by(Holder::reader)) return;
  hand_to_blade();
  session_->freeze(Holder::reader, false);  // the hand takes hold as after any pause
  setFocus();
}

void TrialPage::change_zoom() {
  using Zoom = OperatorView::Zoom;
  operator_view_->set_zoom(operator_view_->zoom() == Zoom::automatic ? Zoom::face
                           : operator_view_->zoom() == Zoom::face    ? Zoom::mouth
                                                                     : Zoom::automatic);
  show_buttons();
}

std::vector<KeyGroup> TrialPage::keys() const {
  KeyGroup page{tr("Trial"), {}};
  for (const PageKey& mine : page_keys())
    if (mine.what != nullptr) page.rows.push_back({key_name(mine.key), tr(mine.what)});
  return {page,
          {tr("What the hand steers"), control_->keys()},
          {tr("Hands and helpers"), hands_->keys()},
          {tr("Questions and alarms"), panels_->distractions().keys()},
          {tr("Panels"), panels_->keys()}};
}

bool TrialPage::focusNextPrevChild(bool next) {
  return !hands_->serving() && QWidget::focusNextPrevChild(next);  // Tab is the other hand's
}

void TrialPage::focusOutEvent(QFocusEvent* event) {
  control_->release_all();  // a key let go elsewhere would lift for ever
  hands_->release_all();
  QWidget::focusOutEvent(event);
}

void TrialPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  setFocus();
}

}  // namespace vallecula::gui

// Keys on the trial page, and whom they belong to.
#include <QKeyEvent>
#include <QPushButton>

#include "gui/pages/blade_control.h"
#include "gui/pages/distraction_panel.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_side.h"

namespace vallecula::gui {

void TrialPage::keyPressEvent(QKeyEvent* event) {
  const bool entered = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool only_read = entered && !introduction_->isHidden();  // Enter closes what was read, and begins nothing yet
  introduction_->dismiss();  // whoever presses other keys knows them; those do their work as well
  if (only_read) return;
  if (takes_key(event, true)) return;
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
  if (takes_key(event, false)) return;
  QWidget::keyReleaseEvent(event);
}

bool TrialPage::takes_key(QKeyEvent* event, bool pressed) {
  return side_->distractions().key(event, pressed) || (control_->steering() && control_->key(event, pressed)) || hands_->key(event, pressed);
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

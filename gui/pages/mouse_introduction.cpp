#include "gui/pages/mouse_introduction.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/session/user_settings.h"

namespace vallecula::gui {
namespace {

constexpr const char* kKey = "mouse/introduced";

}  // namespace

MouseIntroduction::MouseIntroduction(QWidget* parent) : QFrame(parent) {
  setObjectName("panel");
  auto* title = new QLabel("Your mouse holds the laryngoscope", this);
  title->setObjectName("heading");
  auto* text = new QLabel(
      "<table cellspacing='4'>"
      "<tr><td><b>Drag</b></td><td>moves the blade in the picture</td></tr>"
      "<tr><td><b>Wheel</b></td><td>deeper into the mouth, and back</td></tr>"
      "<tr><td><b>Ctrl-drag</b></td><td>turns it about its tip; so do a drag with the right button and W A S D (Q E: "
      "roll)</td></tr>"
      "<tr><td><b>Space</b></td><td>held: lifts along the handle; Backspace lowers</td></tr>"
      "<tr><td><b>Shift</b></td><td>held: all of it finer</td></tr>"
      "<tr><td><b>+ and -</b></td><td>the blade goes farther, or less far, for the same way of the mouse</td></tr>"
      "<tr><td><b>Arrows, PgUp, PgDn &nbsp;</b></td><td>move it without a mouse</td></tr>"
      "<tr><td><b>Enter, Esc</b></td><td>start the trial, end it</td></tr>"
      "<tr><td><b>R, Z</b></td><td>begin it again; change the view</td></tr></table>"
      "<p>Enter closes this; Enter again starts the trial.</p>"
      "<p>A mouse cannot push back: the bars on the right show the force your blade puts on tongue and gum.<br>"
      "Lift, do not lever. The grey blade is your hand, where the blade could not follow it.</p>",
      this);
  text->setTextFormat(Qt::RichText);
  never_again_ = new QCheckBox("Don't show this again", this);
  auto* known = new QPushButton("Got it", this);
  never_again_->setFocusPolicy(Qt::NoFocus);  // keys are the blade's
  known->setFocusPolicy(Qt::NoFocus);
  connect(known, &QPushButton::clicked, this, &MouseIntroduction::dismiss);
  auto* foot = new QHBoxLayout;
  foot->addWidget(never_again_, 1);
  foot->addWidget(known);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 16, 20, 16);
  column->addWidget(title);
  column->addWidget(text);
  column->addLayout(foot);
  hide();
}

void MouseIntroduction::show_if_wanted() {
  setVisible(!user_settings()->value(kKey, false).toBool());
  raise();
}

void MouseIntroduction::dismiss() {
  if (isHidden()) return;
  if (never_again_->isChecked()) user_settings()->setValue(kKey, true);
  hide();
}

}  // namespace vallecula::gui

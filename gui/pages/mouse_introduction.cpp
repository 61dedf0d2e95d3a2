#include "gui/pages/mouse_introduction.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/session/user_settings.h"
#include "gui/views/scrolled.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr const char* kKey = "mouse/introduced";
constexpr const char* kTubeKey = "mouse/introduced-tube";

constexpr const char* kMoves = QT_TRANSLATE_NOOP(
    "MouseIntroduction",
    "<tr><td><b>Drag, wheel</b></td><td>moves it in the picture; wheel forward: deeper into the mouth</td></tr>"
    "<tr><td><b>Ctrl-drag</b></td><td>turns it about its tip; so do a drag with the right button and W A S D (Q E: "
    "roll)</td></tr>"
    "<tr><td><b>Space</b></td><td>held: lifts the blade along its handle; Backspace lowers</td></tr>"
    "<tr><td><b>Shift, + and -</b></td><td>held: all of it finer; farther, or less far, for the same way</td></tr>"
    "<tr><td><b>Arrows, PgUp, PgDn &nbsp;</b></td><td>move it without a mouse</td></tr>");
constexpr int kEdge = 8;             // px, to the edge of what it lies over
constexpr int kBroader = 40;         // px a step
constexpr double kLeastLines = 6.0;  // of its words
constexpr const char* kTube = QT_TRANSLATE_NOOP(
    "MouseIntroduction",
    "<tr><td><b>X</b> (or Tab)</td><td>the other hand: blade or tube; what you let go of stays where it is</td></tr>"
    "<tr><td><b>B, L</b></td><td>held: breaths, by mask, or by the tube once it is in; pressure on the larynx</td></tr>"
    "<tr><td><b>C, V</b></td><td>suction catheter instead of the tube, and back; V held sucks</td></tr>"
    "<tr><td><b>T</b></td><td>draws the stylet out of the tube</td></tr>");
constexpr const char* kTubeRules = QT_TRANSLATE_NOOP(
    "MouseIntroduction",
    "<p>Tube in at the right corner, beside the blade; the black mark goes to the cords. Never push against "
    "resistance.<br>"
    "Heart rate below 100: out, and ventilate. Five or six breaths tell by the CO2 detector.</p>");

QString words(const char* sentence) { return QCoreApplication::translate("MouseIntroduction", sentence); }

QString blade_rules(const curricula::Assistance& helps) {
  QString text =
      "<p>" +
      (helps.force_bar
           ? QCoreApplication::translate(
                 "MouseIntroduction",
                 "A mouse cannot push back: the bars on the right show the force your blade puts on tongue and gum.")
           : QCoreApplication::translate("MouseIntroduction", "A mouse cannot push back.")) +
      "<br>" +
      QCoreApplication::translate(
          "MouseIntroduction",
          "Lift, do not lever. A solid grey blade is your hand, where the blade could not follow it.");
  if (helps.ghost_path)
    text += "<br>" + QCoreApplication::translate(
                         "MouseIntroduction", "The blade you can see through, which moves by itself, is an expert's.");
  return text + "</p>";
}

}  // namespace

MouseIntroduction::MouseIntroduction(QWidget* over)
    : QFrame(over->parentWidget() != nullptr ? over->parentWidget() : over), over_(over) {
  setObjectName("panel");
  title_ = new QLabel(this);
  title_->setObjectName("heading");
  text_ = new QLabel(this);
  text_->setTextFormat(Qt::RichText);
  text_->setWordWrap(true);                                      // a small window is narrower than the longest line
  text_->setMinimumWidth(static_cast<int>(theme::points(540)));  // larger words want longer lines, not more of them
  never_again_ = new QCheckBox(tr("Don't show this again"), this);
  auto* known = new QPushButton(tr("Got it"), this);
  never_again_->setFocusPolicy(Qt::NoFocus);  // keys are the blade's
  known->setFocusPolicy(Qt::NoFocus);
  connect(known, &QPushButton::clicked, this, &MouseIntroduction::dismiss);
  auto* foot = new QHBoxLayout;
  foot->addWidget(never_again_, 1);
  foot->addWidget(known);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 16, 20, 16);
  column->addWidget(title_);
  auto* words = new Scrolled(text_, kLeastLines, this);
  words->viewport()->setAutoFillBackground(false);  // the panel's own shows
  text_->setAutoFillBackground(false);
  column->addWidget(words, 1);
  column->addLayout(foot);
  for (QWidget* around : {over_, parentWidget()}) around->installEventFilter(this);
  hide();
}

int MouseIntroduction::high_for(int wide) const {
  const QMargins margins = layout()->contentsMargins();
  const int others = layout()->minimumSize().height() - layout()->itemAt(1)->minimumSize().height();
  return others + text_->heightForWidth(wide - margins.left() - margins.right()) + kEdge;
}

/// Over the view and the buttons below, which are grey until the start; where those are too low for its words, over
/// what is above them, and broader only where the whole page is too low.
void MouseIntroduction::place() {
  const QMargins margins = layout()->contentsMargins();
  const QRect over(over_ == parentWidget() ? QPoint() : over_->mapTo(parentWidget(), QPoint()), over_->size());
  const QRect page = parentWidget()->rect().adjusted(kEdge, kEdge, -kEdge, -kEdge);
  int wide = std::min(over.width() - 2 * kEdge, text_->minimumWidth() + margins.left() + margins.right() +
                                                    style()->pixelMetric(QStyle::PM_ScrollBarExtent));
  while (high_for(wide) > page.height() && wide < page.width()) wide = std::min(wide + kBroader, page.width());
  const int high = std::min(page.height(), high_for(wide));
  QRect place(0, 0, wide, high);
  place.moveCenter(over.center());
  place.moveBottom(std::min(place.bottom(), over.bottom() - kEdge));
  place.moveTop(std::max(place.top(), page.top()));
  place.moveLeft(std::clamp(place.left(), page.left(), std::max(page.left(), page.right() + 1 - wide)));
  setGeometry(place);
}

bool MouseIntroduction::eventFilter(QObject* watched, QEvent* event) {
  if ((event->type() == QEvent::Resize || event->type() == QEvent::Move) && !isHidden()) place();
  return QFrame::eventFilter(watched, event);
}

void MouseIntroduction::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() != QEvent::FontChange || isHidden()) return;
  text_->setMinimumWidth(static_cast<int>(theme::points(540)));
  place();
}

void MouseIntroduction::show_if_wanted(bool with_tube, const curricula::Assistance& helps) {
  with_tube_ = with_tube;
  title_->setText(with_tube ? tr("Your mouse holds the laryngoscope, then the tube")
                            : tr("Your mouse holds the laryngoscope"));
  text_->setText(
      "<table cellspacing='" + QString(with_tube ? "2" : "4") + "'>" + words(kMoves) +
      (with_tube ? words(kTube) : QString()) +
      tr("<tr><td><b>Enter, Esc, R, Z</b></td><td>start the trial, end it, begin again; change the view</td></tr>"
         "</table>"
         "<p>Enter closes this; Enter again starts the trial.</p>") +
      (with_tube ? words(kTubeRules) : blade_rules(helps)));
  setVisible(!user_settings()->value(with_tube ? kTubeKey : kKey, false).toBool());
  place();
  raise();
}

void MouseIntroduction::dismiss() {
  if (isHidden()) return;
  if (never_again_->isChecked()) user_settings()->setValue(with_tube_ ? kTubeKey : kKey, true);
  hide();
}

}  // namespace vallecula::gui

// How mouse and keyboard hold blade and tube: told on the first run, over the picture, until it is known.
#pragma once

#include <QFrame>

#include "curricula/scenario.h"

class QCheckBox;
class QLabel;

namespace vallecula::gui {

class MouseIntroduction : public QFrame {
  Q_OBJECT
 public:
  /// Lies over `over`, in its middle; where that is too low for its words, over what is above it on the same page too.
  explicit MouseIntroduction(QWidget* over);
  /// Shows it unless the user said that once was enough; `with_tube`: the second half too, which is known or not by
  /// itself. It tells of the `helps` that this trial has.
  void show_if_wanted(bool with_tube, const curricula::Assistance& helps);
  /// Goes away; with the box ticked for good.
  void dismiss();

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void place();
  int high_for(int wide) const;  ///< px, with all its words
  QWidget* over_;
  QLabel *title_, *text_;
  QCheckBox* never_again_;
  bool with_tube_ = false;
};

}  // namespace vallecula::gui

// How mouse and keyboard hold the blade: told on the first run, over the picture, until it is known.
#pragma once

#include <QFrame>

class QCheckBox;

namespace vallecula::gui {

class MouseIntroduction : public QFrame {
  Q_OBJECT
 public:
  explicit MouseIntroduction(QWidget* parent);
  /// Shows it unless the user said that once was enough.
  void show_if_wanted();
  /// Goes away; with the box ticked for good.
  void dismiss();

 private:
  QCheckBox* never_again_;
};

}  // namespace vallecula::gui

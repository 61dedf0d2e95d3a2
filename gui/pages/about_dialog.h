// What this program is, of what it is made, and under which licences.
#pragma once

#include <QDialog>

namespace vallecula::gui {

class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

}  // namespace vallecula::gui

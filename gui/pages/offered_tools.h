// Blade and tube of a scenario that leaves their choice to the trainee.
#pragma once

#include <QWidget>

#include "curricula/scenario.h"

class QComboBox;
class QLabel;

namespace vallecula::gui {

class OfferedTools : public QWidget {
  Q_OBJECT
 public:
  explicit OfferedTools(QWidget* parent = nullptr);
  /// What this scenario offers; hidden where that is nothing.
  void offer(const curricula::Scenario& scenario);
  curricula::ToolChoice taken() const;
  bool open() const;  ///< something is still to be chosen

 signals:
  void changed();

 private:
  QLabel *blade_label_, *tube_label_;
  QComboBox *blade_, *tube_;
};

}  // namespace vallecula::gui

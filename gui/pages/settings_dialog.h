// All that a person can set of the window, in one place.
#pragma once

#include <QDialog>

#include "gui/pages/look_settings.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSlider;

namespace vallecula::gui {

class SettingsDialog : public QDialog {
  Q_OBJECT
 public:
  /// What is changed is seen at once; Cancel puts back what was.
  explicit SettingsDialog(QWidget* parent = nullptr);

 signals:
  void kept();             ///< the settings are in the user's file
  void language_chosen();  ///< and after that: another language than before is among them

 protected:
  void done(int result) override;

 private:
  void add_look(QFormLayout* form);
  void add_language(QFormLayout* form);
  void add_sound(QFormLayout* form);
  void preview();
  LookSettings chosen() const;

  LookSettings before_;
  QComboBox *ground_, *trachea_, *quality_, *language_;
  QSlider *text_, *volume_;
  QLabel *text_share_, *volume_share_;
  QCheckBox* monitor_;
};

}  // namespace vallecula::gui

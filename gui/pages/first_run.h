// The first start: with what one steers, how the window looks and sounds, and the way to the first laryngoscopy.
#pragma once

#include <QDialog>
#include <vector>

#include "device/found_devices.h"
#include "gui/pages/look_settings.h"

class QButtonGroup;
class QLabel;
class QLayout;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace vallecula::gui {

/// Nothing was ever kept for this user. False as well once the first steps were gone through or skipped.
bool is_first_run();

class FirstRun : public QDialog {
  Q_OBJECT
 public:
  explicit FirstRun(QWidget* parent = nullptr);
  /// Offers those that can be used beside the mouse.
  void set_found_devices(const std::vector<device::FoundDevice>& devices);
  QString device() const;  ///< that was chosen, as `vallecula trial --device` takes it

 signals:
  void begin_wanted(const QString& device);  ///< the first laryngoscopy
  void device_chosen(const QString& device, const QString& label);
  void language_chosen(const QString& code);  ///< another than the window's: it is to be made anew, this with it

 protected:
  void done(int result) override;

 private:
  QWidget* make_step(const QString& title, const QString& text, QVBoxLayout** column);
  QWidget* make_hands();
  QWidget* make_senses();
  QWidget* make_begin();
  QLayout* make_language(QWidget* page);
  void go(int step);
  void offer(const QString& label, const QString& device);

  QStackedWidget* steps_;
  QLabel *where_, *none_found_;
  QButtonGroup* hands_;
  QVBoxLayout* hands_column_;
  QPushButton *back_, *next_;
  LookSettings look_;
};

}  // namespace vallecula::gui

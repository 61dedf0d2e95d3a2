// The instructor's station as the main window has it: its second window, the change of trainee, the device check.
#pragma once

#include <QAction>
#include <QObject>
#include <functional>
#include <memory>

#include "gui/instructor/device_check.h"
#include "gui/instructor/live_watch.h"
#include "gui/records_pages/records_desk.h"

class QMainWindow;

namespace vallecula::gui {

class InstructorWindow;
class TrialPage;

class InstructorStation : public QObject {
  Q_OBJECT
 public:
  /// Adds its actions to `window`, where their keys work, and at its own second window. All must outlive it.
  InstructorStation(QMainWindow& window, RecordsDesk& trainee, TrialPage& trial);
  ~InstructorStation() override;

  /// For menus: the second window (Ctrl+I), the next trainee (Ctrl+T).
  QAction* open_action() { return open_; }
  QAction* next_trainee_action() { return next_; }
  InstructorWindow* instructor_window() { return second_.get(); }  ///< null: was never opened

  DeviceChecks& checks() { return checks_; }
  /// Shows the check of this device. `then`: called once it is closed.
  void check_device(const QString& name, const std::function<void()>& then = {});
  /// Checks of these devices what was not checked in this session, one after the other; then goes on with `then`,
  /// whatever came of it.
  void check_before(QStringList devices, const std::function<void()>& then);
  /// Asked as the present trainee is to be signed out for another; false: something of theirs is to be finished first.
  void set_may_change(std::function<bool()> may_change) { may_change_ = std::move(may_change); }
  /// Instead of the devices there are.
  void set_device_maker(DeviceCheck::Maker maker) { maker_ = std::move(maker); }

 signals:
  void next_trainee_begins();         ///< the one before is signed out; whatever was open of theirs is to be left
  void new_trainee_wanted();          ///< nobody is signed in: somebody is to be registered
  void told(const QString& message);  ///< why something was not done

 private:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void open();
  void show_second(const curricula::Who& who, const curricula::Person& person);
  void change_trainee();
  bool may_change();

  QMainWindow& window_;
  RecordsDesk& trainee_;
  TrialPage& trial_;
  QAction *open_, *next_;
  std::unique_ptr<InstructorWindow> second_;
  DeviceChecks checks_;
  DeviceCheck::Maker maker_;
  std::function<bool()> may_change_;
  LiveWatch watch_;        ///< from the first trial on, whoever looks
  long long watched_ = 0;  ///< whose the trial was that was opened last, by the records; 0: nobody's
};

}  // namespace vallecula::gui

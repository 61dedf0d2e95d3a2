// The check of a device before a session, shown step by step.
#pragma once

#include <QDialog>
#include <QPointer>
#include <QThread>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>

#include "gui/instructor/check_run.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace vallecula::device {
class MouseDevice;
}

namespace vallecula::gui {

class ReachPad;

class DeviceCheck : public QDialog {
  Q_OBJECT
 public:
  using Maker = std::function<std::unique_ptr<device::HapticDevice>()>;
  /// `name` as make_device takes it; `make` opens the device, on a thread of its own, once now and
  /// once for every further check. `random`: 0 or 1, the sign of each push.
  DeviceCheck(const QString& name, Maker make, QWidget* parent = nullptr, std::function<int()> random = {});
  ~DeviceCheck() override;
  /// Closed, the device is free: a trial may open it at once.
  void done(int result) override;

 signals:
  /// All that can be told is told; comes again after another check.
  void checked(const vallecula::gui::CheckResult& result);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* make_lines();
  QWidget* make_answers();
  void begin();
  void look();
  void show_run();
  void show_lines(const std::array<CheckLine, kCheckSteps>& lines);
  void release();
  void end(const std::array<CheckLine, kCheckSteps>& lines);
  bool move_by_key(int key, bool finely);

  const QString name_;
  const Maker make_;
  std::function<int()> random_;
  QPointer<QThread> opener_;
  bool opening_ = false, closing_ = false;
  std::unique_ptr<DeviceProbe> probe_;
  std::unique_ptr<CheckRun> run_;
  device::MouseDevice* mouse_ = nullptr;  ///< the probe's, where it is one
  QTimer clock_;
  std::array<QLabel*, kCheckSteps> marks_{}, words_{};
  ReachPad* pad_;
  QLabel *title_, *ask_;
  QWidget* answers_;
  QPushButton *push_, *cannot_, *centre_, *again_, *close_;
};

/// Of this session, which ends with the program: what was checked, and when.
class DeviceChecks {
  Q_DECLARE_TR_FUNCTIONS(vallecula::gui::DeviceChecks)
 public:
  void keep(const CheckResult& result) { kept_[result.device] = result; }
  const CheckResult* find(const QString& device) const;
  /// Whether it is to be checked before a trial: hardware that was not, in this session.
  bool due(const QString& device) const;
  /// "Device checked 12 minutes ago", with what was not as it should be; of the mouse and of scripts nothing.
  QString words(const QString& device, const QDateTime& now = QDateTime::currentDateTime()) const;

 private:
  std::map<QString, CheckResult> kept_;
};

}  // namespace vallecula::gui

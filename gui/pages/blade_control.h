// Mouse and keyboard in the window -> the mouse device. Drag, wheel and held keys, all in the axes of the picture.
#pragma once

#include <QObject>
#include <QPoint>
#include <set>
#include <vector>

#include "device/drivers/mouse_device.h"
#include "gui/pages/key_list.h"
#include "gui/session/held_tools.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace vallecula::gui {

class OperatorView;

class BladeControl : public QObject {
  Q_OBJECT
 public:
  explicit BladeControl(OperatorView* view);
  /// nullptr: nothing is steered. The device must outlive its use here.
  void steer(device::MouseDevice* device);
  bool steering() const { return device_ != nullptr; }
  /// What the device holds: a tube is not lifted (Space is then another's), and turns about its length.
  void set_tool(Tool tool);
  /// Moves what held keys move; to be called once a frame with the time since the last one.
  void advance(double seconds);
  /// The force on the blade as the window shows it, and the device limit, N; the lift follows it. Once a frame: the
  /// lift stops where it is not told again.
  void feel(double force_n, double device_limit_n);
  /// True when the key is one of the blade's.
  bool key(QKeyEvent* event, bool pressed);
  void release_all();
  /// Way of the blade over way of the mouse; also of keys and wheel.
  void set_gain(double gain) { gain_ = gain; }
  /// With this tool in the hand; nobody's: none.
  std::vector<KeyRow> keys() const;
  /// One line for the screen.
  QString help() const;

 signals:
  /// By a key (+ and -).
  void gain_changed(double gain);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  OperatorView* view_;
  device::MouseDevice* device_ = nullptr;
  QPoint last_;
  Tool tool_ = Tool::blade;
  double gain_ = 1.0;
  std::set<int> held_;
};

}  // namespace vallecula::gui

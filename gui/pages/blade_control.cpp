#include "gui/pages/blade_control.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>

#include "gui/session/user_settings.h"
#include "gui/session/words_from_below.h"
#include "gui/views/operator_view.h"

namespace vallecula::gui {
namespace {

constexpr double kTurnPerPixel = 0.004;      // rad: a drag across a quarter of the view turns about 45 degrees
constexpr double kAdvancePerNotch = 0.0015;  // m
constexpr double kKeySpeed = 0.030;          // m/s while a key is held
constexpr double kFineShare = 0.25;          // with Shift
constexpr double kKeyTurn = 0.6;             // rad/s
constexpr double kGainStep = 1.25;

/// The keys of a movement, and back.
struct Keys {
  int there, back;
  bool of_blade_alone;
  const char* what;
};
constexpr Keys kKeys[] = {
    {Qt::Key_Right, Qt::Key_Left, false,
     QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "move it to the right and left")},
    {Qt::Key_Up, Qt::Key_Down, false,
     QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "move it up and down in the picture")},
    {Qt::Key_PageUp, Qt::Key_PageDown, false, QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "deeper, back")},
    {Qt::Key_W, Qt::Key_S, false, QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "raise and lower its outer end")},
    {Qt::Key_A, Qt::Key_D, false, QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "turn it to the left and right")},
    {Qt::Key_Q, Qt::Key_E, false, QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "roll it about its length")},
    {Qt::Key_Space, Qt::Key_Backspace, true,
     QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "held: lift along the handle, lower")},
    {Qt::Key_Plus, Qt::Key_Minus, false,
     QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "farther, and less far, for the same way of the hand")},
    {Qt::Key_Shift, 0, false, QT_TRANSLATE_NOOP("vallecula::gui::BladeControl", "held: all of it finer")}};

std::array<double, 3> plain(const engine::Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

BladeControl::BladeControl(OperatorView* view) : QObject(view), view_(view) { view->installEventFilter(this); }

void BladeControl::steer(device::MouseDevice* device) {
  release_all();
  device_ = device;
  if (device_ == nullptr) return;
  const engine::Vec3 right = view_->screen_right(), up = view_->screen_up();
  device_->set_view_axes(plain(right), plain(up), plain(up.cross(right)));
}

void BladeControl::set_tool(Tool tool) {
  release_all();
  tool_ = tool;
}

void BladeControl::release_all() {
  held_.clear();
  if (device_ != nullptr) device_->set_lift(0.0);
}

bool BladeControl::key(QKeyEvent* event, bool pressed) {
  const bool more = event->key() == Qt::Key_Plus, less = event->key() == Qt::Key_Minus;
  if (more || less) {
    if (pressed) {
      gain_ = std::clamp(gain_ * (more ? kGainStep : 1.0 / kGainStep), kLeastMouseGain, kMostMouseGain);
      emit gain_changed(gain_);
    }
    return true;
  }
  const auto* mine = std::find_if(std::begin(kKeys), std::end(kKeys), [&](const Keys& keys) {
    return event->key() == keys.there || event->key() == keys.back;
  });
  if (mine == std::end(kKeys) || (mine->of_blade_alone && tool_ == Tool::tube)) return false;
  if (event->isAutoRepeat()) return true;
  if (pressed)
    held_.insert(event->key());
  else
    held_.erase(event->key());
  if (device_ != nullptr)
    device_->set_lift((held_.count(Qt::Key_Space) ? 1.0 : 0.0) - (held_.count(Qt::Key_Backspace) ? 1.0 : 0.0));
  return event->key() != Qt::Key_Shift;
}

void BladeControl::feel(double force_n, double device_limit_n) {
  if (device_ != nullptr) device_->feel(force_n, device_limit_n);
}

void BladeControl::advance(double seconds) {
  if (device_ == nullptr || held_.empty()) return;
  const auto axis = [&](int plus, int minus) {
    return (held_.count(plus) ? 1.0 : 0.0) - (held_.count(minus) ? 1.0 : 0.0);
  };
  const double share = gain_ * seconds * (held_.count(Qt::Key_Shift) ? kFineShare : 1.0), way = kKeySpeed * share,
               turn = kKeyTurn * share;
  device_->move(way * axis(Qt::Key_Right, Qt::Key_Left), way * axis(Qt::Key_Up, Qt::Key_Down));
  device_->advance(way * axis(Qt::Key_PageUp, Qt::Key_PageDown));
  // W raises the handle's end: about the tool's +y that is a negative pitch.
  const double pitch = turn * axis(Qt::Key_S, Qt::Key_W), yaw = turn * axis(Qt::Key_D, Qt::Key_A),
               roll = turn * axis(Qt::Key_E, Qt::Key_Q);
  if (pitch != 0.0 || yaw != 0.0 || roll != 0.0) device_->turn(pitch, yaw, roll);
}

std::vector<KeyRow> BladeControl::keys() const {
  if (device_ == nullptr) return {};
  std::vector<KeyRow> rows;
  for (const Keys& keys : kKeys)
    if (!keys.of_blade_alone || tool_ == Tool::blade)
      rows.push_back(
          {keys.back == 0 ? key_name(keys.there) : tr("%1, %2").arg(key_name(keys.there), key_name(keys.back)),
           tr(keys.what)});
  return rows;
}

QString BladeControl::help() const {
  if (tool_ == Tool::tube)
    return QString(tr("Drag: move the tube   |   wheel or PgUp PgDn: in, out   |   Q E: turn it about its length   |   "
                      "Ctrl-drag, right-drag or W A S D: tilt it   |   Shift: fine   |   + -: gain, now %1"))
        .arg(short_decimal(gain_, 3));
  return QString(
             tr("Drag: move the blade   |   Ctrl-drag, right-drag or W A S D: turn it (Q E: roll)   |   wheel or PgUp "
                "PgDn: "
                "deeper, back   |   arrows: move (Shift: fine)   |   hold Space: lift along the handle, Backspace: "
                "lower  "
                " |  "
                " + -: gain, now %1"))
      .arg(short_decimal(gain_, 3));
}

bool BladeControl::eventFilter(QObject*, QEvent* event) {
  if (device_ == nullptr) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      last_ = static_cast<QMouseEvent*>(event)->pos();
      return true;
    case QEvent::MouseMove: {
      auto* mouse = static_cast<QMouseEvent*>(event);
      const QPoint moved = mouse->pos() - last_;
      last_ = mouse->pos();
      const double fine = gain_ * (mouse->modifiers() & Qt::ShiftModifier ? kFineShare : 1.0);
      const bool turns = (mouse->buttons() & Qt::RightButton) || (mouse->modifiers() & Qt::ControlModifier);
      if ((mouse->buttons() & Qt::LeftButton) && !turns) {
        const double metres = fine * 1e-3 * view_->mm_per_pixel();
        device_->move(metres * moved.x(), -metres * moved.y());
      } else if (mouse->buttons() & (Qt::LeftButton | Qt::RightButton)) {
        device_->turn(fine * kTurnPerPixel * moved.y(), fine * kTurnPerPixel * moved.x(), 0.0);
      }
      return true;
    }
    case QEvent::Wheel: {
      auto* wheel = static_cast<QWheelEvent*>(event);
      const double fine = gain_ * (wheel->modifiers() & Qt::ShiftModifier ? kFineShare : 1.0);
      device_->advance(fine * kAdvancePerNotch * wheel->angleDelta().y() / 120.0);
      return true;
    }
    default:
      return false;
  }
}

}  // namespace vallecula::gui

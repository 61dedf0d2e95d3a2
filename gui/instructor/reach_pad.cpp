#include "gui/instructor/reach_pad.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>

#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kDepthWidth = 46.0, kGap = 16.0, kMargin = 20.0;
constexpr double kWheelStepM = 0.005;  ///< a notch of the wheel

}  // namespace

ReachPad::ReachPad(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Where the blade's tip is"));
  setToolTip(
      tr("The blade's tip as the operator sees it, and its depth (mm). With the mouse: drag here, the wheel goes "
         "deeper."));
}

void ReachPad::show_tip(const std::array<double, 3>& tip_m, const std::array<bool, kReachMarks>& reached,
                        bool asked_for) {
  tip_m_ = tip_m;
  reached_ = reached;
  asked_for_ = asked_for;
  update();
}

QRectF ReachPad::plane() const {
  const double side = std::max(40.0, std::min(width() - kDepthWidth - kGap - 2.0, height() - 2.0 * kMargin));
  return {0.5 * (width() - side - kGap - kDepthWidth), 0.5 * (height() - side), side, side};
}

void ReachPad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF square = plane();
  const QRectF depth(square.right() + kGap, square.top(), kDepthWidth, square.height());
  const double scale = pixels_per_m();
  painter.setPen(QPen(theme::faint(), 1));
  painter.setBrush(theme::track());
  painter.drawRoundedRect(square, 4, 4);
  painter.drawRoundedRect(depth, 4, 4);
  const QPointF middle = square.center();
  const double half[3] = {0.5 * kMouthReachM[0] * scale, 0.5 * kMouthReachM[1] * scale, 0.5 * kMouthReachM[2] * scale};
  const auto mark_pen = [&](ReachMark mark) {
    const bool done = reached_[static_cast<std::size_t>(mark)];
    return QPen(done ? theme::within() : asked_for_ ? theme::target() : theme::faint(), done ? 4.0 : 2.5);
  };
  const struct {
    ReachMark mark;
    double x, y;
  } corners[] = {{kTopLeft, -1, -1}, {kTopRight, 1, -1}, {kBottomLeft, -1, 1}, {kBottomRight, 1, 1}};
  constexpr double kLeg = 13.0;
  for (const auto& corner : corners) {
    const QPointF at = middle + QPointF(corner.x * half[0], corner.y * half[1]);
    painter.setPen(mark_pen(corner.mark));
    painter.drawLine(at, at - QPointF(corner.x * kLeg, 0));
    painter.drawLine(at, at - QPointF(0, corner.y * kLeg));
  }
  for (const auto& [mark, y] : {std::pair(kFar, -1.0), std::pair(kNear, 1.0)}) {
    painter.setPen(mark_pen(mark));
    const double at = depth.center().y() + y * half[2];
    painter.drawLine(QPointF(depth.left() + 6, at), QPointF(depth.right() - 6, at));
  }
  painter.setPen(theme::text());
  const QRectF over(depth.left() - 20, depth.top() - kMargin, depth.width() + 40, kMargin - 2);
  painter.drawText(over, Qt::AlignCenter, tr("far"));
  painter.drawText(over.translated(0, depth.height() + kMargin), Qt::AlignCenter, tr("near"));
  const auto inside = [](double value, double low, double high) { return std::clamp(value, low + 7.0, high - 7.0); };
  painter.setPen(QPen(theme::text(), 1.5));
  painter.setBrush(theme::device());
  painter.drawEllipse(QPointF(inside(middle.x() + tip_m_[0] * scale, square.left(), square.right()),
                              inside(middle.y() - tip_m_[1] * scale, square.top(), square.bottom())),
                      7, 7);
  painter.drawEllipse(
      QPointF(depth.center().x(), inside(depth.center().y() + tip_m_[2] * scale, depth.top(), depth.bottom())), 7, 7);
}

void ReachPad::mousePressEvent(QMouseEvent* event) { last_ = event->pos(); }

void ReachPad::mouseMoveEvent(QMouseEvent* event) {
  const QPoint way = event->pos() - last_;
  last_ = event->pos();
  emit dragged(way.x() / pixels_per_m(), -way.y() / pixels_per_m());
}

void ReachPad::wheelEvent(QWheelEvent* event) {
  emit wheeled(kWheelStepM * event->angleDelta().y() / 120.0);
  event->accept();
}

}  // namespace vallecula::gui

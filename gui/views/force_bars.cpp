#include "gui/views/force_bars.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/views/theme.h"

namespace vallecula::gui {

ForceBars::ForceBars(QWidget* parent) : QWidget(parent) {
  setAccessibleName("Force on the tongue and on the gum");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void ForceBars::set_marks(const ForceMarks& marks) {
  tongue_.target = marks.tongue_target_n;
  gum_.target = marks.gum_target_n;
  device_limit_ = marks.device_limit_n;
  scale_ = std::max(1.0, std::ceil(1.2 * std::max({device_limit_, tongue_.target, gum_.target})));
  clear();
}

void ForceBars::show_forces(double tongue_n, double gum_n) {
  tongue_.now = tongue_n;
  tongue_.peak = std::max(tongue_.peak, tongue_n);
  gum_.now = gum_n;
  gum_.peak = std::max(gum_.peak, gum_n);
  setAccessibleDescription(QString("tongue %1 N, gum %2 N").arg(tongue_n, 0, 'f', 1).arg(gum_n, 0, 'f', 1));
  update();
}

void ForceBars::clear() {
  tongue_.now = tongue_.peak = gum_.now = gum_.peak = 0.0;
  update();
}

void ForceBars::paint_bar(QPainter& painter, const QRectF& place, const QString& name, const Bar& bar,
                          bool with_limit) const {
  const double label = 64.0, figures = 72.0;
  const QRectF track(place.left() + label, place.top() + 16.0, place.width() - label - figures, place.height() - 22.0);
  const auto at = [&](double newton) { return track.left() + track.width() * std::clamp(newton / scale_, 0.0, 1.0); };
  QFont font = painter.font();
  font.setPointSizeF(10.5);
  painter.setFont(font);
  painter.setPen(theme::text());
  painter.drawText(QRectF(place.left(), track.top(), label - 8.0, track.height()), Qt::AlignVCenter | Qt::AlignLeft,
                   name);

  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::track());
  painter.drawRoundedRect(track, 4, 4);
  if (with_limit && device_limit_ > 0.0) {
    const QRectF beyond(at(device_limit_), track.top(), track.right() - at(device_limit_), track.height());
    painter.setBrush(QBrush(QColor(190, 190, 200, 90), Qt::BDiagPattern));
    painter.drawRect(beyond);
  }
  const bool over = bar.target > 0.0 && bar.now > bar.target;
  painter.setBrush(over ? theme::over() : theme::within());
  const QRectF filled(track.left(), track.top(), at(bar.now) - track.left(), track.height());
  if (filled.width() > 0.5) painter.drawRoundedRect(filled, 3, 3);

  font.setPointSizeF(8.0);
  painter.setFont(font);
  // In a narrow window the two labels stand away from each other.
  const bool crowded = with_limit && device_limit_ > 0.0 && std::abs(at(device_limit_) - at(bar.target)) < 84.0;
  const auto mark = [&](double newton, const QColor& colour, const QString& text, Qt::PenStyle style, double aside) {
    painter.setPen(QPen(colour, 2.0, style));
    painter.drawLine(QPointF(at(newton), track.top() - 3.0), QPointF(at(newton), track.bottom() + 3.0));
    painter.setPen(colour);
    painter.drawText(QRectF(at(newton) - 70.0 + (crowded ? aside : 0.0), place.top() - 1.0, 140.0, 13.0),
                     Qt::AlignCenter, text);
  };
  if (bar.target > 0.0)
    mark(bar.target, theme::target(), QString("target %1").arg(bar.target, 0, 'f', 1), Qt::SolidLine, -24.0);
  if (with_limit && device_limit_ > 0.0)
    mark(device_limit_, theme::device(), QString("device limit %1").arg(device_limit_, 0, 'f', 1), Qt::DashLine, 30.0);
  if (bar.peak > 0.05) {
    painter.setPen(QPen(theme::text(), 1.5));
    painter.drawLine(QPointF(at(bar.peak), track.top()), QPointF(at(bar.peak), track.bottom()));
  }
  font.setPointSizeF(13.0);
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(over ? theme::over() : theme::text());
  painter.drawText(QRectF(track.right() + 8.0, track.top() - 3.0, figures - 8.0, track.height() * 0.62),
                   Qt::AlignVCenter | Qt::AlignLeft, QString("%1 N").arg(bar.now, 0, 'f', 1));
  font.setPointSizeF(8.0);
  font.setBold(false);
  painter.setFont(font);
  painter.setPen(theme::faint());
  painter.drawText(
      QRectF(track.right() + 8.0, track.top() + track.height() * 0.55, figures - 8.0, track.height() * 0.5),
      Qt::AlignVCenter | Qt::AlignLeft, QString("peak %1").arg(bar.peak, 0, 'f', 1));
}

void ForceBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double half = 0.5 * height();
  paint_bar(painter, QRectF(0, 2, width(), half - 4), "Tongue", tongue_, true);
  paint_bar(painter, QRectF(0, half + 2, width(), half - 4), "Gum", gum_, false);
}

}  // namespace vallecula::gui

#include "gui/report/curve_chart.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "curricula/progress/cusum.h"
#include "gui/report/chart_panel.h"

namespace vallecula::gui {
namespace {

/// Trials along, a value up; it may be below 0.
struct Frame {
  QPainter& painter;
  QRectF box;
  double trials, low, high, em;

  double x(double trial) const { return box.left() + box.width() * (trial - 0.5) / trials; }
  double y(double value) const { return box.bottom() - box.height() * (value - low) / (high - low); }

  void axes(const QString& title, int digits) {
    painter.setPen(QPen(chart::kGrey, 0.08 * em));
    painter.drawRect(box);
    painter.setPen(chart::kInk);
    painter.drawText(QRectF(box.left(), box.top() - 1.8 * em, box.width(), 1.5 * em), Qt::AlignLeft, title);
    constexpr int kSteps = 4;
    for (int i = 0; i <= kSteps; ++i) {
      const double value = low + (high - low) * i / kSteps;
      painter.drawText(QRectF(box.left() - 5.2 * em, y(value) - 0.8 * em, 4.8 * em, 1.6 * em),
                       Qt::AlignRight | Qt::AlignVCenter, chart::number(value, digits));
    }
    const int step = std::max(1, static_cast<int>(std::ceil(trials / 10.0)));
    for (int trial = 1; trial <= static_cast<int>(trials); trial += step)
      painter.drawText(QRectF(x(trial) - 2 * em, box.bottom() + 0.2 * em, 4 * em, 1.5 * em), Qt::AlignHCenter,
                       QString::number(trial));
    painter.drawText(QRectF(box.left(), box.bottom() + 1.5 * em, box.width(), 1.6 * em), Qt::AlignRight,
                     QCoreApplication::translate("Charts", "trial"));
  }
  void level(double value, const QColor& colour, const QString& text) {
    painter.setPen(QPen(colour, 0.12 * em, Qt::DashLine));
    painter.drawLine(QPointF(box.left(), y(value)), QPointF(box.right(), y(value)));
    painter.setPen(colour.darker(140));
    painter.drawText(QRectF(box.left(), y(value) - 1.5 * em, box.width() - 0.4 * em, 1.4 * em), Qt::AlignRight, text);
  }
};

}  // namespace

QImage draw_curve_chart(const std::vector<curricula::RecordRow>& trials, const CurveReading& reading, int width,
                        int height) {
  std::vector<const curricula::RecordRow*> whole;
  double highest = 1.0;
  for (const curricula::RecordRow& row : trials) {
    if (!row.score.counts()) continue;
    whole.push_back(&row);
    highest = std::max(highest, row.score.peak_tongue_force_n);
  }
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  const double em = width / 84.0, count = static_cast<double>(whole.size());
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(em)));
  painter.setFont(font);
  const double half = width / 2.0;
  const auto box = [&](double left) {
    return QRectF(left + 6.0 * em, 2.4 * em, half - 8.0 * em, height - 2.4 * em - 3.6 * em);
  };

  Frame force{painter, box(0.0), count, 0.0, std::ceil(1.15 * highest), em};
  force.axes(QCoreApplication::translate("Charts", "peak force on the tongue (N); \u25cf passed, \u25cb not"), 1);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const QPointF at(force.x(static_cast<double>(i) + 1.0), force.y(whole[i]->score.peak_tongue_force_n));
    const bool success = succeeded(*whole[i], reading);
    const QColor colour = success ? chart::kGreen : chart::kVermillion;
    painter.setPen(QPen(colour, 0.18 * em));
    painter.setBrush(success ? QBrush(colour) : QBrush(Qt::white));
    painter.drawEllipse(at, 0.4 * em, 0.4 * em);
  }
  painter.setBrush(Qt::NoBrush);

  const curricula::CusumLines lines = curricula::cusum_lines(reading.rule);
  const auto& sums = reading.cusum;
  double low = lines.lower, high = lines.upper;
  for (const curricula::CusumPoint& point : sums) {
    low = std::min(low, point.sum);
    high = std::max(high, point.sum);
  }
  const double room = 0.12 * (high - low);
  const double counted = std::max(1.0, static_cast<double>(sums.size()));  // practice may count in nothing
  Frame cusum{painter, box(half), counted, low - room, high + room, em};
  cusum.axes(QCoreApplication::translate("Charts", "cumulative sum; down is success"), 1);
  cusum.level(lines.lower, chart::kGreen, QCoreApplication::translate("Charts", "competent"));
  cusum.level(lines.upper, chart::kVermillion, QCoreApplication::translate("Charts", "deficient"));
  QPainterPath path;
  bool anew = true;  // a verdict ends a test, and the next begins at 0
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double trial = static_cast<double>(i) + 1.0;
    if (anew) path.moveTo(cusum.x(trial - 0.5), cusum.y(0.0));
    path.lineTo(cusum.x(trial), cusum.y(sums[i].sum));
    anew = sums[i].verdict != curricula::CusumVerdict::undecided;
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(chart::kBlue, 0.2 * em));
  painter.drawPath(path);
  painter.setBrush(chart::kBlue);
  for (std::size_t i = 0; i < sums.size(); ++i)
    painter.drawEllipse(QPointF(cusum.x(static_cast<double>(i) + 1.0), cusum.y(sums[i].sum)), 0.25 * em, 0.25 * em);
  return image;
}

}  // namespace vallecula::gui

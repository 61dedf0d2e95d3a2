#include "gui/report/force_chart.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "gui/session/files.h"

namespace vallecula::gui {

namespace {

const QColor kTongue(0x00, 0x72, 0xB2);  // blue
const QColor kGum(0xD5, 0x5E, 0x00);     // vermillion
const QColor kDisplayed(0x55, 0x55, 0x55);
const QColor kTarget(0x00, 0x9E, 0x73);  // bluish green
const QColor kLimit(0xCC, 0x79, 0xA7);   // reddish purple
const QColor kSight(0x56, 0xB4, 0xE9);   // sky blue
const QColor kInk(0x22, 0x22, 0x22);
const QColor kGrid(0xE3, 0xE3, 0xE3);
const QColor kPause(0xD0, 0xD0, 0xD0);

struct Series {
  std::vector<double> time_s, value;
};

double length(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// 1, 2 or 5 times a power of ten: about `count` steps in `span`.
double tick_step(double span, int count) {
  const double raw = span / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw * 0.999) return factor * power;
  }
  return 10.0 * power;
}

/// One panel: data to pixels, axes, lines. All lengths in units of `em`, the height of the chart's letters.
class Panel {
 public:
  Panel(QPainter& painter, const QRectF& frame, double end_s, double top, double em)
      : painter_(painter), frame_(frame), end_s_(end_s), top_(top), em_(em) {}

  double x(double time_s) const { return frame_.left() + frame_.width() * time_s / end_s_; }
  double y(double value) const { return frame_.bottom() - frame_.height() * std::clamp(value / top_, 0.0, 1.0); }
  const QRectF& frame() const { return frame_; }

  void axes(const QString& title, int value_ticks, bool times) {
    const double value_step = tick_step(top_, value_ticks);
    const double time_step = tick_step(end_s_, 12);
    painter_.setPen(QPen(kGrid, em_ * 0.06));
    for (double v = value_step; v <= top_ * 1.0001; v += value_step) {
      painter_.drawLine(QPointF(frame_.left(), y(v)), QPointF(frame_.right(), y(v)));
    }
    for (double t = time_step; t <= end_s_ * 1.0001; t += time_step) {
      painter_.drawLine(QPointF(x(t), frame_.top()), QPointF(x(t), frame_.bottom()));
    }
    painter_.setPen(QPen(kInk, em_ * 0.09));
    painter_.drawLine(frame_.bottomLeft(), frame_.bottomRight());
    painter_.drawLine(frame_.bottomLeft(), frame_.topLeft());
    for (double v = 0.0; v <= top_ * 1.0001; v += value_step) {
      painter_.drawText(QRectF(frame_.left() - 5.5 * em_, y(v) - em_, 5.0 * em_, 2.0 * em_),
                        Qt::AlignRight | Qt::AlignVCenter, QString::number(v));
    }
    if (times) {
      for (double t = 0.0; t <= end_s_ * 1.0001; t += time_step) {
        painter_.drawText(QRectF(x(t) - 3.0 * em_, frame_.bottom() + 0.25 * em_, 6.0 * em_, 1.5 * em_),
                          Qt::AlignHCenter | Qt::AlignTop, QString::number(t));
      }
      painter_.drawText(QRectF(frame_.left(), frame_.bottom() + 1.7 * em_, frame_.width(), 1.6 * em_),
                        Qt::AlignHCenter | Qt::AlignTop, QStringLiteral("time since the trial began (s)"));
    }
    painter_.save();
    painter_.translate(frame_.left() - 5.2 * em_, frame_.center().y());
    painter_.rotate(-90.0);
    painter_.drawText(QRectF(-frame_.height(), -em_, 2.0 * frame_.height(), 2.0 * em_), Qt::AlignCenter, title);
    painter_.restore();
  }

  /// Thousands of ticks on hundreds of pixels: every column shows its smallest and largest value, so no peak is lost.
  void line(const Series& series, const QPen& pen) {
    QPainterPath path;
    std::size_t first = 0;
    while (first < series.time_s.size()) {
      const double column = std::floor(x(series.time_s[first]));
      std::size_t low = first, high = first, last = first;
      while (last + 1 < series.time_s.size() && std::floor(x(series.time_s[last + 1])) == column) {
        ++last;
        if (series.value[last] < series.value[low]) low = last;
        if (series.value[last] > series.value[high]) high = last;
      }
      for (const std::size_t i : {first, std::min(low, high), std::max(low, high), last}) {
        const QPointF point(x(series.time_s[i]), y(series.value[i]));
        path.elementCount() == 0 ? path.moveTo(point) : path.lineTo(point);
      }
      first = last + 1;
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(pen);
    painter_.drawPath(path);
  }

  void level(double value, const QColor& colour, Qt::PenStyle style, const QString& text, bool text_above) {
    painter_.setPen(QPen(colour.darker(110), em_ * 0.13, style));
    painter_.drawLine(QPointF(frame_.left(), y(value)), QPointF(frame_.right(), y(value)));
    const double top = text_above ? y(value) - 1.45 * em_ : y(value) + 0.1 * em_;
    label(QRectF(frame_.left(), top, frame_.width() - 0.4 * em_, 1.4 * em_), true, colour.darker(150), text);
  }

  void moment(double time_s, const QColor& colour, const QString& text) {
    painter_.setPen(QPen(colour.darker(120), em_ * 0.13, Qt::DashDotLine));
    painter_.drawLine(QPointF(x(time_s), frame_.top()), QPointF(x(time_s), frame_.bottom()));
    if (text.isEmpty()) return;
    const bool left = x(time_s) > frame_.center().x() + frame_.width() * 0.2;
    const double width = 20.0 * em_;
    const QRectF box(left ? x(time_s) - width - 0.4 * em_ : x(time_s) + 0.4 * em_, frame_.top() + 0.1 * em_, width,
                     1.4 * em_);
    label(box, left, colour.darker(170), text);
  }

  /// Covers what was drawn there: nothing of it is the hand's doing.
  void pause(double from_s, double to_s, const QString& text) {
    const QRectF box(x(from_s), frame_.top(), x(to_s) - x(from_s), frame_.height());
    painter_.fillRect(box, kPause);
    if (painter_.fontMetrics().horizontalAdvance(text) > box.width()) return;
    painter_.setPen(kInk);
    painter_.drawText(box, Qt::AlignCenter, text);
  }

  void peak(double time_s, double value, const QColor& colour, const QString& text) {
    const QPointF at(x(time_s), y(value));
    painter_.setPen(QPen(Qt::white, em_ * 0.15));
    painter_.setBrush(colour);
    painter_.drawEllipse(at, em_ * 0.38, em_ * 0.38);
    const bool left = at.x() > frame_.center().x() + frame_.width() * 0.2;
    const double width = 18.0 * em_;
    label(QRectF(left ? at.x() - width - 0.6 * em_ : at.x() + 0.6 * em_, at.y() - 1.6 * em_, width, 1.4 * em_), left,
          colour.darker(130), text);
  }

 private:
  /// Text on a light ground, so that lines below it do not strike it through.
  void label(const QRectF& box, bool right_aligned, const QColor& colour, const QString& text) {
    const Qt::Alignment alignment = (right_aligned ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
    const QRectF tight = painter_.boundingRect(box, alignment, text);
    painter_.fillRect(tight.adjusted(-0.15 * em_, 0, 0.15 * em_, 0), QColor(255, 255, 255, 215));
    painter_.setPen(colour);
    painter_.drawText(box, alignment, text);
  }

  QPainter& painter_;
  QRectF frame_;
  double end_s_, top_, em_;
};

QString number(double value, int digits) { return QString::number(value, 'f', digits); }

void draw_legend(QPainter& painter, const QRectF& row, double em) {
  struct Entry {
    QString text;
    QPen pen;
  };
  const std::vector<Entry> entries = {{QStringLiteral("tongue"), QPen(kTongue, em * 0.18)},
                                      {QStringLiteral("gum"), QPen(kGum, em * 0.18)},
                                      {QStringLiteral("shown by the device"), QPen(kDisplayed, em * 0.1, Qt::DotLine)}};
  double x = row.left();
  for (const Entry& entry : entries) {
    painter.setPen(entry.pen);
    painter.drawLine(QPointF(x, row.center().y()), QPointF(x + 2.2 * em, row.center().y()));
    painter.setPen(kInk);
    const double width = painter.fontMetrics().horizontalAdvance(entry.text);
    painter.drawText(QRectF(x + 2.7 * em, row.top(), width + em, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     entry.text);
    x += 2.7 * em + width + 2.0 * em;
  }
}

}  // namespace

QImage draw_force_chart(const curricula::TrialLog& log, const curricula::Scenario& scenario,
                        const curricula::Score& score, int width, int height) {
  if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr) {
    throw std::logic_error("a chart needs a QGuiApplication for its fonts");
  }
  Series tongue, gum, displayed, sight;
  double highest = std::max(log.header.device_limit_n, scenario.targets.tongue_force_n);
  double end_s = 1.0;
  for (const curricula::LogTick& tick : log.ticks) {
    const double forces[] = {length(tick.loads[curricula::kTongue].force_n),
                             length(tick.loads[curricula::kGum].force_n), length(tick.displayed_force_n)};
    Series* const lines[] = {&tongue, &gum, &displayed};
    for (int i = 0; i < 3; ++i) {
      lines[i]->time_s.push_back(tick.time_s);
      lines[i]->value.push_back(forces[i]);
      highest = std::max(highest, forces[i]);
    }
    if (tick.has_sight) {
      sight.time_s.push_back(tick.time_s);
      sight.value.push_back(100.0 * tick.glottis_visible);
    }
    end_s = std::max(end_s, tick.time_s);
  }

  QImage image(width, height, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  const double em = std::max(10.0, std::min(width / 80.0, height / 45.0));
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(em)));
  painter.setFont(font);

  const double left = 7.0 * em, right = width - 1.5 * em;
  const double sight_height = height * 0.16;
  const QRectF force_frame(left, 4.6 * em, right - left, height - 4.6 * em - sight_height - 5.8 * em);
  const QRectF sight_frame(left, force_frame.bottom() + 1.6 * em, right - left, sight_height);

  QFont bold = font;
  bold.setBold(true);
  bold.setPixelSize(static_cast<int>(std::lround(1.2 * em)));
  painter.setFont(bold);
  painter.setPen(kInk);
  painter.drawText(QRectF(left, 0.6 * em, right - left, 1.8 * em), Qt::AlignLeft | Qt::AlignVCenter,
                   QStringLiteral("Force over time: ") + QString::fromStdString(scenario.title));
  painter.setFont(font);
  draw_legend(painter, QRectF(left, 2.6 * em, right - left, 1.4 * em), em);

  Panel force(painter, force_frame, end_s, highest * 1.15, em);
  Panel view(painter, sight_frame, end_s, 100.0, em);
  const auto attempt = [&](const Panel& panel) {
    if (score.attempt_time_s <= 0.0) return;
    const double from = panel.x(score.attempt_start_s);
    const double to = panel.x(score.attempt_start_s + score.attempt_time_s + score.attempt_paused_s);
    painter.fillRect(QRectF(from, panel.frame().top(), to - from, panel.frame().height()), QColor(0xF6, 0xF4, 0xEC));
  };
  attempt(force);
  attempt(view);
  force.axes(QStringLiteral("force (N)"), 8, false);
  view.axes(QStringLiteral("glottis seen (%)"), 2, true);

  force.line(gum, QPen(kGum, em * 0.16));
  force.line(tongue, QPen(kTongue, em * 0.18));
  force.line(displayed, QPen(kDisplayed, em * 0.1, Qt::DotLine));
  view.line(sight, QPen(kSight.darker(130), em * 0.16));
  for (const curricula::Pause& pause : score.pauses) {
    force.pause(pause.at_s, pause.at_s + pause.for_s, QStringLiteral("paused"));
    view.pause(pause.at_s, pause.at_s + pause.for_s, QString());
  }
  const double limit_n = log.header.device_limit_n, target_n = scenario.targets.tongue_force_n;
  force.level(limit_n, kLimit, Qt::DashLine, QStringLiteral("device limit %1 N").arg(number(limit_n, 1)),
              limit_n >= target_n);
  force.level(target_n, kTarget, Qt::DashDotLine,
              QStringLiteral("training target, tongue %1 N").arg(number(target_n, 1)), target_n > limit_n);
  view.level(scenario.sight_percent, kSight, Qt::DashLine,
             QStringLiteral("counts as in sight from %1 %").arg(number(scenario.sight_percent, 0)), true);
  if (score.time_to_trachea_visible_s >= 0.0) {
    double at_s = score.attempt_start_s + score.time_to_trachea_visible_s;
    for (const curricula::Pause& pause : score.pauses)  // the score's time leaves them out, the axis does not
      if (pause.at_s >= score.attempt_start_s && pause.at_s <= at_s) at_s += pause.for_s;
    force.moment(at_s, kSight,
                 QStringLiteral("first sight, %1 s into the attempt").arg(number(score.time_to_trachea_visible_s, 1)));
    view.moment(at_s, kSight, QString());
  }
  if (score.peak_gum_force_n > 0.0) {
    force.peak(score.time_of_peak_gum_force_s, score.peak_gum_force_n, kGum,
               QStringLiteral("gum peak %1 N").arg(number(score.peak_gum_force_n, 2)));
  }
  if (score.peak_tongue_force_n > 0.0) {
    force.peak(score.time_of_peak_tongue_force_s, score.peak_tongue_force_n, kTongue,
               QStringLiteral("tongue peak %1 N").arg(number(score.peak_tongue_force_n, 2)));
  }
  return image;
}

void write_force_chart(const std::filesystem::path& png, const curricula::TrialLog& log,
                       const curricula::Scenario& scenario, const curricula::Score& score) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!draw_force_chart(log, scenario, score).save(&buffer, "PNG")) {
    throw std::runtime_error(png.string() + ": the chart could not be encoded as PNG");
  }
  write_file_whole(png, bytes.toStdString());
}

}  // namespace vallecula::gui

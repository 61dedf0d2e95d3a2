#include "gui/lab/plot.h"

#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gui/session/files.h"

namespace vallecula::gui {

namespace {

const QColor kInk(0x22, 0x22, 0x22);
const QColor kGrid(0xE3, 0xE3, 0xE3);
const QColor kShade(0xF6, 0xF2, 0xE6);
constexpr double kHeadroom = 1.08;  // above the highest value

/// 1, 2 or 5 times a power of ten: about `count` steps in `span`.
double tick_step(double span, int count) {
  const double raw = span / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw * 0.999) return factor * power;
  return 10.0 * power;
}

double top_of(const PlotPanel& panel) {
  if (panel.high > 0) return panel.high;
  double top = panel.low;
  for (const PlotLine& line : panel.lines)
    for (double v : line.y)
      if (std::isfinite(v)) top = std::max(top, v);
  for (const PlotLevel& level : panel.levels) top = std::max(top, level.value);
  if (panel.logarithmic) return std::max(10 * panel.low, 2 * top);
  return top > panel.low ? panel.low + kHeadroom * (top - panel.low) : panel.low + 1;
}

/// One panel: data to pixels. All lengths in units of `em`, the height of the letters.
class Frame {
 public:
  Frame(QPainter& painter, const PlotPanel& panel, const QRectF& frame, double x_end, double em)
      : painter_(painter), panel_(panel), frame_(frame), x_end_(x_end), high_(top_of(panel)), em_(em) {}

  double x(double value) const { return frame_.left() + frame_.width() * value / x_end_; }
  double y(double value) const {
    double share = 0.0;
    if (panel_.logarithmic) {
      share = std::log(std::max(value, 1e-3 * panel_.low) / panel_.low) / std::log(high_ / panel_.low);
    } else {
      share = (value - panel_.low) / (high_ - panel_.low);
    }
    return frame_.bottom() - frame_.height() * std::clamp(share, -0.5, 1.5);
  }

  void draw(const std::vector<PlotSpan>& spans, bool named_spans, const QString& x_axis) {
    for (const PlotSpan& span : spans)
      painter_.fillRect(QRectF(x(span.from), frame_.top(), x(span.to) - x(span.from), frame_.height()), kShade);
    axes(x_axis);
    painter_.setClipRect(frame_.adjusted(-0.1 * em_, -0.1 * em_, 0.1 * em_, 0.1 * em_));
    for (const PlotLine& line : panel_.lines) draw_line(line);
    for (const PlotLevel& level : panel_.levels) draw_level(level);
    painter_.setClipping(false);
    painter_.setPen(QColor(0x77, 0x70, 0x58));
    if (named_spans)
      for (const PlotSpan& span : spans)
        painter_.drawText(QRectF(x(span.from), frame_.top() - 1.5 * em_, x(span.to) - x(span.from), 1.4 * em_),
                          Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextDontClip, span.text);
  }

 private:
  std::vector<double> ticks() const {
    std::vector<double> at;
    if (panel_.logarithmic) {
      for (double v = std::pow(10.0, std::ceil(std::log10(panel_.low) - 1e-9)); v <= high_ * 1.0001; v *= 10)
        at.push_back(v);
      return at;
    }
    const double step = tick_step(high_ - panel_.low, std::clamp(int(frame_.height() / (2.4 * em_)), 2, 8));
    for (double v = std::ceil(panel_.low / step - 1e-9) * step; v <= high_ * 1.0001; v += step) at.push_back(v);
    return at;
  }

  void axes(const QString& x_axis) {
    const double step = tick_step(x_end_, 12);
    painter_.setPen(QPen(kGrid, em_ * 0.06));
    for (double v : ticks()) painter_.drawLine(QPointF(frame_.left(), y(v)), QPointF(frame_.right(), y(v)));
    for (double v = step; v <= x_end_ * 1.0001; v += step)
      painter_.drawLine(QPointF(x(v), frame_.top()), QPointF(x(v), frame_.bottom()));
    painter_.setPen(QPen(kInk, em_ * 0.09));
    painter_.drawLine(frame_.bottomLeft(), frame_.bottomRight());
    painter_.drawLine(frame_.bottomLeft(), frame_.topLeft());
    for (double v : ticks())
      painter_.drawText(QRectF(frame_.left() - 5.5 * em_, y(v) - em_, 5.0 * em_, 2.0 * em_),
                        Qt::AlignRight | Qt::AlignVCenter, QString::number(std::abs(v) < 1e-12 ? 0.0 : v));
    if (!x_axis.isEmpty()) {
      for (double v = 0.0; v <= x_end_ * 1.0001; v += step)
        painter_.drawText(QRectF(x(v) - 3.0 * em_, frame_.bottom() + 0.25 * em_, 6.0 * em_, 1.5 * em_),
                          Qt::AlignHCenter | Qt::AlignTop, QString::number(v));
      painter_.drawText(QRectF(frame_.left(), frame_.bottom() + 1.7 * em_, frame_.width(), 1.6 * em_),
                        Qt::AlignHCenter | Qt::AlignTop, x_axis);
    }
    painter_.save();
    painter_.translate(frame_.left() - 5.4 * em_, frame_.center().y());
    painter_.rotate(-90.0);
    painter_.drawText(QRectF(-frame_.height(), -1.8 * em_, 2.0 * frame_.height(), 3.2 * em_), Qt::AlignCenter,
                      panel_.axis);
    painter_.restore();
  }

  /// Thousands of steps on hundreds of pixels: every column shows its smallest and largest value, so no peak is lost.
  void draw_line(const PlotLine& line) {
    QPainterPath path;
    bool broken = true;
    std::size_t first = 0;
    while (first < line.x.size()) {
      if (!std::isfinite(line.y[first])) {
        broken = true;
        ++first;
        continue;
      }
      const double column = std::floor(x(line.x[first]));
      std::size_t low = first, high = first, last = first;
      while (last + 1 < line.x.size() && std::isfinite(line.y[last + 1]) && std::floor(x(line.x[last + 1])) == column) {
        ++last;
        if (line.y[last] < line.y[low]) low = last;
        if (line.y[last] > line.y[high]) high = last;
      }
      for (const std::size_t i : {first, std::min(low, high), std::max(low, high), last}) {
        const QPointF point(x(line.x[i]), y(line.y[i]));
        broken ? path.moveTo(point) : path.lineTo(point);
        broken = false;
      }
      first = last + 1;
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(line.colour, em_ * line.width, line.style));
    painter_.drawPath(path);
  }

  void draw_level(const PlotLevel& level) {
    painter_.setPen(QPen(level.colour.darker(110), em_ * 0.12, Qt::DashLine));
    painter_.drawLine(QPointF(frame_.left(), y(level.value)), QPointF(frame_.right(), y(level.value)));
    const QRectF box(frame_.left() + 0.4 * em_, y(level.value) - 1.5 * em_, frame_.width() - 0.8 * em_, 1.4 * em_);
    const QRectF tight = painter_.boundingRect(box, Qt::AlignRight | Qt::AlignVCenter, level.text);
    painter_.fillRect(tight.adjusted(-0.15 * em_, 0, 0.15 * em_, 0), QColor(255, 255, 255, 215));
    painter_.setPen(level.colour.darker(150));
    painter_.drawText(box, Qt::AlignRight | Qt::AlignVCenter, level.text);
  }

  QPainter& painter_;
  const PlotPanel& panel_;
  QRectF frame_;
  double x_end_, high_, em_;
};

void draw_legend(QPainter& painter, const PlotPanel& panel, const QRectF& row, double em) {
  double x = row.left();
  for (const PlotLine& line : panel.lines) {
    if (line.name.isEmpty()) continue;
    painter.setPen(QPen(line.colour, em * std::max(0.18, line.width), line.style));
    painter.drawLine(QPointF(x, row.center().y()), QPointF(x + 2.2 * em, row.center().y()));
    painter.setPen(kInk);
    const double width = painter.fontMetrics().horizontalAdvance(line.name);
    painter.drawText(QRectF(x + 2.7 * em, row.top(), width + em, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     line.name);
    x += 2.7 * em + width + 2.0 * em;
  }
}

bool has_legend(const PlotPanel& panel) {
  return std::any_of(panel.lines.begin(), panel.lines.end(), [](const PlotLine& l) { return !l.name.isEmpty(); });
}

void draw_plot(QPainter& painter, const Plot& plot, const QRectF& area, double em) {
  double weights = 0.0, fixed = 3.6 * em;  // below the last panel: numbers and the axis' name
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    weights += plot.panels[i].weight;
    fixed += (has_legend(plot.panels[i]) ? 2.1 : 1.2) * em + (i == 0 && !plot.spans.empty() ? 1.5 * em : 0.0);
  }
  double top = area.top();
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const PlotPanel& panel = plot.panels[i];
    const double height = (area.height() - fixed) * panel.weight / weights;
    const QRectF row(area.left(), top + 0.3 * em, area.width(), 1.5 * em);
    if (has_legend(panel)) draw_legend(painter, panel, row, em);
    top += (has_legend(panel) ? 2.1 : 1.2) * em + (i == 0 && !plot.spans.empty() ? 1.5 * em : 0.0);
    Frame frame(painter, panel, QRectF(area.left(), top, area.width(), height), plot.x_end, em);
    frame.draw(plot.spans, i == 0, i + 1 == plot.panels.size() ? plot.x_axis : QString());
    top += height;
  }
}

void draw_scale(QPainter& painter, const ColourScale& scale, const QRectF& row, double em) {
  const QRectF bar(row.left(), row.top(), 0.45 * row.width(), 1.0 * em);
  for (double x = bar.left(); x < bar.right(); x += 1.0)
    painter.fillRect(QRectF(x, bar.top(), 1.5, bar.height()), scale_colour((x - bar.left()) / bar.width()));
  painter.setPen(kInk);
  for (int i = 0; i <= 4; ++i) {
    const double share = i / 4.0, x = bar.left() + share * bar.width();
    painter.drawText(QRectF(x - 4 * em, bar.bottom() + 0.1 * em, 8 * em, 1.4 * em), Qt::AlignHCenter | Qt::AlignTop,
                     said(scale.low + share * (scale.high - scale.low)));
  }
  painter.drawText(QRectF(bar.right() + 2.0 * em, bar.top() - 0.2 * em, row.right() - bar.right() - 2 * em, 1.4 * em),
                   Qt::AlignLeft | Qt::AlignVCenter, scale.title);
}

}  // namespace

QColor scale_colour(double share) {
  // Viridis (van der Walt and Smith 2015), every eighth.
  static constexpr std::array<std::array<int, 3>, 9> kStops = {{{68, 1, 84},
                                                                {71, 44, 122},
                                                                {59, 81, 139},
                                                                {44, 113, 142},
                                                                {33, 144, 141},
                                                                {39, 173, 129},
                                                                {92, 200, 99},
                                                                {170, 220, 50},
                                                                {253, 231, 37}}};
  const double at = std::clamp(std::isfinite(share) ? share : 1.0, 0.0, 1.0) * 8;
  const auto low = std::min<std::size_t>(7, static_cast<std::size_t>(at));
  const double part = at - static_cast<double>(low);
  const auto mixed = [&](int c) {
    return static_cast<int>(std::lround(kStops[low][c] + part * (kStops[low + 1][c] - kStops[low][c])));
  };
  return QColor(mixed(0), mixed(1), mixed(2));
}

QString said(double value) {
  if (!std::isfinite(value)) return QStringLiteral("not finite");
  if (value == 0.0) return QStringLiteral("0");
  const double size = std::abs(value);
  if (size >= 1e5 || size < 1e-4) return QString::number(value, 'e', 1);
  const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 5);
  QString text = QString::number(value, 'f', digits);
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.'))) {
    const bool point = text.endsWith('.');
    text.chop(1);
    if (point) break;
  }
  return text;
}

QImage draw_sheet(const Sheet& sheet, int width) {
  const double em = width / 80.0, margin = 1.5 * em, inner = width - 2 * margin;
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(em)));
  QFont bold = font;
  bold.setBold(true);
  bold.setPixelSize(static_cast<int>(std::lround(1.2 * em)));

  const double count = static_cast<double>(sheet.pictures.size());
  const double picture_width = count > 0 ? (inner - (count - 1) * em) / count : 0.0;
  double picture_height = 0.0, caption_height = 0.0;
  const QFontMetricsF letters(font);
  const auto lines_of = [&](const QString& text, double within) {
    return letters.boundingRect(QRectF(0, 0, within, 1e6), Qt::TextWordWrap, text).height() + 0.4 * em;
  };
  for (const SheetPicture& p : sheet.pictures) {
    picture_height = picture_width * p.image.height() / p.image.width();
    caption_height = std::max(caption_height, lines_of(p.caption, picture_width));
  }
  // Keys run on in rows.
  std::vector<QPointF> key_at;
  QPointF at(0, 0);
  for (const SheetKey& key : sheet.keys) {
    const double wide = letters.horizontalAdvance(key.text) + 4 * em;
    if (at.x() > 0 && at.x() + wide > inner) at = QPointF(0, at.y() + 1.8 * em);
    key_at.push_back(at);
    at.rx() += wide;
  }
  const double keys = sheet.keys.empty() ? 0.0 : at.y() + 2.2 * em,
               scale = sheet.scale.title.isEmpty() ? 0.0 : 3.2 * em;
  const double seen = lines_of(sheet.seen, inner - 1.6 * em) + 1.2 * em;
  const double height = 3.4 * em + picture_height + caption_height + keys + scale + sheet.plot_height + seen + 1.5 * em;

  QImage image(width, static_cast<int>(std::ceil(height)), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
  painter.setPen(kInk);
  painter.setFont(bold);
  painter.drawText(QRectF(margin, 0.8 * em, inner, 1.8 * em), Qt::AlignLeft | Qt::AlignVCenter, sheet.title);
  painter.setFont(font);
  double top = 3.2 * em;
  for (std::size_t i = 0; i < sheet.pictures.size(); ++i) {
    const double left = margin + static_cast<double>(i) * (picture_width + em);
    painter.drawImage(QRectF(left, top, picture_width, picture_height), sheet.pictures[i].image);
    painter.setPen(QPen(kGrid, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(left, top, picture_width, picture_height));
    painter.setPen(kInk);
    painter.drawText(QRectF(left, top + picture_height + 0.2 * em, picture_width, caption_height), Qt::TextWordWrap,
                     sheet.pictures[i].caption);
  }
  top += picture_height + caption_height + (sheet.pictures.empty() ? 0.0 : 0.2 * em);
  for (std::size_t i = 0; i < sheet.keys.size(); ++i) {
    const double x = margin + key_at[i].x(), y = top + key_at[i].y();
    painter.setPen(QPen(sheet.keys[i].colour.darker(140), 1.0));
    painter.setBrush(sheet.keys[i].colour);
    painter.drawEllipse(QRectF(x, y + 0.3 * em, em, em));
    painter.setPen(kInk);
    painter.drawText(QRectF(x + 1.5 * em, y, inner, 1.6 * em), Qt::AlignLeft | Qt::AlignVCenter, sheet.keys[i].text);
  }
  painter.setBrush(Qt::NoBrush);
  top += keys;
  if (scale > 0) draw_scale(painter, sheet.scale, QRectF(margin + em, top + 0.3 * em, inner, scale), em);
  top += scale;
  if (!sheet.plot.panels.empty())
    draw_plot(painter, sheet.plot, QRectF(margin + 7 * em, top, inner - 8 * em, sheet.plot_height), em);
  top += sheet.plot_height + 0.4 * em;
  const QRectF box(margin, top, inner, seen);
  painter.fillRect(box, QColor(0xF3, 0xF5, 0xF8));
  painter.setPen(kInk);
  painter.drawText(box.adjusted(0.8 * em, 0.6 * em, -0.8 * em, 0), Qt::TextWordWrap, sheet.seen);
  return image;
}

void write_png(const std::filesystem::path& file, const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG"))
    throw std::runtime_error(file.string() + ": the picture could not be encoded as PNG");
  write_file_whole(file, bytes.toStdString());
}

}  // namespace vallecula::gui

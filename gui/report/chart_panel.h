// What the charts of a report have in common: a panel with axes, lines and marks, and the colours.
#pragma once

#include <QColor>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

#include "gui/report/chart_labels.h"

namespace vallecula::gui {

/// Okabe and Ito (2008).
namespace chart {
const QColor kBlue(0x00, 0x72, 0xB2);
const QColor kVermillion(0xD5, 0x5E, 0x00);
const QColor kGreen(0x00, 0x9E, 0x73);   // bluish
const QColor kPurple(0xCC, 0x79, 0xA7);  // reddish
const QColor kSky(0x56, 0xB4, 0xE9);
const QColor kOrange(0xE6, 0x9F, 0x00);
const QColor kGrey(0x55, 0x55, 0x55);
const QColor kInk(0x22, 0x22, 0x22);
const QColor kAttempt(0xF6, 0xF4, 0xEC);

QString number(double value, int digits);
}  // namespace chart

/// 1, 2 or 5 times a power of ten: about `count` steps in `span`.
double tick_step(double span, int count);

struct Series {
  std::vector<double> time_s, value;

  void add(double at_s, double v) {
    time_s.push_back(at_s);
    value.push_back(v);
  }
};

/// How large a chart is, and its letters.
struct ChartForm {
  int width = 1600, height = 900;  ///< pixels
  double em = 20.0;                ///< height of its letters, px
  bool titled = true;              ///< false: what stands around it names it already
};
/// Of a picture, whose letters are read with all of it: as large as they grow with it, 10 px at least.
ChartForm picture_form(int width, int height);

/// A chart and the words on it.
struct Chart {
  QImage picture;
  std::vector<ChartLabel> labels;
};

/// One panel: data to pixels, axes, lines. All lengths in units of `em`, the height of the chart's letters. Its words
/// go to `labels`, which keeps them from lying on one another.
class Panel {
 public:
  Panel(QPainter& painter, ChartLabels& labels, const QRectF& frame, double end_s, double top, double em)
      : painter_(painter), labels_(labels), frame_(frame), end_s_(end_s), top_(top), em_(em) {}

  double x(double time_s) const { return frame_.left() + frame_.width() * time_s / end_s_; }
  double y(double value) const;
  const QRectF& frame() const { return frame_; }

  /// `titles`: of the value, the fullest first; the first that has room beside the panel is taken.
  void axes(const QStringList& titles, int value_ticks, bool times);
  /// Thousands of ticks on hundreds of pixels: every column shows its smallest and largest value, so no peak is lost.
  void line(const Series& series, const QPen& pen);
  /// A span on the panel's ground; to be called before the lines.
  void span(double from_s, double to_s, const QColor& colour);
  void level(double value, const QColor& colour, Qt::PenStyle style, const QString& text, bool text_above);
  /// A vertical line with its text at the top.
  void moment(double time_s, const QColor& colour, const QString& text);
  /// Covers what was drawn there: nothing of it is the hand's doing.
  void pause(double from_s, double to_s, const QString& text);
  void peak(double time_s, double value, const QColor& colour, const QString& text);

 private:
  /// Beside a point, row after row from its first downwards (or upwards), on the side with more room first.
  std::vector<LabelSlot> beside(double x, double gap, double first_top, double step) const;

  QPainter& painter_;
  ChartLabels& labels_;
  QRectF frame_;
  double end_s_, top_, em_;
};

struct LegendEntry {
  QString text;
  QPen pen;
};
/// How high a legend is that is so wide, px: in as many rows as it needs.
double legend_high(const QFontMetricsF& type, double width, double em, const std::vector<LegendEntry>& entries);
void draw_legend(QPainter& painter, ChartLabels& labels, const QPointF& top_left, double width, double em,
                 const std::vector<LegendEntry>& entries);

/// Where the panels of a trial's chart lie, for whoever lays something over it.
struct TimeAxis {
  double left = 0.0, right = 1.0;  ///< pixels
  double end_s = 1.0;              ///< at the right

  double x(double time_s) const { return left + (right - left) * time_s / end_s; }
  double time_s(double x) const { return (x - left) / (right - left) * end_s; }
};
/// Of a chart of this form of a trial whose last tick is at `last_s`.
TimeAxis chart_time_axis(const ChartForm& form, double last_s);

/// Sets the chart's font, writes its title and its legend over the panels from `left` to `right`; where the panels
/// begin, px.
double begin_chart(QPainter& painter, ChartLabels& labels, const ChartForm& form, double left, double right,
                   const QString& title, const std::vector<LegendEntry>& legend);
/// Of a chart's words, for its ChartLabels.
QFontMetricsF chart_type(double em);

}  // namespace vallecula::gui

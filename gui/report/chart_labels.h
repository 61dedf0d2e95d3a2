// The words on a chart, each where it lies on no other: at its mark where there is room, else in another row or on the
// mark's other side; cut, with the whole kept for a tooltip, where there is room for none of that.
#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <vector>

namespace vallecula::gui {

/// Words as they were drawn, in the chart's pixels; `shown` is shorter than `whole`, or empty, where room was lacking.
/// Words that are not shown have their mark's place.
struct ChartLabel {
  QRectF box;
  QString shown, whole;

  bool cut() const { return shown != whole; }
};

/// A row that words may stand in.
struct LabelSlot {
  QRectF row;
  Qt::AlignmentFlag side = Qt::AlignLeft;  ///< the end they begin from: AlignLeft, AlignRight or AlignHCenter
  bool at_end = true;                      ///< they stay at that end, beside their mark; else they may move along
};

class ChartLabels {
 public:
  /// `em`: the letters' height, px.
  ChartLabels(const QFontMetricsF& type, double em) : type_(type), em_(em) {}
  /// No words come there.
  void take(const QRectF& place) { taken_.push_back(place); }
  /// Words come there only where there is no other place: curves and marks.
  void shun(const QRectF& place) { shunned_.push_back(place); }
  /// Words in the first of `places` that has room for them; where none has, cut in the widest. `mark`: what they are
  /// of.
  void add(const QString& text, const QColor& colour, const QRectF& mark, std::vector<LabelSlot> places);
  /// Words whose place is given, cut to it; drawn at once.
  void write(QPainter& painter, const QRectF& box, int alignment, const QString& text);
  /// Places what was added, what must stay at its mark first, and draws it on a light ground (`paper`), so that no line
  /// strikes it through. All words there are now.
  std::vector<ChartLabel> draw(QPainter& painter, const QColor& paper = QColor(255, 255, 255, 215));

  /// Whether no words are there yet.
  bool is_free(const QRectF& place) const;
  double row_high() const { return 1.4 * em_; }

 private:
  struct Wish {
    QString text;
    QColor colour;
    QRectF mark;
    std::vector<LabelSlot> places;
  };
  /// What of a row is free: left and right end, px.
  std::vector<std::pair<double, double>> free_of(const QRectF& row, bool off_shunned) const;
  ChartLabel placed(const Wish& wish, bool off_shunned) const;
  std::vector<ChartLabel> laid_out(bool off_shunned);

  QFontMetricsF type_;
  double em_;
  std::vector<QRectF> taken_, shunned_;
  std::vector<ChartLabel> labels_;
  std::vector<Wish> wishes_;
};

}  // namespace vallecula::gui

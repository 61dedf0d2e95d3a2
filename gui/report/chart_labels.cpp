#include "gui/report/chart_labels.h"

#include <algorithm>
#include <utility>

namespace vallecula::gui {
namespace {

constexpr double kShortest = 4.0;  // em; a word cut shorter says nothing
constexpr double kApart = 0.3;     // em between two labels

}  // namespace

std::vector<std::pair<double, double>> ChartLabels::free_of(const QRectF& row, bool off_shunned) const {
  std::vector<std::pair<double, double>> blocked;
  const auto block = [&](const std::vector<QRectF>& places) {
    for (const QRectF& place : places)
      if (place.top() < row.bottom() && row.top() < place.bottom())
        blocked.emplace_back(place.left() - kApart * em_, place.right() + kApart * em_);
  };
  block(taken_);
  if (off_shunned) block(shunned_);
  std::sort(blocked.begin(), blocked.end());
  std::vector<std::pair<double, double>> free;
  double from = row.left();
  for (const auto& [left, right] : blocked) {
    if (left > from) free.emplace_back(from, std::min(left, row.right()));
    from = std::max(from, right);
    if (from >= row.right()) break;
  }
  if (from < row.right()) free.emplace_back(from, row.right());
  return free;
}

bool ChartLabels::is_free(const QRectF& place) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& taken) { return taken.intersects(place); });
}

void ChartLabels::add(const QString& text, const QColor& colour, const QRectF& mark, std::vector<LabelSlot> places) {
  if (!text.isEmpty()) wishes_.push_back({text, colour, mark, std::move(places)});
}

ChartLabel ChartLabels::placed(const Wish& wish, bool off_shunned) const {
  const double wanted = type_.horizontalAdvance(wish.text) + 1.0;
  QRectF widest;
  Qt::AlignmentFlag widest_side = Qt::AlignLeft;
  const auto box_in = [](const QRectF& row, double left, double right, double wide, Qt::AlignmentFlag side) {
    const double middle = std::clamp(row.center().x() - 0.5 * wide, left, std::max(left, right - wide));
    return QRectF(side == Qt::AlignLeft    ? left
                  : side == Qt::AlignRight ? right - wide
                                           : middle,
                  row.top(), wide, row.height());
  };
  for (const LabelSlot& slot : wish.places) {
    auto free = free_of(slot.row, off_shunned);
    if (slot.side == Qt::AlignRight) std::reverse(free.begin(), free.end());
    for (const auto& [left, right] : free) {
      if (slot.at_end && ((slot.side == Qt::AlignLeft && left > slot.row.left() + 0.5) ||
                          (slot.side == Qt::AlignRight && right < slot.row.right() - 0.5)))
        continue;
      if (right - left >= wanted) return {box_in(slot.row, left, right, wanted, slot.side), wish.text, wish.text};
      if (right - left > widest.width()) {
        widest = QRectF(left, slot.row.top(), right - left, slot.row.height());
        widest_side = slot.side;
      }
    }
  }
  if (widest.width() < kShortest * em_) return {wish.mark, QString(), wish.text};
  const QString shown = type_.elidedText(wish.text, Qt::ElideRight, widest.width() - 1.0);
  const double wide = type_.horizontalAdvance(shown) + 1.0;
  return {box_in(widest, widest.left(), widest.right(), wide, widest_side), shown, wish.text};
}

void ChartLabels::write(QPainter& painter, const QRectF& box, int alignment, const QString& text) {
  const QFontMetricsF type(painter.font(), painter.device());
  const QString shown = type.elidedText(text, Qt::ElideRight, box.width());
  painter.drawText(box, alignment, shown);
  const QTransform& to_chart = painter.transform();
  const QRectF tight = to_chart.mapRect(painter.boundingRect(box, alignment, shown));
  labels_.push_back({tight, shown, text});
  taken_.push_back(tight);
}

std::vector<ChartLabel> ChartLabels::laid_out(bool off_shunned) {
  const std::size_t fixed = taken_.size();
  std::vector<ChartLabel> all;
  for (const Wish& wish : wishes_) {
    ChartLabel label = placed(wish, off_shunned);
    if (label.cut() && off_shunned) label = placed(wish, false);
    if (!label.shown.isEmpty()) taken_.push_back(label.box);
    all.push_back(label);
  }
  taken_.resize(fixed);
  return all;
}

std::vector<ChartLabel> ChartLabels::draw(QPainter& painter, const QColor& paper) {
  std::stable_partition(wishes_.begin(), wishes_.end(),
                        [](const Wish& wish) { return !wish.places.empty() && wish.places.front().at_end; });
  const auto cut = [](const std::vector<ChartLabel>& all) {
    return std::count_if(all.begin(), all.end(), [](const ChartLabel& label) { return label.cut(); });
  };
  std::vector<ChartLabel> best = laid_out(true);
  if (cut(best) > 0)  // to be read comes before to be off the curves
    if (std::vector<ChartLabel> closer = laid_out(false); cut(closer) < cut(best)) best = std::move(closer);
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (best[i].shown.isEmpty()) continue;
    painter.fillRect(best[i].box.adjusted(-0.15 * em_, 0.0, 0.15 * em_, 0.0), paper);
    painter.setPen(wishes_[i].colour);
    painter.drawText(best[i].box, Qt::AlignCenter | Qt::TextDontClip | Qt::TextSingleLine, best[i].shown);
  }
  labels_.insert(labels_.end(), best.begin(), best.end());
  wishes_.clear();
  return labels_;
}

}  // namespace vallecula::gui

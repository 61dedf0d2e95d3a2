#include "gui/pages/wrap_row.h"

#include <algorithm>
#include <numeric>

namespace vallecula::gui {

WrapRow::~WrapRow() = default;

void WrapRow::addItem(QLayoutItem* item) { items_.emplace_back(item); }

QLayoutItem* WrapRow::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* WrapRow::takeAt(int index) {
  if (itemAt(index) == nullptr) return nullptr;
  const auto at = items_.begin() + index;
  QLayoutItem* item = at->release();
  items_.erase(at);
  return item;
}

int WrapRow::wide(const Row& row) const {
  const int between = spacing() * std::max(0, static_cast<int>(row.size()) - 1);
  return std::accumulate(row.begin(), row.end(), between,
                         [](int sum, const QLayoutItem* item) { return sum + item->sizeHint().width(); });
}

int WrapRow::high(const Row& row) {
  return std::accumulate(row.begin(), row.end(), 0,
                         [](int most, const QLayoutItem* item) { return std::max(most, item->sizeHint().height()); });
}

std::vector<WrapRow::Row> WrapRow::rows_for(int width) const {
  Row seen;
  for (const auto& item : items_)
    if (!item->isEmpty()) seen.push_back(item.get());
  for (std::size_t in_row = seen.size();; in_row = (in_row + 1) / 2) {
    std::vector<Row> rows;
    for (std::size_t from = 0; from < seen.size(); from += in_row)
      rows.emplace_back(seen.begin() + static_cast<std::ptrdiff_t>(from),
                        seen.begin() + static_cast<std::ptrdiff_t>(std::min(seen.size(), from + in_row)));
    if (in_row <= 1 || std::all_of(rows.begin(), rows.end(), [&](const Row& row) { return wide(row) <= width; }))
      return rows;
  }
}

int WrapRow::heightForWidth(int width) const {
  int sum = 0;
  for (const Row& row : rows_for(width)) sum += high(row) + (sum > 0 ? spacing() : 0);
  return sum;
}

QSize WrapRow::sizeHint() const {
  Row all;
  for (const auto& item : items_)
    if (!item->isEmpty()) all.push_back(item.get());
  return {wide(all), high(all)};
}

QSize WrapRow::minimumSize() const {
  QSize least;
  for (const auto& item : items_)
    if (!item->isEmpty()) least = least.expandedTo(item->minimumSize());
  return least;
}

void WrapRow::setGeometry(const QRect& place) {
  QLayout::setGeometry(place);
  int y = place.top();
  for (const Row& row : rows_for(place.width())) {
    const auto grows = [](QLayoutItem* item) {
      return item->widget() != nullptr && (item->widget()->sizePolicy().horizontalPolicy() & QSizePolicy::GrowFlag) != 0;
    };
    int growing = static_cast<int>(std::count_if(row.begin(), row.end(), grows));
    int left = std::max(0, place.width() - wide(row)), x = place.left();
    for (QLayoutItem* item : row) {
      int width = item->sizeHint().width();
      if (grows(item)) {
        const int more = left / growing--;
        width += more;
        left -= more;
      }
      item->setGeometry(QRect(x, y, width, high(row)));
      x += width + spacing();
    }
    y += high(row) + spacing();
  }
}

}  // namespace vallecula::gui

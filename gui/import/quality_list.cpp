#include "gui/import/quality_list.h"

#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "gui/import/window_message.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

int rank(const pipeline::QualityItem& item) { return !item.judged ? 2 : item.ok ? 1 : 0; }

QString value_of(const pipeline::QualityItem& item) {
  // Notes and origins carry their message in the note; their zero says nothing.
  if (item.unit.empty() && item.value == 0.0 && !item.note.empty()) return {};
  const bool whole = std::abs(item.value) >= 1000.0;  // never 1.6e+04 triangles
  return QString("%1 %2")
      .arg(item.value, 0, whole ? 'f' : 'g', whole ? 0 : 4)
      .arg(QString::fromStdString(item.unit))
      .trimmed();
}

}  // namespace

QualityList::QualityList(QWidget* parent) : QTreeWidget(parent) {
  setColumnCount(4);
  setHeaderLabels({"", "What", "Value", "Remarks"});
  setRootIsDecorated(false);
  setWordWrap(true);
  setUniformRowHeights(false);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setAccessibleName("Quality report");
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(3, QHeaderView::Stretch);
  connect(header(), &QHeaderView::sectionResized, this, &QualityList::fit_rows);
}

void QualityList::show_items(const std::vector<pipeline::QualityItem>& items) {
  clear();
  to_look_at_ = 0;
  auto sorted = items;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return rank(a) < rank(b); });
  for (const auto& item : sorted) {
    const bool look = item.judged && !item.ok;
    to_look_at_ += look ? 1 : 0;
    const QString note = window_message(QString::fromStdString(item.note));
    auto* row = new QTreeWidgetItem(this, {look          ? "LOOK"
                                           : item.judged ? "ok"
                                                         : "",
                                           QString::fromStdString(item.name), value_of(item), note});
    row->setForeground(0, look ? theme::kOver : theme::kWithin);
    if (look) row->setForeground(1, theme::kOver);
    row->setToolTip(3, note);
  }
  fit_rows();
}

void QualityList::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  fit_rows();
}

/// A tree does not grow its rows with wrapped text by itself, and a remark cut off says nothing.
void QualityList::fit_rows() {
  constexpr int kMargin = 8;  // pixels: the style's padding
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = topLevelItem(i);
    const QRect room(0, 0, std::max(40, columnWidth(3) - 2 * kMargin), 10000);
    const int high = fontMetrics().boundingRect(room, Qt::TextWordWrap, row->text(3)).height();
    row->setSizeHint(3, QSize(0, high + kMargin));
  }
}

}  // namespace vallecula::gui

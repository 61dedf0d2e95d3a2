// The keys of a page, in a small dialog (F1). The rows come from the tables by which the page takes its keys.
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace vallecula::gui {

struct KeyRow {
  QString keys, what;
};
struct KeyGroup {
  QString title;
  std::vector<KeyRow> rows;
};

/// A key (Qt::Key, with modifiers) as it is written on this platform.
QString key_name(int key);
/// Opens the list; the page goes on behind it. One at a time.
void show_key_list(QWidget* page, const std::vector<KeyGroup>& groups);

}  // namespace vallecula::gui

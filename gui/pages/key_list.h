// The keys of a page, in a small dialog (F1). The rows come from the tables by which the page takes its keys.
#pragma once

#include <QString>
#include <vector>

class QDialog;
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
/// Opens the list, which F1 closes as Esc does; the page goes on behind it. One at a time: null where it is open
/// already. `note`: said above it.
QDialog* show_key_list(QWidget* page, const std::vector<KeyGroup>& groups, const QString& note = {});
/// False: it was not open.
bool close_key_list(QWidget* page);

}  // namespace vallecula::gui

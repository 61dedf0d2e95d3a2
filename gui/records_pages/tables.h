// Tables of words, as all the records' pages show them.
#pragma once

#include <QStringList>
#include <string>

class QTableWidget;
class QTableView;
class QWidget;

namespace vallecula::gui {

/// Rows are chosen one at a time, nothing is edited; `name` is for who cannot see it.
void make_readable(QTableView* table, const QString& name);
QTableWidget* new_table(QWidget* parent, const QString& name, const QStringList& headings);
void fill_row(QTableWidget* table, int row, const QStringList& cells);
/// By local time, as the clock on the wall: "2026-05-03 12:00" of "2026-05-03T10:00:00Z" in Berlin.
QString for_people(const std::string& utc);

}  // namespace vallecula::gui

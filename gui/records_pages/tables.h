// Tables of words, as all the records' pages show them.
#pragma once

#include <QDate>
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
/// By local time, as the clock on the wall, and as the window's language writes it: "2026-05-03 12:00" of
/// "2026-05-03T10:00:00Z" in Berlin, in German "03.05.2026 12:00". Files and exports keep what was recorded.
QString for_people(const std::string& utc);
QDate local_day(const std::string& utc);  ///< that day
/// A kind of device for a person, of LogHeader::device_kind ("touch+mouse").
QString hands_in_words(const std::string& device_kind);

}  // namespace vallecula::gui

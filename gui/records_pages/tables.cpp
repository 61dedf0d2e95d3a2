#include "gui/records_pages/tables.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QHeaderView>
#include <QLocale>
#include <QTableWidget>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

void make_readable(QTableView* table, const QString& name) {
  table->setAccessibleName(name);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);  // Tab goes on to the next widget
  table->verticalHeader()->hide();
  table->horizontalHeader()->setHighlightSections(false);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setStretchLastSection(true);
}

QTableWidget* new_table(QWidget* parent, const QString& name, const QStringList& headings) {
  auto* table = new QTableWidget(0, headings.size(), parent);
  table->setHorizontalHeaderLabels(headings);
  make_readable(table, name);
  return table;
}

void fill_row(QTableWidget* table, int row, const QStringList& cells) {
  for (int column = 0; column < cells.size(); ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setToolTip(item->text());
    table->setItem(row, column, item);
  }
}

namespace {

QDateTime on_the_wall(const std::string& utc) {
  QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  if (time.timeSpec() == Qt::LocalTime) time.setTimeSpec(Qt::UTC);  // no zone was written
  return time.toLocalTime();
}

}  // namespace

QString for_people(const std::string& utc) {
  //: A moment in a table, as QDateTime::toString() takes it: all four figures of the year, for trials are kept for
  //: years
  return QLocale().toString(on_the_wall(utc), QCoreApplication::translate("Tables", "yyyy-MM-dd HH:mm"));
}

QDate local_day(const std::string& utc) { return on_the_wall(utc).date(); }

QString hands_in_words(const std::string& device_kind) {
  QStringList words;
  for (const QString& part : QString::fromStdString(device_kind).split('+')) words << in_words(part.toStdString());
  return words.join('+');
}

}  // namespace vallecula::gui

// For instructors: everybody's curves in one table, to be filtered, sorted and opened.
#pragma once

#include <QWidget>

#include "gui/records_pages/cohort_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace vallecula::gui {

class HandOn;
class RecordsDesk;

class CohortTab : public QWidget {
  Q_OBJECT
 public:
  CohortTab(RecordsDesk& desk, const KnownCourses& courses, QWidget* parent);
  void refresh();  ///< nothing where no instructor is signed in

 signals:
  void curve_wanted(const vallecula::curricula::CurveKey& key);

 private:
  QComboBox* filter(const QString& name, CohortModel::Column column);
  void fill_filters();
  void show_count();
  curricula::CohortFilter period() const;

  RecordsDesk& desk_;
  CohortModel* model_;
  CohortFilterModel* shown_;
  QTableView* table_;
  QLineEdit* name_;
  QComboBox* period_;
  std::vector<std::pair<QComboBox*, CohortModel::Column>> filters_;
  QLabel* count_;
  QPushButton* open_;
  HandOn* hand_on_;
};

}  // namespace vallecula::gui

// The cohort as a table: one row a trainee, scenario and kind of device; and what of it is shown.
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <vector>

#include "curricula/records/progress.h"
#include "gui/records_pages/known_courses.h"

namespace vallecula::gui {

class CohortModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column {
    kTrainee,
    kCourse,
    kScenario,
    kDevice,
    kTrials,
    kPassed,
    kInARow,
    kCusum,
    kInterrupted,
    kSetAside,
    kLast,
    kColumns
  };
  static constexpr int kSortRole = Qt::UserRole;  ///< numbers as numbers

  CohortModel(const KnownCourses& courses, QObject* parent) : QAbstractTableModel(parent), courses_(courses) {}
  void set_curves(std::vector<curricula::CurveSummary> curves);
  const curricula::CurveSummary& curve(int row) const { return curves_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const KnownCourses& courses_;
  std::vector<curricula::CurveSummary> curves_;
};

/// Sorts by the numbers behind the words, and shows what all its filters let through.
class CohortFilterModel : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit CohortFilterModel(QObject* parent);
  void set_only(CohortModel::Column column, const QString& text);  ///< exactly this text in it; empty: any
  void set_name_contains(const QString& text);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QString only_[CohortModel::kColumns];
  QString name_contains_;
};

}  // namespace vallecula::gui

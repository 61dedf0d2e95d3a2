#include "gui/records_pages/cohort_model.h"

#include <QCoreApplication>

#include "gui/records_pages/curve_reading.h"
#include "gui/records_pages/tables.h"

namespace vallecula::gui {
namespace {

struct Heading {
  const char* text;
  const char* tip;
};
constexpr Heading kHeadings[CohortModel::kColumns] = {
    {QT_TRANSLATE_NOOP("CohortModel", "Trainee"), ""},
    {QT_TRANSLATE_NOOP("CohortModel", "Course"), ""},
    {QT_TRANSLATE_NOOP("CohortModel", "Scenario"), ""},
    {QT_TRANSLATE_NOOP("CohortModel", "Device"), QT_TRANSLATE_NOOP("CohortModel", "kinds of device are never pooled")},
    {QT_TRANSLATE_NOOP("CohortModel", "Trials"), QT_TRANSLATE_NOOP("CohortModel", "whole ones")},
    {QT_TRANSLATE_NOOP("CohortModel", "Passed"),
     QT_TRANSLATE_NOOP("CohortModel", "within two attempts; no pass mark is validated")},
    {QT_TRANSLATE_NOOP("CohortModel", "In a row"), QT_TRANSLATE_NOOP("CohortModel", "successes up to the last trial")},
    {QT_TRANSLATE_NOOP("CohortModel", "CUSUM"),
     QT_TRANSLATE_NOOP("CohortModel",
                       "the last verdict of the cumulative sum by the published rule: 80 % success within two attempts "
                       "(PMC8290971), its other numbers assumed")},
    {QT_TRANSLATE_NOOP("CohortModel", "Cut off"),
     QT_TRANSLATE_NOOP("CohortModel", "interrupted trials: in no other figure")},
    {QT_TRANSLATE_NOOP("CohortModel", "Not counted"),
     QT_TRANSLATE_NOOP("CohortModel", "changed by an instructor, or begun at the vallecula: in no other figure")},
    {QT_TRANSLATE_NOOP("CohortModel", "Last"), QT_TRANSLATE_NOOP("CohortModel", "when the last trial ended")}};

}  // namespace

void CohortModel::set_curves(std::vector<curricula::CurveSummary> curves) {
  beginResetModel();
  curves_ = std::move(curves);
  endResetModel();
}

int CohortModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(curves_.size());
}

int CohortModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CohortModel::data(const QModelIndex& index, int role) const {
  const curricula::CurveSummary& one = curve(index.row());
  if (role == Qt::TextAlignmentRole && index.column() >= kTrials && index.column() != kCusum && index.column() != kLast)
    return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != kSortRole) return {};
  switch (index.column()) {
    case kTrainee:
      return QString::fromStdString(one.trainee_name);
    case kCourse:
      return courses_.title(one.key.curriculum_id);
    case kScenario:
      return courses_.title(one.key.curriculum_id, one.key.scenario_id);
    case kDevice:
      return hands_in_words(one.key.device_kind);
    case kTrials:
      return one.trials;
    case kPassed:
      return one.passed;
    case kInARow:
      return one.passed_in_a_row;
    case kCusum:
      return QString::fromStdString(verdict_in_words(one.cusum));
    case kInterrupted:
      return one.interrupted;
    case kSetAside:
      return one.set_aside;
    default:
      return role == kSortRole ? QString::fromStdString(one.last_utc) : for_people(one.last_utc);
  }
}

QVariant CohortModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) return QCoreApplication::translate("CohortModel", kHeadings[section].text);
  if (role == Qt::ToolTipRole)
    return kHeadings[section].tip[0] == '\0' ? QString()
                                             : QCoreApplication::translate("CohortModel", kHeadings[section].tip);
  return {};
}

CohortFilterModel::CohortFilterModel(QObject* parent) : QSortFilterProxyModel(parent) {
  setSortRole(CohortModel::kSortRole);
  setSortCaseSensitivity(Qt::CaseInsensitive);
}

void CohortFilterModel::set_only(CohortModel::Column column, const QString& text) {
  only_[column] = text;
  invalidateFilter();
}

void CohortFilterModel::set_name_contains(const QString& text) {
  name_contains_ = text;
  invalidateFilter();
}

bool CohortFilterModel::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto text = [&](int column) {
    return sourceModel()->index(row, column, parent).data(Qt::DisplayRole).toString();
  };
  for (int column = 0; column < CohortModel::kColumns; ++column)
    if (!only_[column].isEmpty() && text(column) != only_[column]) return false;
  return name_contains_.isEmpty() || text(CohortModel::kTrainee).contains(name_contains_, Qt::CaseInsensitive);
}

}  // namespace vallecula::gui

#include "gui/records_pages/cohort_tab.h"

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <set>
#include <tuple>

#include "gui/records_pages/hand_on.h"
#include "gui/records_pages/records_desk.h"
#include "gui/records_pages/tables.h"

namespace vallecula::gui {
namespace {

using Key = std::tuple<long long, std::string, std::string, std::string>;
Key key_of(const curricula::CurveKey& key) {
  return {key.trainee_id, key.curriculum_id, key.scenario_id, key.device_kind};
}

}  // namespace

CohortTab::CohortTab(RecordsDesk& desk, const KnownCourses& courses, QWidget* parent) : QWidget(parent), desk_(desk) {
  model_ = new CohortModel(courses, this);
  shown_ = new CohortFilterModel(this);
  shown_->setSourceModel(model_);
  auto* row = new QHBoxLayout;
  name_ = new QLineEdit(this);
  name_->setPlaceholderText(tr("Name"));
  name_->setAccessibleName(tr("Part of the trainee's name"));
  name_->setClearButtonEnabled(true);
  row->addWidget(name_, 2);
  for (const auto& [name, column] :
       {std::pair(tr("Any course"), CohortModel::kCourse), std::pair(tr("Any scenario"), CohortModel::kScenario),
        std::pair(tr("Any device"), CohortModel::kDevice)})
    row->addWidget(filter(name, column), 2);
  period_ = new QComboBox(this);
  period_->setAccessibleName(tr("Period"));
  for (const auto& [name, days] : {std::pair(tr("All time"), 0), std::pair(tr("Last 7 days"), 7),
                                   std::pair(tr("Last 30 days"), 30), std::pair(tr("Last 365 days"), 365)})
    period_->addItem(name, days);
  row->addWidget(period_, 1);
  table_ = new QTableView(this);
  table_->setModel(shown_);
  make_readable(table_, tr("Cohort"));
  table_->setSortingEnabled(true);
  table_->sortByColumn(CohortModel::kTrainee, Qt::AscendingOrder);
  count_ = new QLabel(this);
  count_->setObjectName("faint");
  count_->setWordWrap(true);
  open_ = new QPushButton(tr("&Open"), this);
  open_->setToolTip(tr("Enter, or a double click on the curve"));
  auto* all = new QVBoxLayout(this);
  all->addLayout(row);
  all->addWidget(table_, 1);
  hand_on_ = new HandOn(
      desk_,
      [this] {
        HandOn::Shown shown;
        shown.filter.since_utc = period().since_utc;
        std::set<Key> keys;
        for (int row = 0; row < shown_->rowCount(); ++row)
          keys.insert(key_of(model_->curve(shown_->mapToSource(shown_->index(row, 0)).row()).key));
        shown.with = [keys](const curricula::RecordRow& trial) {
          return keys.count({trial.trainee_id, trial.curriculum_id, trial.scenario_id, trial.device_kind}) > 0;
        };
        return shown;
      },
      this);
  connect(hand_on_, &HandOn::told, count_, &QLabel::setText);
  auto* foot = new QHBoxLayout;
  foot->addWidget(count_, 1);
  foot->addWidget(open_);
  foot->addWidget(hand_on_);
  all->addLayout(foot);
  connect(name_, &QLineEdit::textChanged, shown_, &CohortFilterModel::set_name_contains);
  connect(period_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CohortTab::refresh);
  const auto open = [this](const QModelIndex& index) {
    if (index.isValid()) emit curve_wanted(model_->curve(shown_->mapToSource(index).row()).key);
  };
  connect(table_, &QTableView::activated, this, open);
  connect(open_, &QPushButton::clicked, this, [this, open] { open(table_->currentIndex()); });
  for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(shown_, signal, this, &CohortTab::show_count);
  connect(shown_, &QAbstractItemModel::modelReset, this, &CohortTab::show_count);
}

QComboBox* CohortTab::filter(const QString& name, CohortModel::Column column) {
  auto* box = new QComboBox(this);
  box->setAccessibleName(name);
  box->addItem(name, QString());
  connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this, box, column] { shown_->set_only(column, box->currentData().toString()); });
  filters_.emplace_back(box, column);
  return box;
}

curricula::CohortFilter CohortTab::period() const {
  curricula::CohortFilter period;
  if (const int days = period_->currentData().toInt(); days > 0)
    period.since_utc = QDateTime::currentDateTimeUtc().addDays(-days).toString(Qt::ISODate).toStdString();
  return period;
}

void CohortTab::refresh() {
  if (!desk_.instructor()) return;
  const curricula::SignedIn who = *desk_.who();
  desk_.ask<std::vector<curricula::CurveSummary>>(
      this,
      [who, period = period()](curricula::Records& records) {
        return curricula::Progress(records).cohort(who, period);
      },
      [this](std::vector<curricula::CurveSummary> curves) {
        model_->set_curves(std::move(curves));
        fill_filters();
        show_count();
      });
}

/// With what the table holds; what was chosen stays chosen, also where the period has nothing of it.
void CohortTab::fill_filters() {
  for (const auto& [box, column] : filters_) {
    QSet<QString> seen;
    for (int row = 0; row < model_->rowCount(); ++row)
      seen.insert(model_->index(row, column).data(Qt::DisplayRole).toString());
    const QString chosen = box->currentData().toString();
    if (!chosen.isEmpty()) seen.insert(chosen);
    QStringList values = seen.values();
    std::sort(values.begin(), values.end());
    const QSignalBlocker quiet(box);
    while (box->count() > 1) box->removeItem(1);
    for (const QString& value : values) box->addItem(value, value);
    box->setCurrentIndex(std::max(0, box->findData(chosen)));
  }
}

void CohortTab::show_count() {
  if (model_->rowCount() == 0) {
    count_->setText(
        period_->currentData().toInt() > 0
            ? tr("Nobody who is signed in while practising has a trial in this time; choose a longer one.")
            : tr("No trainee has a trial yet. Trainees sign in before they practise; trials without a sign-in "
                 "belong to nobody and are not shown here."));
    return;
  }
  count_->setText(tr("%1 of %2 curves. Enter or a double click opens one. Kinds of device are never pooled; no pass "
                     "mark is validated.")
                      .arg(shown_->rowCount())
                      .arg(model_->rowCount()));
}

}  // namespace vallecula::gui

#include "gui/records_pages/progress_tab.h"

#include <QCalendarWidget>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QTextCharFormat>
#include <QVBoxLayout>
#include <limits>

#include "curricula/score/figures.h"
#include "gui/records_pages/curve_charts.h"
#include "gui/records_pages/own_rating.h"
#include "gui/records_pages/person_words.h"
#include "gui/records_pages/records_desk.h"
#include "gui/records_pages/tables.h"
#include "gui/records_pages/trials_panel.h"
#include "gui/views/scrolled.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

using curricula::CurveKey;
using curricula::CurveSummary;
using curricula::Figure;
using curricula::RecordRow;

namespace {

constexpr char kFirstFigure[] = "peak_tongue_force_n";

bool same(const CurveKey& a, const CurveKey& b) {
  return a.trainee_id == b.trainee_id && a.curriculum_id == b.curriculum_id && a.scenario_id == b.scenario_id &&
         a.device_kind == b.device_kind;
}

QString after_trials(int trials) {
  return trials < 0 ? QCoreApplication::translate("ProgressTab", "not yet")
                    : QCoreApplication::translate("ProgressTab", "after %n trial(s)", "", trials);
}
QString words_of(const curricula::Day& day) {
  return QCoreApplication::translate("ProgressTab", "%n trial(s), %1 passed", "", day.trials).arg(day.passed);
}

}  // namespace

ProgressTab::ProgressTab(RecordsDesk& desk, const KnownCourses& courses, QWidget* parent)
    : QWidget(parent), desk_(desk), courses_(courses) {
  auto* row = new QHBoxLayout(this);
  row->addWidget(make_left(), 0);
  // With large text charts and table are more than a small window is high.
  row->addWidget(new Scrolled(make_right(), 10.0, this), 1);
  connect(&desk_, &RecordsDesk::changed, this, &ProgressTab::forget);
  empty_curve({});
}

QWidget* ProgressTab::make_left() {
  auto* left = new QWidget(this);
  left->setFixedWidth(330);
  whose_label_ = new QLabel(left);
  whose_label_->setWordWrap(true);
  whose_ = new QComboBox(left);
  whose_->setAccessibleName(tr("Whose progress"));
  list_ = new QListWidget(left);
  list_->setAccessibleName(tr("Learning curves"));
  list_->setWordWrap(true);
  calendar_ = new QCalendarWidget(left);
  calendar_->setAccessibleName(tr("Days with trials"));
  calendar_->setVerticalHeaderFormat(QCalendarWidget::NoVerticalHeader);
  calendar_->setFirstDayOfWeek(Qt::Monday);
  theme::keep_high(*calendar_, 190);
  QTextCharFormat weekend;  // red on this ground can hardly be read
  weekend.setForeground(theme::faint());
  for (const auto day : {Qt::Saturday, Qt::Sunday}) calendar_->setWeekdayTextFormat(day, weekend);
  day_ = new QLabel(left);
  day_->setObjectName("faint");
  day_->setWordWrap(true);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 8, 0);
  column->addWidget(whose_label_);
  column->addWidget(whose_);
  column->addWidget(list_, 1);
  column->addWidget(calendar_);
  column->addWidget(day_);
  connect(whose_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    wanted_ = {subject(), {}, {}, {}};
    refresh();
  });
  connect(list_, &QListWidget::currentRowChanged, this, &ProgressTab::ask_curve);
  connect(calendar_, &QCalendarWidget::selectionChanged, this, &ProgressTab::show_days);
  return left;
}

QWidget* ProgressTab::make_right() {
  auto* right = new QWidget(this);
  figure_ = new QComboBox(right);
  figure_->setAccessibleName(tr("Figure of the learning curve"));
  for (const Figure& figure : curricula::figures())
    if (!figure.for_researchers) figure_->addItem(with_unit(figure), QString(figure.name));
  figure_->setCurrentIndex(std::max(0, figure_->findData(QString(kFirstFigure))));
  mastery_ = new QLabel(right);
  mastery_->setObjectName("mastery");
  mastery_->setWordWrap(true);
  rule_ = new QLabel(right);
  rule_->setObjectName("faint");
  rule_->setWordWrap(true);
  learning_ = new TrialChart(right);
  sum_ = new TrialChart(right);
  trials_ = new TrialsPanel(desk_, courses_, right);
  auto* charts = new QHBoxLayout;
  auto* first = new QVBoxLayout;
  first->addWidget(figure_);
  first->addWidget(learning_, 1);
  charts->addLayout(first, 1);
  charts->addWidget(sum_, 1);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(charts, 3);
  column->addWidget(mastery_);
  column->addWidget(rule_);
  column->addWidget(trials_, 3);
  connect(figure_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    show_figure();
    trials_->show_figure(figure());
  });
  connect(trials_, &TrialsPanel::chosen, learning_, &TrialChart::set_current);
  connect(trials_, &TrialsPanel::trial_wanted, this, &ProgressTab::trial_wanted);
  connect(trials_, &TrialsPanel::own_rated, this, &ProgressTab::refresh);
  connect(learning_, &TrialChart::pointed_at, trials_, &TrialsPanel::choose);
  connect(learning_, &TrialChart::wanted, trials_, &TrialsPanel::open);
  return right;
}

long long ProgressTab::subject() const {
  return desk_.instructor() ? whose_->currentData().toLongLong() : desk_.person().id;
}

void ProgressTab::forget() {
  wanted_ = {};
  curves_.clear();
  days_.clear();
  list_->clear();
  calendar_->setDateTextFormat(QDate(), QTextCharFormat());
  day_->clear();
  whose_label_->clear();
  empty_curve({});
}

void ProgressTab::show_progress_of(const CurveKey& key) {
  wanted_ = key;
  refresh();
}

void ProgressTab::refresh() {
  const bool instructor = desk_.instructor();
  const long long of = instructor ? wanted_.trainee_id : desk_.person().id;
  const curricula::Who who = desk_.who();
  desk_.ask<Subject>(
      this,
      [who, of, instructor](curricula::Records& records) {
        Subject subject = ask_subject(records, who, of);
        if (instructor) subject.people = curricula::People(records).list();
        return subject;
      },
      [this, asker = desk_.person().id](Subject subject) {
        if (desk_.person().id == asker) show_subject(std::move(subject));
      });
}

ProgressTab::Subject ProgressTab::ask_subject(curricula::Records& records, const curricula::Who& who, long long of) {
  const curricula::Progress progress(records);
  Subject subject;
  subject.curves = progress.curves(who, of);
  subject.to_rate.resize(subject.curves.size(), 0);
  std::vector<RecordRow> rows = progress.trials(who, of, std::numeric_limits<int>::max());
  for (const RecordRow& row : take_out(rows, to_rate_first(records, who, rows)))
    for (std::size_t i = 0; i < subject.curves.size(); ++i) {
      CurveSummary& curve = subject.curves[i];
      if (!same(curve.key, {row.trainee_id, row.curriculum_id, row.scenario_id, row.device_kind})) continue;
      ++subject.to_rate[i];
      --(row.score.counts() ? curve.trials : row.score.complete ? curve.set_aside : curve.interrupted);
      if (curricula::procedure_succeeded(row)) --curve.passed;
    }
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {  // the newest is the first
    const std::string date = local_day(row->finished_utc).toString(Qt::ISODate).toStdString();
    if (subject.days.empty() || subject.days.back().date != date) subject.days.push_back({date, 0, 0});
    ++subject.days.back().trials;
    subject.days.back().passed += curricula::procedure_succeeded(*row) ? 1 : 0;
  }
  return subject;
}

void ProgressTab::fill_people(const std::vector<curricula::Person>& people) {
  whose_->setVisible(desk_.instructor());
  if (!desk_.instructor()) {
    whose_label_->setText(desk_.who() ? tr("Progress of %1").arg(words_of(desk_.person()))
                                      : tr("Nobody is signed in. These trials belong to nobody; sign in to have "
                                           "progress of your own."));
    return;
  }
  whose_label_->setText(tr("Progress of"));
  whose_->clear();
  whose_->addItem(tr("trials that belong to nobody"), QVariant::fromValue(0LL));
  for (const curricula::Person& person : people) whose_->addItem(words_of(person), QVariant::fromValue(person.id));
  whose_->setCurrentIndex(std::max(0, whose_->findData(QVariant::fromValue(wanted_.trainee_id))));
}

void ProgressTab::show_subject(Subject subject) {
  fill_people(subject.people);
  if (wanted_.scenario_id.empty() && list_->currentRow() >= 0 &&
      list_->currentRow() < static_cast<int>(curves_.size()))  // looked at anew: the same curve stays
    if (const CurveKey& shown = curves_[static_cast<std::size_t>(list_->currentRow())].key;
        shown.trainee_id == this->subject())
      wanted_ = shown;
  curves_ = std::move(subject.curves);
  days_ = std::move(subject.days);
  int row = curves_.empty() ? -1 : 0;
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const CurveSummary& curve = curves_[i];
      list_->addItem(
          courses_.title(curve.key.curriculum_id, curve.key.scenario_id) + "\n" +
          tr("%1 · %2 of %3 passed").arg(hands_in_words(curve.key.device_kind)).arg(curve.passed).arg(curve.trials) +
          (curve.interrupted > 0 ? tr(" · %1 cut off").arg(curve.interrupted) : QString()) +
          (curve.set_aside > 0 ? tr(" · %1 not counted").arg(curve.set_aside) : QString()) +
          (subject.to_rate[i] > 0 ? tr(" · %1 to rate").arg(subject.to_rate[i]) : QString()));
      list_->item(static_cast<int>(i))->setToolTip(courses_.title(curve.key.curriculum_id));
      if (same(curve.key, wanted_)) row = static_cast<int>(i);
    }
    list_->setCurrentRow(row);
  }
  wanted_ = {this->subject(), {}, {}, {}};
  calendar_->setDateTextFormat(QDate(), QTextCharFormat());
  for (const curricula::Day& day : days_) {
    QTextCharFormat format;
    format.setFontWeight(QFont::Bold);
    format.setFontUnderline(true);
    format.setForeground(theme::text());
    format.setBackground(theme::accent().darker(160));
    format.setToolTip(words_of(day));
    calendar_->setDateTextFormat(QDate::fromString(QString::fromStdString(day.date), Qt::ISODate), format);
  }
  if (!days_.empty())
    calendar_->setSelectedDate(QDate::fromString(QString::fromStdString(days_.back().date), Qt::ISODate));
  show_days();
  if (row < 0)
    empty_curve(tr("No trial yet. Choose a scenario on the first page and practise it: each trial is a point here."));
  else
    ask_curve();
}

void ProgressTab::show_days() {
  const std::string chosen = calendar_->selectedDate().toString(Qt::ISODate).toStdString();
  QString text = tr("no trial on this day");
  for (const curricula::Day& day : days_)
    if (day.date == chosen) text = tr("%1 on this day").arg(words_of(day));
  day_->setText(text);
}

void ProgressTab::ask_curve() {
  const int row = list_->currentRow();
  if (row < 0 || row >= static_cast<int>(curves_.size())) return;
  const CurveKey key = curves_[static_cast<std::size_t>(row)].key;
  const curricula::Who who = desk_.who();
  desk_.ask<Curve>(
      this,
      [who, key](curricula::Records& records) {
        Curve curve{curricula::Progress(records).curve(who, key), {}};
        curve.to_rate = take_out(curve.seen, to_rate_first(records, who, curve.seen));
        return curve;
      },
      [this, key, asker = desk_.person().id](Curve curve) {
        if (desk_.person().id != asker) return;
        const int now = list_->currentRow();
        if (now < 0 || now >= static_cast<int>(curves_.size()) ||
            !same(curves_[static_cast<std::size_t>(now)].key, key))
          return;  // another was chosen meanwhile
        rows_ = std::move(curve.seen);
        show_curve(std::move(curve.to_rate));
      });
}

void ProgressTab::empty_curve(const QString& say) {
  rows_.clear();
  reading_ = {};
  learning_->show_content({tr("Learning curve"), {}, {}, say});
  sum_->show_content({tr("Cumulative sum (CUSUM)"), {}, {}, say});
  mastery_->clear();
  rule_->clear();
  trials_->show_trials(subject(), {}, {}, figure());
}

void ProgressTab::show_curve(std::vector<RecordRow> to_rate) {
  const long long whose = subject();
  if (rows_.empty()) {
    empty_curve(tr("Rate the assessment in the table below first: then it is a point here."));
    trials_->show_trials(whose, {}, std::move(to_rate), figure());
    return;
  }
  reading_ = read_curve(rows_, courses_.find(rows_.front().curriculum_id));
  sum_->show_content(cusum_chart(reading_));
  mastery_->setText(
      tr("Three in a row: %1.  CUSUM competent: %2.  Now: %3, %4 in a row.%5")
          .arg(after_trials(reading_.to_three_in_a_row), after_trials(reading_.to_competent),
               QString::fromStdString(verdict_in_words(reading_.cusum)))
          .arg(reading_.in_a_row)
          .arg(reading_.interrupted == 0 ? QString()
                                         : tr("  Interrupted: %1, counted in nothing.").arg(reading_.interrupted)) +
      (reading_.set_aside == 0
           ? QString()
           : tr("  Practised with help, changed by an instructor, or without an attempt: %1, counted in nothing.")
                 .arg(reading_.set_aside)));
  rule_->setText(QString::fromStdString(reading_.rule_in_words) + ' ' + tr("No pass mark is validated."));
  show_figure();
  trials_->show_trials(whose, rows_, std::move(to_rate), figure());
}

const Figure* ProgressTab::figure() const {
  return curricula::find_figure(figure_->currentData().toString().toStdString());
}

void ProgressTab::show_figure() {
  const Figure* chosen = figure();
  if (chosen == nullptr || rows_.empty()) return;
  learning_->show_content(
      learning_chart(rows_, *chosen, courses_.find(rows_.front().curriculum_id, rows_.front().scenario_id)));
}

}  // namespace vallecula::gui

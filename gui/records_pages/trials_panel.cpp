#include "gui/records_pages/trials_panel.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <filesystem>

#include "curricula/score/score.h"
#include "gui/pages/self_rating_page.h"
#include "gui/records_pages/curve_charts.h"
#include "gui/records_pages/hand_on.h"
#include "gui/records_pages/keep_ratings.h"
#include "gui/records_pages/rating_words.h"
#include "gui/records_pages/records_desk.h"
#include "gui/records_pages/tables.h"
#include "gui/records_pages/trial_log_here.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {

using curricula::Figure;
using curricula::Rating;
using curricula::RecordRow;

TrialsPanel::TrialsPanel(RecordsDesk& desk, const KnownCourses& courses, QWidget* parent)
    : QWidget(parent), desk_(desk), courses_(courses) {
  table_ =
      new_table(this, tr("Trials"),
                {tr("Trial"), tr("Ended"), tr("Mode"), tr("Result"), tr("Figure"), tr("Attempts"), tr("Length (s)")});
  ratings_ = new QLabel(this);
  ratings_->setObjectName("ratings");
  ratings_->setWordWrap(true);
  message_ = new QLabel(this);
  message_->setObjectName("trials_message");
  message_->setWordWrap(true);
  message_->setProperty("role", "faint");
  open_ = new QPushButton(tr("&Open"), this);
  rate_ = new QPushButton(tr("Ra&te ..."), this);
  hand_on_ = new HandOn(
      desk_,
      [this] {
        HandOn::Shown shown;
        shown.filter.trainee_id = trainee_id_;
        const int row = table_->currentRow();
        if (const RecordRow* trial = at(row); trial != nullptr && !hidden(row)) shown.trial = *trial;
        return shown;
      },
      this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(message_, 1);
  for (QPushButton* button : {open_, rate_, static_cast<QPushButton*>(hand_on_)}) buttons->addWidget(button);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(table_, 1);
  column->addWidget(ratings_);
  column->addLayout(buttons);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row, int, int, int) { row_chosen(row); });
  connect(table_, &QTableWidget::activated, this, [this](const QModelIndex& index) { open_row(index.row()); });
  connect(open_, &QPushButton::clicked, this, [this] { open_row(table_->currentRow()); });
  connect(rate_, &QPushButton::clicked, this, &TrialsPanel::ask_checklist);
  connect(hand_on_, &HandOn::told, message_, &QLabel::setText);
  row_chosen(-1);
}

const RecordRow* TrialsPanel::at(int table_row) const {
  if (table_row < 0 || table_row >= rows()) return nullptr;
  const auto index = static_cast<std::size_t>(table_row);
  return index < to_rate_.size() ? &to_rate_[to_rate_.size() - 1 - index]
                                 : &seen_[seen_.size() - 1 - (index - to_rate_.size())];
}

void TrialsPanel::show_trials(long long trainee_id, std::vector<RecordRow> seen, std::vector<RecordRow> to_rate,
                              const Figure* figure) {
  const RecordRow* before = at(table_->currentRow());
  const long long chosen_before = before == nullptr ? 0 : before->id;
  trainee_id_ = trainee_id;
  seen_ = std::move(seen);
  to_rate_ = std::move(to_rate);
  table_->setCurrentCell(-1, -1);
  show_figure(figure);
  for (int row = 0; row < rows(); ++row)
    if (at(row)->id == chosen_before && chosen_before != 0) table_->setCurrentCell(row, 0);
  row_chosen(table_->currentRow());
  message_->setText(rows() == 0 ? QString()
                                : tr("Squares, at their value but off the line, were interrupted or are not counted "
                                     "(practised with help, changed by an "
                                     "instructor, or without an attempt), crosses not passed, discs passed."));
}

void TrialsPanel::show_figure(const Figure* figure) {
  figure_ = figure;
  table_->setRowCount(rows());
  if (figure != nullptr) table_->horizontalHeaderItem(4)->setText(with_unit(*figure));
  for (int i = 0; i < rows(); ++i) {
    const RecordRow& row = *at(i);
    if (hidden(i)) {
      fill_row(table_, i,
               {"-", for_people(row.finished_utc), in_words(curricula::name_of(row.mode)), tr("rate it first"), "-",
                "-", "-"});
      continue;
    }
    const auto value = figure == nullptr ? std::nullopt : value_of(row, *figure);
    fill_row(table_, i,
             {QString::number(rows() - i), for_people(row.finished_utc), in_words(curricula::name_of(row.mode)),
              result_of(row), value ? short_decimal(*value, 4) : QString("-"),
              row.attempts > 0 ? QString::number(row.attempts) : QString("-"),
              row.duration_s ? decimal(*row.duration_s, 1) : QString("-")});
  }
}

void TrialsPanel::choose(int index) {
  table_->setCurrentCell(rows() - 1 - index, 0);
  table_->setFocus();
}

void TrialsPanel::open(int index) { open_row(rows() - 1 - index); }

void TrialsPanel::row_chosen(int table_row) {
  const bool any = at(table_row) != nullptr, first = hidden(table_row);
  open_->setEnabled(any);
  open_->setText(first ? tr("Rate it firs&t ...") : tr("&Open"));
  open_->setToolTip(tr("Enter, or a double click on the trial"));
  rate_->setVisible(desk_.instructor());
  rate_->setEnabled(any && !first);
  ratings_->clear();
  ratings_->setVisible(any);
  emit chosen(any && !first ? rows() - 1 - table_row : -1);
  if (first)
    ratings_->setText(
        tr("This assessment shows its figures, its result and its report once you have rated it yourself."));
  else if (any)
    ask_ratings();
}

void TrialsPanel::ask_ratings() {
  const long long trial = at(table_->currentRow())->id;
  const curricula::Who who = desk_.who();
  desk_.ask<std::vector<Rating>>(
      this, [who, trial](curricula::Records& records) { return curricula::Ratings(records).of_trial(who, trial); },
      [this, trial, asker = desk_.person().id](std::vector<Rating> ratings) {
        const RecordRow* now = at(table_->currentRow());
        if (now == nullptr || now->id != trial || desk_.person().id != asker) return;  // another was chosen meanwhile
        const QString words = words_of(ratings, asker);
        ratings_->setText(words.isEmpty() ? tr("Nobody has rated this trial.") : words);
      });
}

void TrialsPanel::open_row(int table_row) {
  const RecordRow* trial = at(table_row);
  if (trial == nullptr) return;
  if (hidden(table_row)) return rate_own(*trial);
  std::error_code error;
  if (std::filesystem::exists(trial->trial_path, error)) {
    emit trial_wanted(QString::fromStdString(trial->trial_path),
                      desk_.instructor() || curricula::rules_of(trial->mode).replay);
    return;
  }
  message_->setText(
      tr("This trial's files are not on this computer: they are on the station it was done at, or were moved."));
}

void TrialsPanel::rate_own(const RecordRow& row) {
  auto* dialog = new QDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Rate it first: %1").arg(for_people(row.finished_utc)));
  dialog->setMinimumWidth(560);
  auto* page = new SelfRatingPage(dialog);
  page->layout()->setContentsMargins(10, 10, 10, 10);
  auto* all = new QVBoxLayout(dialog);
  all->addWidget(page);
  curricula::Scenario asked;  // the course may be another or unknown by now; the row knows whether there was a tube
  asked.title = courses_.title(row.curriculum_id, row.scenario_id).toStdString();
  if (row.score.intubation) asked.intubation.emplace();
  connect(page, &SelfRatingPage::rated, this, [this, dialog, page, trial = row.id](const SelfRating& rating) {
    const curricula::Who who = desk_.who();
    desk_.ask<bool>(
        dialog,
        [who, trial, rating](curricula::Records& records) {
          keep_self_rating(records, who, trial, rating);
          return true;
        },
        [this, dialog](bool) {
          dialog->accept();
          emit own_rated();
        },
        [page](const QString& message) { page->set_message(message); });
  });
  page->ask(asked);
  dialog->open();
  page->setFocus();
}

/// The log, where it is on this computer, tells what it leaves to the instructor.
void TrialsPanel::ask_checklist() {
  const RecordRow* trial = at(table_->currentRow());
  if (trial == nullptr || !desk_.instructor()) return;
  rate_->setEnabled(false);
  message_->setText(tr("Reading the trial ..."));
  desk_.ask<Checklist>(
      this,
      [row = *trial, who = desk_.who()](curricula::Records& records) {
        Checklist found;
        found.ratings = curricula::Ratings(records).of_trial(who, row.id);
        try {
          const curricula::TrialLog log = read_log_here(row);
          const auto scenario = curricula::parse_scenario(log.header.scenario_yaml, row.scenario_id);
          for (const curricula::ChecklistItem& item : curricula::score_trial(log, scenario).checklist)
            if (item.done == curricula::ChecklistItem::Done::not_seen)
              found.items.push_back({item.id, QString::fromStdString(item.text)});
        } catch (const std::exception& error) {
          found.remark = QString::fromUtf8(error.what());  // all in all it can be rated nevertheless
        }
        return found;
      },
      [this, row = *trial](Checklist found) {
        message_->clear();
        rate_->setEnabled(at(table_->currentRow()) != nullptr);
        if (desk_.instructor()) rate(row, found);
      },
      [this](const QString& message) {
        message_->setText(message);
        rate_->setEnabled(true);
      });
}

void TrialsPanel::rate(const RecordRow& row, const Checklist& checklist) {
  std::map<std::string, double> before;
  for (const Rating& rating : checklist.ratings)
    if (rating.by == "instructor" && rating.author_id == desk_.person().id) before[rating.item] = rating.value;
  auto* dialog =
      new RatingDialog(this, courses_.title(row.curriculum_id, row.scenario_id) + ", " + for_people(row.finished_utc),
                       checklist.items, before, checklist.remark);
  connect(dialog, &RatingDialog::given, this, [this, dialog, trial = row.id] {
    keep_ratings(
        desk_, dialog, trial, dialog->ratings(),
        [this, dialog] {
          dialog->accept();
          message_->setText(tr("The rating is kept."));
          row_chosen(table_->currentRow());
        },
        [dialog](const QString& message) { dialog->refuse(message); });
  });
  dialog->open();
}

}  // namespace vallecula::gui

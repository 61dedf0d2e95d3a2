// The trials of one learning curve: their figures and ratings, to be opened, rated and handed on.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "curricula/records/ratings.h"
#include "curricula/score/figures.h"
#include "gui/records_pages/known_courses.h"
#include "gui/records_pages/rating_dialog.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace vallecula::gui {

class HandOn;
class RecordsDesk;

class TrialsPanel : public QWidget {
  Q_OBJECT
 public:
  TrialsPanel(RecordsDesk& desk, const KnownCourses& courses, QWidget* parent);
  /// `seen` in the order they were recorded; `to_rate`: the person's own assessments whose figures stay hidden until
  /// they are rated. `trainee_id`: whose they are.
  void show_trials(long long trainee_id, std::vector<curricula::RecordRow> seen,
                   std::vector<curricula::RecordRow> to_rate, const curricula::Figure* figure);
  void show_figure(const curricula::Figure* figure);
  void choose(int index);  ///< of `seen`
  void open(int index);    ///< of `seen`

 signals:
  void chosen(int index);  ///< of `seen`; -1: none of them
  void trial_wanted(const QString& log, bool with_replay);
  void own_rated();

 private:
  struct Checklist {
    std::vector<RatingDialog::Item> items;
    std::vector<curricula::Rating> ratings;
    QString remark;  ///< why there are no items
  };
  int rows() const { return static_cast<int>(to_rate_.size() + seen_.size()); }
  const curricula::RecordRow* at(int table_row) const;  ///< null: no such row
  bool hidden(int table_row) const { return table_row >= 0 && table_row < static_cast<int>(to_rate_.size()); }
  void row_chosen(int table_row);
  void ask_ratings();
  void open_row(int table_row);
  void rate_own(const curricula::RecordRow& row);
  void ask_checklist();
  void rate(const curricula::RecordRow& row, const Checklist& checklist);

  RecordsDesk& desk_;
  const KnownCourses& courses_;
  long long trainee_id_ = 0;
  std::vector<curricula::RecordRow> seen_, to_rate_;  ///< the table: to be rated first, then seen, the newest first
  const curricula::Figure* figure_ = nullptr;
  QTableWidget* table_;
  QLabel *message_, *ratings_;
  QPushButton *open_, *rate_;
  HandOn* hand_on_;
};

}  // namespace vallecula::gui

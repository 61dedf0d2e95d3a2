// One person's learning: curves, cumulative sum, mastery, calendar, and the trials behind them.
#pragma once

#include <QWidget>
#include <vector>

#include "curricula/records/people.h"
#include "curricula/score/figures.h"
#include "gui/records_pages/curve_reading.h"
#include "gui/records_pages/known_courses.h"
#include "gui/records_pages/trial_chart.h"

class QCalendarWidget;
class QComboBox;
class QLabel;
class QListWidget;

namespace vallecula::gui {

class RecordsDesk;
class TrialsPanel;

class ProgressTab : public QWidget {
  Q_OBJECT
 public:
  ProgressTab(RecordsDesk& desk, const KnownCourses& courses, QWidget* parent);
  void refresh();
  /// Whose, and which curve of theirs; an instructor's drill-down. An empty scenario: the first.
  void show_progress_of(const curricula::CurveKey& key);

 signals:
  /// The log of a trial that is on this computer. Of an assessment only an instructor gets the replay.
  void trial_wanted(const QString& log, bool with_replay);

 private:
  struct Subject {
    std::vector<curricula::Person> people;        ///< to choose from; an instructor's
    std::vector<curricula::CurveSummary> curves;  ///< without what is to be rated first
    std::vector<int> to_rate;                     ///< of each curve
    std::vector<curricula::Day> days;             ///< by local time
  };
  struct Curve {
    std::vector<curricula::RecordRow> seen, to_rate;
  };
  static Subject ask_subject(curricula::Records& records, const curricula::Who& who, long long of);
  QWidget* make_left();
  QWidget* make_right();
  long long subject() const;
  void fill_people(const std::vector<curricula::Person>& people);
  void show_subject(Subject subject);
  void forget();  ///< whoever signs in next sees nothing of it
  void show_days();
  void ask_curve();
  void show_curve(std::vector<curricula::RecordRow> to_rate);
  const curricula::Figure* figure() const;  ///< chosen
  void show_figure();
  void empty_curve(const QString& say);

  RecordsDesk& desk_;
  const KnownCourses& courses_;
  curricula::CurveKey wanted_;
  std::vector<curricula::CurveSummary> curves_;
  std::vector<curricula::Day> days_;
  std::vector<curricula::RecordRow> rows_;  ///< of the curve shown, in the order they were recorded; those to be seen
  CurveReading reading_;
  QComboBox *whose_, *figure_;
  QLabel *whose_label_, *day_, *mastery_, *rule_;
  QListWidget* list_;
  QCalendarWidget* calendar_;
  TrialChart *learning_, *sum_;
  TrialsPanel* trials_;
};

}  // namespace vallecula::gui

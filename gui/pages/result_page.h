// What came of a trial: passed or not, where the tube lies, what to change, the figures, force and monitor over time,
// and every reason.
#pragma once

#include <QWidget>

#include "curricula/scenario.h"
#include "gui/session/trial_session.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace vallecula::gui {

class ChartView;
class LogOnDemand;

class ResultPage : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPage(QWidget* parent = nullptr);
  /// `folder`: where a person will find the results. `misfits`: why scenario and patient do not belong together.
  void show_outcome(const TrialOutcome& outcome, const curricula::Scenario& scenario,
                    const std::filesystem::path& folder, const std::vector<std::string>& misfits);
  void tell(const QString& message);  ///< what went wrong since; empty: nothing

 signals:
  void again();       ///< of a scenario with a variation another attempt, as drawn anew
  void same_again();  ///< what has just been done, as it was drawn
  void left();
  void other_wanted();  ///< another scenario, with the same patient
  /// At a second of the trial; negative: from its beginning.
  void replay_wanted(double at_s);

 protected:
  void hideEvent(QHideEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void show_charts(const TrialOutcome& outcome, const curricula::Scenario& scenario);
  void show_figures(const TrialOutcome& outcome, const curricula::Scenario& scenario);
  QLabel *title_, *verdict_, *outcome_, *change_, *reasons_, *where_, *told_;
  QPushButton *replay_, *again_, *same_;
  QGridLayout* figures_;
  ChartView *plot_, *monitor_;
  std::shared_ptr<LogOnDemand> log_;
  std::filesystem::path report_;
};

}  // namespace vallecula::gui

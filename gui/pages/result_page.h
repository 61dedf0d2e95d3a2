// What came of a trial: passed or not, what to change, the figures, force over time, and every reason.
#pragma once

#include <QPixmap>
#include <QWidget>

#include "curricula/scenario.h"
#include "gui/session/trial_session.h"

class QGridLayout;
class QLabel;

namespace vallecula::gui {

class ResultPage : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPage(QWidget* parent = nullptr);
  /// `folder`: where a person will find the results. `misfits`: why scenario and patient do not belong together.
  void show_outcome(const TrialOutcome& outcome, const curricula::Scenario& scenario,
                    const std::filesystem::path& folder, const std::vector<std::string>& misfits);

 signals:
  void again();
  void left();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fit_plot();
  void show_figures(const TrialOutcome& outcome, const curricula::Scenario& scenario);
  QLabel *title_, *verdict_, *change_, *plot_, *reasons_, *where_;
  QGridLayout* figures_;
  QPixmap plot_picture_;
  std::filesystem::path report_;
};

}  // namespace vallecula::gui

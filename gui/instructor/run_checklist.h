// The checklist while a trial runs: ticked by whoever watches, kept as an instructor's rating once the trial is
// recorded.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "curricula/records/ratings.h"
#include "curricula/scenario.h"
#include "curricula/score/checklist_to_watch.h"

class QButtonGroup;
class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace vallecula::gui {

class RunChecklist : public QWidget {
  Q_OBJECT
 public:
  explicit RunChecklist(QWidget* parent = nullptr);
  /// The items of this scenario, none ticked.
  void begin(const curricula::Scenario& scenario);
  /// The trial is in the records. What its log decided stands beside the ticks and is not the instructor's to give.
  /// `why_not`: why no rating can be kept here; empty: it can.
  void recorded(const std::vector<curricula::ChecklistItem>& decided, const QString& why_not);
  /// An instructor's, of what was ticked and is theirs to give.
  std::vector<curricula::Rating> ratings() const;
  void kept();
  void refuse(const QString& message);

 signals:
  void keep_wanted();

 private:
  struct Row {
    std::string id;
    QString text;
    QToolButton *yes, *no;
    QLabel* recording;
    bool decided = false;
  };
  QToolButton* tick(const QString& text, const QString& meaning);
  void show_button();

  QGridLayout* grid_;
  QWidget* rows_widget_ = nullptr;
  std::vector<Row> rows_;
  std::vector<QToolButton*> steps_;
  QLabel* message_;
  QPushButton* keep_;
  bool may_keep_ = false;
};

}  // namespace vallecula::gui

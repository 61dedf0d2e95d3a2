// After an assessment, before its score: how the trainees themselves think it went.
#pragma once

#include <QWidget>

#include "curricula/scenario.h"
#include "gui/session/self_rating.h"

class QButtonGroup;
class QLabel;
class QPushButton;

namespace vallecula::gui {

class SelfRatingPage : public QWidget {
  Q_OBJECT
 public:
  explicit SelfRatingPage(QWidget* parent = nullptr);
  /// Asks anew, of a trial at this scenario.
  void ask(const curricula::Scenario& scenario);
  /// Why the answer could not be kept; the person may try again.
  void set_message(const QString& message);
  /// Once it asks the person to stay and rate; never while an answer is on its way into the records.
  bool may_close();

 signals:
  void rated(const vallecula::gui::SelfRating& rating);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  SelfRating answer() const;
  void show_button();

  QLabel *title_, *message_;
  QButtonGroup *global_, *place_, *sure_;
  QWidget* of_tube_;
  QPushButton* done_;
  bool with_tube_ = false;
  bool keeping_ = false;  ///< an answer was given, and is not kept yet
  bool asked_to_stay_ = false;
};

}  // namespace vallecula::gui

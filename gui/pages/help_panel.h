// Helps in reach while a trial runs, each a button and a key: from the vallecula on, an expert's loop, one's own head a
// little aside, the infant's head extended.
#pragma once

#include <QWidget>
#include <array>

#include "gui/session/hand_actions.h"

class QAbstractButton;
class QPushButton;
class QToolButton;

namespace vallecula::gui {

class HelpPanel : public QWidget {
  Q_OBJECT
 public:
  explicit HelpPanel(QWidget* parent = nullptr);
  /// Whose bits are set from now on; nullptr: nobody's.
  void serve(HandActions* actions);
  /// Why these cannot be had now, for a person; empty: they can. `running`: the trial is; until it is, and once it was,
  /// neither a button nor its key does anything.
  void offer(const QString& no_vallecula, const QString& no_expert, bool running);
  /// One's own head by a step to a side (-1, 0, 1), and from the other side back to the middle; the same again: back.
  void move_eye(int right, int up);
  void extend();
  /// Shows what is held.
  void refresh();
  QPushButton* vallecula() { return vallecula_; }
  QPushButton* expert() { return expert_; }

 private:
  void step(engine::Action there, engine::Action other);
  bool held(engine::Action action) const { return actions_ != nullptr && actions_->held(action); }

  struct Eye {
    int right, up;
    engine::Action action, opposite;
    QToolButton* button;
    QString tip;
  };
  HandActions* actions_ = nullptr;
  QPushButton *vallecula_, *expert_, *extend_;
  std::array<Eye, 4> eyes_;
};

}  // namespace vallecula::gui

// What a person asks for beside steering: breaths, suction, pressure on the larynx, catheter, stylet, the other hand.
// By key, or by a button that is held as long.
#pragma once

#include <QWidget>
#include <array>
#include <map>
#include <vector>

#include "engine/snapshot.h"
#include "gui/pages/key_list.h"
#include "gui/session/hand_actions.h"

class QKeyEvent;
class QPushButton;

namespace vallecula::gui {

class HandPanel : public QWidget {
  Q_OBJECT
 public:
  explicit HandPanel(QWidget* parent = nullptr);
  /// Whose bits are set from now on; nullptr: nobody's. `switches`: one device drives both hands in turn. What was held
  /// is let go.
  void serve(HandActions* actions, bool switches);
  /// Before the start and after the end nothing of it can be had: it is grey and says so.
  void set_running(bool running);
  bool serving() const { return actions_ != nullptr; }
  /// True when the key is one of these. Space gives a breath like B where nothing else takes it.
  bool key(QKeyEvent* event, bool pressed);
  /// Of those in use.
  std::vector<KeyRow> keys() const;
  /// Lets go of all that is held; catheter or tube in hand stays.
  void release_all();
  /// What may be asked for, as hands and tools stand.
  void show_snapshot(const engine::Snapshot& snapshot);

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Held {
    engine::Action action;
    QPushButton* button;
    std::array<int, 2> keys;
  };
  void hold(const Held& held, bool on);
  void change_catheter();
  void keep_room();

  HandActions* actions_ = nullptr;
  /// What is done once, as its key goes down.
  struct Once {
    QPushButton* button;
    std::array<int, 3> keys;
  };
  std::array<Held, 4> held_;
  std::array<Once, 2> once_;
  std::map<QPushButton*, QString> tips_;  ///< of each button, while it can be had
  QPushButton *catheter_, *other_hand_;
};

}  // namespace vallecula::gui

// What an instructor does to a trial that runs: freeze it, change the infant's vital signs, have the team say
// something.
#pragma once

#include <QWidget>
#include <cstdint>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace vallecula::gui {

class InstructorControls : public QWidget {
  Q_OBJECT
 public:
  explicit InstructorControls(QWidget* parent = nullptr);
  /// What the present trial allows. `vital_signs`: it has an infant's; `spasm`: whose cords can close, for they are not
  /// relaxed; `assessment`: the rules of an assessment; `instructor`: in one, that an instructor is signed in here.
  void allow(bool running, bool vital_signs, bool spasm, bool assessment, bool instructor);
  void show_frozen(bool frozen);
  void tell(const QString& message);  ///< why something was not done; empty: nothing
  void release_all();

 signals:
  void freeze_wanted(bool on);
  /// A bit of engine::Action, as the button goes down and up: at least kLeastHoldMs apart.
  void vital_sign(std::uint32_t action, bool down);
  void say_wanted(const QString& line);

 private:
  QPushButton* vital_button(const QString& text, const QString& tip, std::uint32_t action);
  void say();

  QPushButton* freeze_;
  std::vector<std::pair<QPushButton*, std::uint32_t>> vital_;
  QComboBox* line_;  ///< editable: a ready sentence or any other
  QPushButton* say_;
  QLabel *rules_, *message_;
  int allowed_ = -1;  ///< as allow() was told last
};

/// So long a vital sign is driven by a click at least.
constexpr int kLeastHoldMs = 300;

}  // namespace vallecula::gui

// What an instructor does to a trial that runs: freeze it, change the infant's vital signs, have the team say
// something.
#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace vallecula::gui {

class InstructorControls : public QWidget {
  Q_OBJECT
 public:
  explicit InstructorControls(QWidget* parent = nullptr);
  /// What the present trial allows.
  struct Trial {
    bool open = false, running = false;
    bool stands = false;       ///< held or paused: the infant's clock stands with it
    bool vital_signs = false;  ///< it has an infant's
    bool spasm = false;        ///< whose cords can close, for they are not relaxed
    bool assessment = false, instructor = false;  ///< its rules; in one, an instructor is signed in here
    bool operator==(const Trial& other) const;
  };
  void allow(const Trial& trial);
  void show_frozen(bool frozen);
  /// Leaves the line that is being written; false: none is.
  bool leave_line();
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
  struct Vital {
    QPushButton* button;
    std::uint32_t action;
    QString tip;
  };
  QString refusal(const Trial& trial, std::uint32_t action) const;  ///< of a vital sign; empty: it is had
  std::vector<Vital> vital_;
  QComboBox* line_;  ///< editable: a ready sentence or any other
  QPushButton* say_;
  QLabel *rules_, *message_;
  std::optional<Trial> allowed_;  ///< as allow() was told last
};

/// So long a vital sign is driven by a click at least.
constexpr int kLeastHoldMs = 300;

}  // namespace vallecula::gui

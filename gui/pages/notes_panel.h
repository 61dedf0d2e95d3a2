// Notes on a replay, each at a second of the trial: list, write, take away, jump.
#pragma once

#include <QPointer>
#include <QThread>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <vector>

#include "curricula/records/notes.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace vallecula::gui {

class TimedList;

class NotesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit NotesPanel(QWidget* parent = nullptr);
  ~NotesPanel() override;
  /// Notes of the trial whose log this is, by its record; one that is in no record can have none, and it says so.
  void open(const std::filesystem::path& log_file);
  /// Who reads and writes: the records' rules say who may.
  void set_who(const curricula::Who& who);
  /// Where a note that is written now will stand.
  void show_time(double at_s);
  void write();  ///< to the field
  bool busy() const { return working_ && !working_->isFinished(); }  ///< the thread's object outlives its work

 signals:
  void wanted(double at_s);
  void listed(const std::vector<double>& at_s);

 private:
  void tell(const QString& message);  ///< what is wrong; empty: nothing is
  /// Asks the records on a thread of its own: they may be on a server.
  void ask(std::function<void(curricula::Notes&, long long trial)> change);
  void show_notes(const std::vector<curricula::Note>& notes);
  void add();
  void remove();
  void allow(bool on);

  TimedList* list_;
  QLineEdit* text_;
  QPushButton *add_, *remove_;
  QLabel* told_;
  curricula::Who who_;
  std::filesystem::path log_file_;
  QPointer<QThread> working_;
  double at_s_ = 0.0, now_s_ = 0.0;  ///< of the note, of the replay
  int opened_ = 0;
};

}  // namespace vallecula::gui

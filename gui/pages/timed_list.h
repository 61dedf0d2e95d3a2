// A list of sentences, each with a second of the trial: a click or Enter on one goes there.
#pragma once

#include <QListWidget>

namespace vallecula::gui {

class TimedList : public QListWidget {
  Q_OBJECT
 public:
  explicit TimedList(const QString& name, QWidget* parent = nullptr);
  /// `at_s` below 0: it has no second, and cannot be gone to. `id`: the caller's own.
  void add(double at_s, const QString& text, const QColor& colour, const QString& tip = {}, long long id = 0);
  double time_of(int row) const;
  long long id_of(int row) const;
  /// Moves the cursor to the last one at or before this second, without a signal.
  void follow(double at_s);

 signals:
  void wanted(double at_s);

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace vallecula::gui

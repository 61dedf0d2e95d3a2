// The menu by which trials are handed on: as a table, as reports on paper.
#pragma once

#include <QPushButton>
#include <functional>
#include <optional>

#include "curricula/export/trial_table.h"

class QAction;

namespace vallecula::gui {

class RecordsDesk;

class HandOn : public QPushButton {
  Q_OBJECT
 public:
  /// What is shown when the menu is opened.
  struct Shown {
    curricula::ExportFilter filter;                         ///< with trainee_id: that trainee's report can be had
    std::function<bool(const curricula::RecordRow&)> with;  ///< which of those; empty: all. Called on another thread
    std::optional<curricula::RecordRow> trial;              ///< chosen; nothing: none whose figures may be seen
  };
  HandOn(RecordsDesk& desk, std::function<Shown()> shown, QWidget* parent);

  /// Each writes `file` on the desk's thread and tells() what became of it.
  void write_table(const QString& file);
  void write_trial_report(const QString& file);
  void write_trainee_report(const QString& file);

 signals:
  void told(const QString& message);

 private:
  using Trials = std::vector<curricula::ExportTrial>;
  void ask_where(const QString& kind, const QString& ending, void (HandOn::*write)(const QString&));
  /// `write` gets the trials, at least one, on the desk's thread.
  void hand_on(Shown shown, const QString& file, std::function<void(const Trials&, bool names)> write);
  void update_menu();

  RecordsDesk& desk_;
  std::function<Shown()> shown_;
  QAction *table_, *trial_, *trainee_, *names_;
};

}  // namespace vallecula::gui

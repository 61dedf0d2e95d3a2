// A course as a tree: its modules in order with what is open, closed and mastered, their scenarios with what was
// passed.
#pragma once

#include <QTreeWidget>
#include <string>
#include <vector>

#include "curricula/progress/progress.h"

namespace vallecula::gui {

class ModuleTree : public QTreeWidget {
  Q_OBJECT
 public:
  explicit ModuleTree(QWidget* parent = nullptr);

  /// Shows this course (null: none; it must outlive being shown) by what was done of it with `hands`
  /// (LogHeader::device_kind). The row that was chosen stays chosen, or the one where somebody goes on is: open, and
  /// not passed yet. `all_open`: nothing waits for anything.
  void show_course(const curricula::Curriculum* course, const std::vector<curricula::PastResult>& past,
                   const std::string& hands, bool all_open);
  /// The row of this scenario; nothing happens where there is none.
  void choose(const std::string& scenario_id);

  /// What the chosen row stands for; null: for something else. The course's own row stands for neither.
  const curricula::Scenario* scenario() const;
  const curricula::Module* module() const;
  const curricula::ModuleProgress& progress_of(const curricula::Module& module) const;
  /// Empty: it may be started.
  QString why_closed(const curricula::Scenario& scenario) const;
  /// "Handling the blade: open", one a module.
  QStringList states() const;

 signals:
  void chosen();  ///< another row, or the same with another state

 private:
  void add_scenario(QTreeWidgetItem* to, const std::string& id, bool passed);
  QString state(std::size_t module) const;
  QTreeWidgetItem* item_of(const QString& key) const;
  QTreeWidgetItem* next_to_do() const;
  QString chosen_key() const;

  const curricula::Curriculum* course_ = nullptr;
  std::vector<curricula::ModuleProgress> progress_;
  bool all_open_ = false;
};

}  // namespace vallecula::gui

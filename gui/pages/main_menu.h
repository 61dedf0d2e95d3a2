// The window's menu bar: what can be done from every page. What is under way (a trial) hides it.
#pragma once

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <vector>

#include "gui/pages/recent_entry.h"

namespace vallecula::gui {

class MainMenu : public QObject {
  Q_OBJECT
 public:
  explicit MainMenu(QMainWindow& window);
  /// `hidden`: no menus and none of their keys. `may_leave`: another page may be gone to.
  void set_state(bool hidden, bool may_leave);
  void set_recent(const std::vector<RecentEntry>& recent);
  QMenu& view() { return *view_; }  ///< for further windows of this one

 signals:
  void home_wanted();
  void course_wanted();
  void records_wanted();
  void devices_wanted();
  void open_wanted();
  void recent_wanted(const QString& path);
  void import_wanted();
  void writing_wanted();
  void settings_wanted();
  void quit_wanted();
  void ground_wanted(const QString& ground);
  void text_wanted(int steps);  ///< larger or smaller; 0: as it was made
  void help_wanted();
  void first_steps_wanted();
  void log_wanted();
  void about_wanted();

 private:
  void make_file(QMainWindow& window);
  void make_view(QMainWindow& window);
  void make_help(QMainWindow& window);
  QAction* add(QMenu* to, const QString& text, const QKeySequence& key, void (MainMenu::*wanted)(),
               const QString& name);

  QMainWindow& window_;
  QMenu *file_, *recent_, *view_, *help_;
  std::vector<QAction*> leaving_;  ///< go to another page
};

}  // namespace vallecula::gui

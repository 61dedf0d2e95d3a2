// The course, its modules and their scenarios, to be chosen and put in another order.
#pragma once

#include <QTreeWidget>

#include "gui/authoring/course_document.h"

namespace vallecula::gui {

class CourseTree : public QTreeWidget {
  Q_OBJECT
 public:
  CourseTree(CourseDocument& document, QWidget* parent);
  QString part() const;  ///< "" (the course), "modules[1]", "scenarios[3]"
  void choose(const QString& part);
  /// The module that the chosen row is in or is; 0 where there is none.
  std::size_t module() const;

 public slots:
  void move_up() { shift(-1); }
  void move_down() { shift(1); }

 signals:
  void chosen(const QString& part);
  void refused(const QString& why);

 protected:
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void mark_problems();
  void shift(int by);
  void move_scenario(const QString& part, std::size_t module, std::size_t position);
  QTreeWidgetItem* item_of(const QString& part) const;

  CourseDocument& document_;
  QStringList rows_;  ///< what is shown; other rows need another tree
  bool refreshing_ = false;
};

}  // namespace vallecula::gui

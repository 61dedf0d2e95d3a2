// Everything that is wrong with the course, in words; a row leads to its field.
#pragma once

#include <QTreeWidget>

#include "gui/authoring/course_document.h"

namespace vallecula::gui {

class ProblemList : public QTreeWidget {
  Q_OBJECT
 public:
  ProblemList(CourseDocument& document, QWidget* parent);

 signals:
  void wanted(const QString& field, int line);

 private:
  void refresh();
  QString place_of(const curricula::Problem& problem) const;
  CourseDocument& document_;
};

}  // namespace vallecula::gui

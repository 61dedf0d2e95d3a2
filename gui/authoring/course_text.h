// The course as the file has it: YAML, with the lines that something is wrong with marked.
#pragma once

#include <QPlainTextEdit>

#include "gui/authoring/course_document.h"

namespace vallecula::gui {

class CourseText : public QPlainTextEdit {
  Q_OBJECT
 public:
  CourseText(CourseDocument& document, QWidget* parent);
  void go_to(int line);  ///< from 1
  int line() const { return textCursor().blockNumber() + 1; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void follow();
  void mark_problems();
  CourseDocument& document_;
  bool following_ = false;
};

}  // namespace vallecula::gui

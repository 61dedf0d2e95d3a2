#include "gui/authoring/course_text.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QTextBlock>
#include <algorithm>

#include "gui/views/theme.h"

namespace vallecula::gui {

CourseText::CourseText(CourseDocument& document, QWidget* parent) : QPlainTextEdit(parent), document_(document) {
  setAccessibleName(tr("The course's text"));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setUndoRedoEnabled(false);  // the document has its own, for form and text together
  theme::dress(*this, QString("QPlainTextEdit { font-family: \"%1\"; font-size: @10pt@; }")
                          .arg(QFontDatabase::systemFont(QFontDatabase::FixedFont).family()));
  connect(&document_, &CourseDocument::changed, this, &CourseText::follow);
  connect(&document_, &CourseDocument::problems_changed, this, &CourseText::mark_problems);
  connect(this, &QPlainTextEdit::textChanged, this, [this] {
    if (following_) return;
    following_ = true;
    QString text = this->document()->toRawText();  // toPlainText would change no-break spaces
    text.replace(QChar::ParagraphSeparator, '\n');
    document_.set_text(text, tr("Type"), "typing");
    following_ = false;
  });
}

void CourseText::follow() {
  setReadOnly(document_.read_only());
  if (following_) return;
  QString now = document()->toRawText();
  now.replace(QChar::ParagraphSeparator, '\n');
  const QString& text = document_.text();
  if (now == text) return;
  // Only what differs is replaced: the view stays where it is.
  int head = 0, tail = 0;
  const int shorter = std::min(now.size(), text.size());
  while (head < shorter && now[head] == text[head]) ++head;
  while (tail < shorter - head && now[now.size() - 1 - tail] == text[text.size() - 1 - tail]) ++tail;
  following_ = true;
  QTextCursor cursor(document());
  cursor.setPosition(head);
  cursor.setPosition(now.size() - tail, QTextCursor::KeepAnchor);
  cursor.insertText(text.mid(head, text.size() - tail - head));
  following_ = false;
}

void CourseText::mark_problems() {
  QList<QTextEdit::ExtraSelection> marks;
  for (const curricula::Problem& problem : document_.problems()) {
    const QTextBlock block = document()->findBlockByNumber(std::max(0, problem.line - 1));
    if (problem.line == 0 || !block.isValid()) continue;
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(block);
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    QColor colour = theme::bad();
    colour.setAlpha(90);
    mark.format.setBackground(colour);
    marks << mark;
  }
  setExtraSelections(marks);
}

void CourseText::go_to(int line) {
  const QTextBlock block = document()->findBlockByNumber(std::max(0, line - 1));
  if (!block.isValid()) return;
  setTextCursor(QTextCursor(block));
  centerCursor();
  setFocus();
}

void CourseText::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) document_.end_merging();  // a line is a step
  QPlainTextEdit::keyPressEvent(event);
}

}  // namespace vallecula::gui

#include "gui/report/markdown.h"

#include <QLocale>
#include <QRegularExpression>
#include <QTextDocument>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

namespace {

/// In this user's language; empty where there is none.
bool read_markdown(const curricula::Text& text, QTextDocument& document) {
  const std::string language = QLocale().name().replace('_', '-').toStdString();
  const std::string markdown = text.in(language);
  document.setMarkdown(
      course_words(markdown),
      QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectCommonMark | QTextDocument::MarkdownNoHTML));
  return !markdown.empty();
}

}  // namespace

QString plain_of(const curricula::Text& text) {
  QTextDocument document;
  return read_markdown(text, document) ? document.toPlainText() : QString();
}

QString html_of(const curricula::Text& text) {
  QTextDocument document;
  if (!read_markdown(text, document)) return {};
  const QString page = document.toHtml();
  const int body = page.indexOf('>', page.indexOf("<body")) + 1;
  QString html = page.mid(body, page.indexOf("</body>") - body);
  html.remove(QRegularExpression("</?(a|img)\\b[^>]*>"));
  html.replace(QRegularExpression("<span style=\"[^\"]*font-weight:[^\"]*\">([^<]*)</span>"), "<b>\\1</b>");
  html.replace(QRegularExpression("<span style=\"[^\"]*font-style:italic[^\"]*\">([^<]*)</span>"), "<i>\\1</i>");
  html.remove(QRegularExpression(" style=\"[^\"]*\""));  // the page's own style is kept
  return html;
}

}  // namespace vallecula::gui

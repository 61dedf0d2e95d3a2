#include "gui/report/markdown.h"

#include <QLocale>
#include <QRegularExpression>
#include <QTextDocument>

namespace vallecula::gui {

QString html_of(const curricula::Text& text) {
  const std::string language = QLocale().name().replace('_', '-').toStdString();
  const std::string markdown = text.in(language);
  if (markdown.empty()) return {};
  QTextDocument document;
  document.setMarkdown(
      QString::fromStdString(markdown),
      QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectCommonMark | QTextDocument::MarkdownNoHTML));
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

#include "gui/session/words_from_below.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "gui/session/from_below/sentences.h"

namespace vallecula::gui {

QString in_words(const std::string& text) {
  if (text.empty()) return {};
  const QString as_it_is = QString::fromStdString(text);
  const QString whole = QCoreApplication::translate("FromBelow", text.c_str());
  if (whole != as_it_is) return whole;
  // A figure in a sentence is a place to fill in: "at most 6.80 N" is looked for as "at most %1 N".
  static const QRegularExpression figure("(?<![A-Za-z0-9.])-?\\d+(\\.\\d+)?");
  QString pattern;
  QStringList figures;
  int end = 0;
  for (auto found = figure.globalMatch(as_it_is); found.hasNext();) {
    const QRegularExpressionMatch one = found.next();
    figures << one.captured();
    pattern += as_it_is.mid(end, one.capturedStart() - end) + '%' + QString::number(figures.size());
    end = one.capturedEnd();
  }
  if (figures.isEmpty() || figures.size() > 9) return as_it_is;
  pattern += as_it_is.mid(end);
  QString filled = QCoreApplication::translate("FromBelow", pattern.toUtf8().constData());
  if (filled == pattern) return as_it_is;
  for (int i = figures.size(); i > 0; --i) filled.replace('%' + QString::number(i), figures[i - 1]);
  return filled;
}

std::vector<std::string> sentences_from_below() {
  std::vector<std::string> all;
  for (const auto& some : {from_below::device(), from_below::pipeline(), from_below::scores(), from_below::courses(),
                           from_below::trials()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace vallecula::gui

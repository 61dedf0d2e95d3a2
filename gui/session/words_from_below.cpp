#include "gui/session/words_from_below.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <optional>
#include <unordered_set>

#include "gui/session/from_below/sentences.h"

namespace vallecula::gui {
namespace {

/// A sentence with places for words, and how one that was put together by it is told.
struct Built {
  std::string sentence;
  QRegularExpression whole;
};

QString translated(const QString& text) { return QCoreApplication::translate("FromBelow", text.toUtf8().constData()); }

bool is_listed(const QString& text) {
  static const std::unordered_set<std::string> all = [] {
    const std::vector<std::string> listed = sentences_from_below();
    return std::unordered_set<std::string>(listed.begin(), listed.end());
  }();
  return all.count(text.toStdString()) > 0;
}

const std::vector<Built>& built_sentences() {
  static const std::vector<Built> all = [] {
    std::vector<Built> made;
    static const QRegularExpression place("%\\d");
    for (const std::string& sentence : from_below::built()) {
      const QString text = QString::fromStdString(sentence);
      QString pattern;
      int end = 0;
      for (auto found = place.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch one = found.next();
        pattern += QRegularExpression::escape(text.mid(end, one.capturedStart() - end)) + "(.+?)";
        end = one.capturedEnd();
      }
      pattern += QRegularExpression::escape(text.mid(end));
      made.push_back({sentence, QRegularExpression(QRegularExpression::anchoredPattern(pattern))});
    }
    return made;
  }();
  return all;
}

/// As people here write it: the figures of the folders below have a point.
QString as_written_here(QString figure) {
  const QChar point = QLocale().decimalPoint();
  return point == '.' ? figure : figure.replace('.', point);
}

QString fill(QString sentence, const QStringList& places) {
  for (int i = places.size(); i > 0; --i) sentence.replace('%' + QString::number(i), places[i - 1]);
  return sentence;
}

std::optional<QString> known(const QString& text);

/// "good depth, too deep", "good-depth or too-deep", "2 right, 1 wrong": each part is listed.
std::optional<QString> known_list(const QString& text) {
  for (const auto& [between, words] : {std::pair{", ", QString(", ")}, {" or ", ' ' + translated("or") + ' '}}) {
    const QStringList parts = text.split(between);
    if (parts.size() < 2) continue;
    QStringList told;
    for (const QString& part : parts)
      if (const auto one = known(part)) told << *one;
    if (told.size() == parts.size()) return told.join(words);
  }
  return std::nullopt;
}

std::optional<QString> known(const QString& text) {
  if (is_listed(text)) return translated(text);
  // A figure in a sentence is a place to fill in: "at most 6.80 N" is looked for as "at most %1 N".
  static const QRegularExpression figure("(?<![A-Za-z0-9.])-?\\d+(\\.\\d+)?");
  QString pattern;
  QStringList figures;
  int end = 0;
  for (auto found = figure.globalMatch(text); found.hasNext();) {
    const QRegularExpressionMatch one = found.next();
    figures << as_written_here(one.captured());
    pattern += text.mid(end, one.capturedStart() - end) + '%' + QString::number(figures.size());
    end = one.capturedEnd();
  }
  pattern += text.mid(end);
  if (!figures.isEmpty() && figures.size() <= 9 && is_listed(pattern)) return fill(translated(pattern), figures);
  static const QRegularExpression value("^-?\\d+(\\.\\d+)?( [^\\s\\d.]{1,6})?$");  // a figure, with its unit or alone
  if (value.match(text).hasMatch()) return as_written_here(text);
  static const QRegularExpression name("^[a-z]+([_-][a-z]+)+$");  // as files have it
  if (name.match(text).hasMatch()) {
    const QString words = QString(text).replace('_', ' ').replace('-', ' ');
    const auto told = known(words);
    return told == words ? std::nullopt : told;  // in English names stay as files have them
  }
  for (const Built& built : built_sentences()) {
    const QRegularExpressionMatch found = built.whole.match(text);
    if (!found.hasMatch()) continue;
    QStringList places;
    for (int i = 1; i <= found.lastCapturedIndex(); ++i) places << known(found.captured(i)).value_or(found.captured(i));
    return fill(translated(QString::fromStdString(built.sentence)), places);
  }
  return known_list(text);
}

}  // namespace

QString in_words(const std::string& text) {
  const QString as_it_is = QString::fromStdString(text);
  return as_it_is.isEmpty() ? as_it_is : known(as_it_is).value_or(as_it_is);
}

QString course_words(const std::string& text) {
  static const std::unordered_set<std::string> shipped = [] {
    const std::vector<std::string> all = from_below::shipped_courses();
    return std::unordered_set<std::string>(all.begin(), all.end());
  }();
  std::string words = text;
  while (!words.empty() && words.back() == '\n') words.pop_back();  // a block of YAML ends with one
  return shipped.count(words) > 0 ? QCoreApplication::translate("Courses", words.c_str())
                                  : QString::fromStdString(text);
}

QString decimal(double value, int digits) {
  QLocale here;
  here.setNumberOptions(QLocale::OmitGroupSeparator);
  return here.toString(value, 'f', digits);
}

QString short_decimal(double value, int significant) {
  return as_written_here(QString::number(value, 'g', significant));
}

std::vector<std::string> sentences_from_below() {
  std::vector<std::string> all;
  for (const auto& some : {from_below::device(), from_below::pipeline(), from_below::scores(), from_below::reasons(),
                           from_below::courses(), from_below::trials()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace vallecula::gui

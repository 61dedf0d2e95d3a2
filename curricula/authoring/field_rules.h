// What a form must know of each field of a curriculum, out of the schema alone.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace vallecula::curricula {

struct FieldRule {
  enum class Kind {
    number,
    whole_number,
    truth,       ///< true or false
    word,        ///< one of `words`
    plain_text,  ///< one line or more
    text,        ///< Markdown, in one language or several
    words,       ///< a list out of `words`, or of ids where there are none
    texts,       ///< a list of texts
    range,       ///< a list of two numbers, from and to
    group,       ///< `fields`
    groups,      ///< a list of groups of `fields`
  };
  Kind kind = Kind::plain_text;
  QString name, label;  ///< as in the file; in plain words
  QString unit, help;
  QString left_out;  ///< what holds where the field is not given; may be empty
  bool required = false;
  double minimum = 0.0, maximum = 0.0;  ///< of numbers
  int longest = 0;                      ///< characters of a text
  QStringList words;
  bool words_are_text = false;  ///< tubes are named, catheters counted
  std::vector<FieldRule> fields;

  QString allowed() const;  ///< "0.6 to 4.5 kg"
};

/// The fields of "curriculum", "module", "scenario", ... (a definition of the schema), the required ones first, in the
/// order people fill them in; those in `skipped` are left away.
std::vector<FieldRule> fields_of(const char* schema_json, const QString& definition, const QStringList& skipped = {});
/// "peak_tongue_force_n" -> "Peak tongue force".
QString label_of(const QString& name);

}  // namespace vallecula::curricula

#include "gui/authoring/field_words.h"

#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

void translate(std::vector<curricula::FieldRule>& rules) {
  for (curricula::FieldRule& rule : rules) {
    rule.label = in_words(rule.label.toStdString());
    rule.help = in_words(rule.help.toStdString());
    translate(rule.fields);
  }
}

}  // namespace

std::vector<curricula::FieldRule> fields_in_words(const char* schema_json, const QString& definition,
                                                  const QStringList& skipped) {
  std::vector<curricula::FieldRule> rules = curricula::fields_of(schema_json, definition, skipped);
  translate(rules);
  return rules;
}

}  // namespace vallecula::gui

// The fields of a curriculum as the schema has them, named and explained in the window's language.
#pragma once

#include "curricula/authoring/field_rules.h"

namespace vallecula::gui {

/// curricula::fields_of() with label and help of every field, inner ones too, in the window's language.
std::vector<curricula::FieldRule> fields_in_words(const char* schema_json, const QString& definition,
                                                  const QStringList& skipped = {});

}  // namespace vallecula::gui

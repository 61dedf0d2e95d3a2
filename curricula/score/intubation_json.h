// The part of score.json that only a trial with an intubation has (private to the library).
#pragma once

#include <QJsonObject>

#include "curricula/score/intubation_score.h"

namespace vallecula::curricula {

/// null where the value is no number or does not exist
QJsonValue number_or_null(double value, bool exists = true);

QJsonObject intubation_to_json(const IntubationScore& score);

}  // namespace vallecula::curricula

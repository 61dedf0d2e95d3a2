// The parts of score.json that go beyond the first figures (private to the library).
#pragma once

#include <QJsonObject>

#include "curricula/score/score.h"

namespace vallecula::curricula {

/// Adds "force", "view", "blade", "motion", "for_researchers", "dual_task", "checklist" and "global_rating".
void add_figures(const Score& score, QJsonObject& object);

}  // namespace vallecula::curricula

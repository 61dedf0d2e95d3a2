// Rows of the table of trials (private to the library).
#pragma once

#include <QString>
#include <QVariant>
#include <vector>

#include "curricula/records/records.h"

namespace vallecula::curricula {

enum class WithFigures { no, yes };

/// `where` completes "SELECT * FROM trials WHERE ...", with its values in order. Whoever only counts leaves the figures:
/// there are some thirty a trial.
std::vector<RecordRow> trial_rows(Connection& connection, const QString& where, const QVariantList& values,
                                  WithFigures with_figures = WithFigures::no);

}  // namespace vallecula::curricula

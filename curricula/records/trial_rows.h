// Rows of the table of trials (private to the library).
#pragma once

#include <QString>
#include <QVariant>
#include <vector>

#include "curricula/records/records.h"

namespace vallecula::curricula {

/// `where` completes "SELECT * FROM trials WHERE ...", with its values in order.
std::vector<RecordRow> trial_rows(Connection& connection, const QString& where, const QVariantList& values);

}  // namespace vallecula::curricula

// Rows of the table of notes (private to the library).
#pragma once

#include <QString>
#include <QVariant>

#include "curricula/records/connection.h"
#include "curricula/records/notes.h"

namespace vallecula::curricula {

/// `where` completes "SELECT * FROM notes WHERE ...", with its values in order.
std::vector<Note> note_rows(Connection& connection, const QString& where, const QVariantList& values);

}  // namespace vallecula::curricula

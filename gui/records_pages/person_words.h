// What the records' pages say of people, in the same words everywhere.
#pragma once

#include <QString>
#include <functional>

#include "curricula/records/personal_data.h"

class QWidget;

namespace vallecula::gui {

QString words_of(curricula::Role role);                 ///< "trainee"
QString words_of(const curricula::Person& person);      ///< "Kiwi (trainee)"
QString words_of(const curricula::Deletion& deletion);  ///< what is gone, and what is not yet

/// Of the folder that an export makes, by the time: file names name nobody.
QString new_export_name();

/// The plain warning before somebody is deleted; `delete_them` when that is confirmed. `whom`: "you", a name.
void warn_before_deleting(QWidget* parent, const QString& title, const QString& whom,
                          const std::function<void()>& delete_them);

}  // namespace vallecula::gui

// A curriculum's Markdown for windows and reports.
#pragma once

#include <QString>

#include "curricula/text.h"

namespace vallecula::gui {

/// The text in the language of this user's system, else in English, as HTML for a label or inside a page. A curriculum
/// may come from anybody: HTML in it is shown as it is written, pictures and links are left out, so that opening it
/// asks nobody for anything. Needs a QGuiApplication.
QString html_of(const curricula::Text& text);
/// The same without any markup.
QString plain_of(const curricula::Text& text);

}  // namespace vallecula::gui

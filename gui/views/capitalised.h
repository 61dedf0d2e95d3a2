// A name or a remark as it begins a sentence.
#pragma once

#include <QString>

namespace vallecula::gui {

inline QString capitalised(const QString& text) { return text.left(1).toUpper() + text.mid(1); }

}  // namespace vallecula::gui

// Words of the standard library as Qt's: every text here is UTF-8.
#pragma once

#include <QString>
#include <string>

namespace vallecula::curricula {

inline QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace vallecula::curricula

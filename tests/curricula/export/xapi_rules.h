// What the published rules demand of statements, checked without the code under test.
#pragma once

#include <QJsonObject>
#include <string>
#include <vector>

namespace vallecula::curricula::testing {

/// Offences against xAPI 1.0.3 (part two: data) in one statement; empty: none. Unknown properties are offences.
std::vector<std::string> xapi_offences(const QJsonObject& statement);

/// Offences of one session's statements, in order, against cmi5 (quartz) 9.1 to 9.7. `defined`: they carry cmi5's
/// category, and must; otherwise they must not, and what the rules say of each verb is demanded all the same.
std::vector<std::string> cmi5_offences(const std::vector<QJsonObject>& session, bool defined);

}  // namespace vallecula::curricula::testing

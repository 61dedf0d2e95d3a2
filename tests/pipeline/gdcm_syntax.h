// Rewrites a DICOM file in another transfer syntax, by GDCM: the program only reads them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace vallecula::pipeline::test {

/// Name and UID of what GDCM can write.
const std::vector<std::pair<std::string, std::string>>& syntaxes();

/// False when GDCM cannot.
bool rewrite(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& syntax);

}  // namespace vallecula::pipeline::test

// The dependency rule as data and as a judge: which folder may include and link what. Arrows point one way.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vallecula::architecture {

/// What one folder may use. Whatever is not allowed here is forbidden: a new library is a decision, made in this table.
struct FolderRule {
  std::string folder;
  std::vector<std::string> project_folders;  ///< folders of this project it may include, its own among them
  std::string headers;                  ///< regular expression of the outside headers, besides the standard library's
  std::vector<std::string> qt_modules;  ///< "QtCore", ...; {"*"}: every one
  bool may_touch_files = true;          ///< false: neither <fstream> nor <filesystem> nor POSIX file calls
  std::string link_items;               ///< regular expression of what its targets may name in their link lines
  std::string forbidden_on_link_line;   ///< regular expression of what must not reach its test program's link line;
                                        ///< empty: nothing
};

/// The folders that hold a library, as CONTRIBUTING.md words the rule.
const std::vector<FolderRule>& dependency_rule();
const FolderRule& rule_of(const std::string& folder);  ///< throws std::out_of_range for a folder without a library

struct Include {
  int line = 0;
  std::string header;  ///< as written between the marks; the macro's name for `#include MACRO`
  char mark = '<';     ///< '<', '"', or 'm' for a macro
};

/// Every #include of a C++ text, those inside comments left out.
std::vector<Include> includes_of(const std::string& text);

/// Why `include` is forbidden in `rule.folder`; empty if it is allowed. `qt_headers` is the folder that holds QtCore/,
/// QtSql/, ...
std::string objection(const FolderRule& rule, const Include& include, const std::filesystem::path& qt_headers);

/// One line for every forbidden include under root/rule.folder: "file:line: <header>: why".
std::vector<std::string> forbidden_includes(const FolderRule& rule, const std::filesystem::path& root,
                                            const std::filesystem::path& qt_headers);

/// Number of source files the check above reads; a check of nothing proves nothing.
int source_files(const FolderRule& rule, const std::filesystem::path& root);

/// A CMake target as the build declares it (link_lines.txt, written when the build is generated).
struct Target {
  std::string folder, name, type;
  std::vector<std::string> links;
};
std::vector<Target> read_targets(const std::filesystem::path& link_lines);  ///< throws std::runtime_error
std::vector<std::string> forbidden_links(const FolderRule& rule, const std::vector<Target>& targets);

/// LINK_LIBRARIES of a program in build.ninja: all that the linker is really given. Throws std::runtime_error if the
/// program is not there.
std::string link_line(const std::filesystem::path& build_ninja, const std::string& program);

/// Top-level entries of `root` that the project does not allow, and those it lacks; what .gitignore ignores is passed
/// over.
std::vector<std::string> top_level_faults(const std::filesystem::path& root);

}  // namespace vallecula::architecture

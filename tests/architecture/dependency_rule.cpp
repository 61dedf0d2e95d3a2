#include "tests/architecture/dependency_rule.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace vallecula::architecture {
namespace {

namespace fs = std::filesystem;

const char kStandardHeaders[] =
    "algorithm|any|array|atomic|bitset|cassert|cctype|cerrno|cfenv|cfloat|charconv|chrono|cinttypes|climits|clocale|"
    "cmath|"
    "complex|condition_variable|csetjmp|csignal|cstdarg|cstddef|cstdint|cstdio|cstdlib|cstring|ctime|cwchar|cwctype|"
    "deque|"
    "exception|execution|filesystem|forward_list|fstream|functional|future|initializer_list|iomanip|ios|iosfwd|"
    "iostream|"
    "istream|iterator|limits|list|locale|map|memory|memory_resource|mutex|new|numeric|optional|ostream|queue|random|"
    "ratio|"
    "regex|scoped_allocator|set|shared_mutex|sstream|stack|stdexcept|streambuf|string|string_view|system_error|thread|"
    "tuple|"
    "type_traits|typeindex|typeinfo|unordered_map|unordered_set|utility|valarray|variant|vector|"
    "(assert|ctype|errno|fenv|float|inttypes|limits|locale|math|setjmp|signal|stdarg|stdbool|stddef|stdint|stdio|"
    "stdlib|"
    "string|time)\\.h";
// Threads, clocks, memory locks and the processor's own instructions.
const char kMachineHeaders[] =
    "pthread\\.h|semaphore\\.h|sched\\.h|unistd\\.h|sys/(mman|prctl|resource|syscall|time|types)\\.h|linux/sched(/types)?\\.h|"
    "(imm|xmm|emm|pmm|smm)intrin\\.h|cpuid\\.h|cxxabi\\.h|malloc\\.h";
const char kFileHeaders[] =
    "fstream|filesystem|fcntl\\.h|dirent\\.h|ftw\\.h|glob\\.h|poll\\.h|spawn\\.h|pwd\\.h|libgen\\.h|termios\\.h|"
    "sys/(file|ioctl|select|socket|stat|statvfs|un|wait)\\.h";

bool matches(const std::string& text, const std::string& pattern) {
  return !pattern.empty() && std::regex_match(text, std::regex(pattern));
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The text with its comments blanked, line breaks kept, so that line numbers stay right. Strings are stepped over
/// whole.
std::string without_comments(const std::string& text) {
  std::string out = text;
  const auto blank = [&out](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (out[i] != '\n') out[i] = ' ';
    }
  };
  std::size_t i = 0;
  while (i < text.size()) {
    if (text.compare(i, 2, "//") == 0) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      blank(i, end);
      i = end;
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t close = text.find("*/", i + 2);
      const std::size_t end = close == std::string::npos ? text.size() : close + 2;
      blank(i, end);
      i = end;
    } else if (text.compare(i, 2, "R\"") == 0) {
      const std::size_t open = text.find('(', i);
      if (open == std::string::npos) break;
      const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
      const std::size_t end = text.find(close, open);
      const std::size_t stop = end == std::string::npos ? text.size() : end + close.size();
      blank(open, stop);  // an #include inside a raw string is text, not code
      i = stop;
    } else if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"' && text[i] != '\n'; ++i) {
        if (text[i] == '\\') ++i;
      }
      ++i;
    } else if (text[i] == '\'' && i + 2 < text.size() && (text[i + 2] == '\'' || text[i + 1] == '\\')) {
      i = text.find('\'', i + 2);
      if (i == std::string::npos) break;
      ++i;
    } else {
      ++i;
    }
  }
  return out;
}

std::vector<fs::path> sources_under(const fs::path& folder) {
  static const std::set<std::string> kEndings = {".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hxx", ".inl", ".ipp"};
  std::vector<fs::path> files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file() && kEndings.count(entry.path().extension().string()) != 0)
        files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// "QtCore" for QString; empty if the header is no Qt header.
std::string qt_module_of(const std::string& header, const fs::path& qt_headers) {
  const std::size_t slash = header.find('/');
  if (slash != std::string::npos) {
    const std::string first = header.substr(0, slash);
    return matches(first, "Qt[A-Z]\\w*") ? first : "";
  }
  if (!matches(header, "Q[A-Z]\\w*|q[a-z0-9_]+\\.h|Qt[A-Z]\\w*")) return "";
  if (fs::exists(qt_headers / header / header)) return header;  // <QtCore>: the module's own header
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(qt_headers, ignored)) {
    if (fs::exists(entry.path() / header)) return entry.path().filename().string();
  }
  return matches(header, "QVTK.*") ? "" : "unknown Qt module";
}

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

}  // namespace

const std::vector<FolderRule>& dependency_rule() {
  static const std::string kThreads = "Threads::Threads|rt|m|";
  static const std::string kPipelineHeaders =
      "vtk(?!\\w*Qt)\\w+\\.h|gdcm\\w+\\.h|opencv2/.*|tetgen\\.h|yaml-cpp/.*|sodium\\.h|zlib\\.h";
  static const std::string kDeviceHeaders =
      "hidapi/hidapi\\.h|hidapi\\.h|libusb(-1\\.0/libusb)?\\.h|dlfcn\\.h|linux/(hidraw|input)\\.h";
  static const std::string kPipelineLinks =
      "VTK::(?!\\w*Qt)\\w+|gdcm\\w+|(.*/lib)?(opencv_\\w+|tet)(\\.so|\\.a)?|yaml-cpp|PkgConfig::SODIUM|ZLIB::ZLIB";
  static const std::vector<FolderRule> kRule = {
      {"engine",
       {"engine"},
       "(unsupported/)?Eigen/.*",
       {},
       false,
       kThreads + "Eigen3::Eigen",
       "vallecula_(device|pipeline|curricula|gui)|Qt5|vtk|VTK|gdcm|opencv|hidapi|libusb|yaml|sqlite|sodium|libtet"},
      {"device",
       {"device"},
       kDeviceHeaders,
       {},
       true,
       kThreads + "dl|PkgConfig::(HIDAPI|LIBUSB)\\w*",
       "vallecula_(engine|pipeline|curricula|gui)|Qt5|vtk|VTK|gdcm|opencv|yaml|sqlite|sodium|libtet"},
      {"pipeline",
       {"pipeline"},
       kPipelineHeaders,
       {},
       true,
       kThreads + kPipelineLinks,
       "vallecula_(engine|device|curricula|gui)|Qt5|hidapi|libusb"},
      {"curricula",
       {"curricula"},
       "yaml-cpp/.*|sodium\\.h",
       {"QtCore", "QtSql", "QtNetwork"},
       true,
       kThreads + "Qt5::(Core|Sql|Network)|yaml-cpp|PkgConfig::SODIUM",
       "vallecula_(engine|device|pipeline|gui)|Qt5(Widgets|Gui)|vtk|VTK|gdcm|opencv|hidapi|libusb|libtet"},
      {"gui",
       {"engine", "device", "pipeline", "curricula", "gui"},
       "(unsupported/)?Eigen/.*|QVTK\\w+\\.h|vtk\\w+\\.h|opencv2/videoio\\.hpp|yaml-cpp/.*|sodium\\.h|CLI/.*|spdlog/.*|fmt/.*|\\w+\\.moc",
       {"*"},
       true,
       kThreads + "vallecula::(engine|device|pipeline|curricula)|vallecula_gui|Qt5::\\w+|VTK::\\w+|CLI11::CLI11|spdlog:"
                  ":spdlog|"
                  "(.*/lib)?opencv_(core|videoio)(\\.so|\\.a)?|yaml-cpp|PkgConfig::SODIUM",
       ""},
  };
  return kRule;
}

const FolderRule& rule_of(const std::string& folder) {
  for (const FolderRule& rule : dependency_rule()) {
    if (rule.folder == folder) return rule;
  }
  throw std::out_of_range("no dependency rule for folder '" + folder + "'");
}

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex kInclude("^\\s*#\\s*(?:include|include_next|import)\\s*(?:<([^>]+)>|\"([^\"]+)\"|(\\w+)).*");
  std::vector<Include> found;
  std::istringstream lines(without_comments(text));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch parts;
    if (line.find('#') == std::string::npos || !std::regex_match(line, parts, kInclude)) continue;
    if (parts[1].matched)
      found.push_back({number, parts[1], '<'});
    else if (parts[2].matched)
      found.push_back({number, parts[2], '"'});
    else
      found.push_back({number, parts[3], 'm'});
  }
  return found;
}

std::string objection(const FolderRule& rule, const Include& include, const fs::path& qt_headers) {
  if (include.mark == 'm') return "an include through a macro cannot be checked; write the file's name";
  if (include.header.find("..") != std::string::npos)
    return "no way round by '..': includes start at the repository root";
  const std::string top = include.header.substr(0, include.header.find('/'));
  const bool of_project = std::any_of(dependency_rule().begin(), dependency_rule().end(),
                                      [&top](const FolderRule& other) { return other.folder == top; });
  if (of_project || top == "tests" || top == "packaging") {
    return contains(rule.project_folders, top) ? "" : rule.folder + "/ must not know " + top + "/";
  }
  if (include.mark == '"')
    return "project files are included from the repository root (\"" + rule.folder + "/...\"), others with <>";
  if (matches(include.header, kFileHeaders)) {
    return rule.may_touch_files ? "" : rule.folder + "/ must not touch files";
  }
  if (matches(include.header, kStandardHeaders) || matches(include.header, kMachineHeaders)) return "";
  if (matches(include.header, rule.headers)) return "";
  const std::string module = qt_module_of(include.header, qt_headers);
  if (module.empty())
    return rule.folder + "/ may not use this library (tests/architecture/dependency_rule.cpp lists what it may)";
  if (contains(rule.qt_modules, "*") || contains(rule.qt_modules, module)) return "";
  return rule.folder + "/ must not know " + module;
}

std::vector<std::string> forbidden_includes(const FolderRule& rule, const fs::path& root, const fs::path& qt_headers) {
  std::vector<std::string> found;
  for (const fs::path& file : sources_under(root / rule.folder)) {
    for (const Include& include : includes_of(read_text(file))) {
      const std::string why = objection(rule, include, qt_headers);
      if (!why.empty()) {
        found.push_back(fs::relative(file, root).string() + ":" + std::to_string(include.line) + ": " + include.header +
                        ": " + why);
      }
    }
  }
  return found;
}

int source_files(const FolderRule& rule, const fs::path& root) {
  return static_cast<int>(sources_under(root / rule.folder).size());
}

std::vector<Target> read_targets(const fs::path& link_lines) {
  std::vector<Target> targets;
  std::istringstream lines(read_text(link_lines));
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    Target target;
    if (!(words >> target.folder >> target.name >> target.type)) continue;
    for (std::string item; words >> item;) target.links.push_back(item);
    targets.push_back(target);
  }
  return targets;
}

std::vector<std::string> forbidden_links(const FolderRule& rule, const std::vector<Target>& targets) {
  std::vector<std::string> found;
  for (const Target& target : targets) {
    if (target.folder != rule.folder) continue;
    for (const std::string& item : target.links) {
      const bool own_library = item == "vallecula_" + rule.folder || item == "vallecula::" + rule.folder;
      const bool own_program = target.type == "EXECUTABLE" && own_library;
      if (!own_program && !matches(item, rule.link_items)) {
        found.push_back(rule.folder + "/CMakeLists.txt: " + target.name + " must not link " + item);
      }
    }
  }
  return found;
}

std::string link_line(const fs::path& build_ninja, const std::string& program) {
  std::ifstream in(build_ninja);
  if (!in) throw std::runtime_error("cannot read " + build_ninja.string());
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("build ", 0) == 0) {
      inside = line.rfind("build " + program + ":", 0) == 0 && line.find("_EXECUTABLE_LINKER_") != std::string::npos;
    } else if (inside && line.rfind("  LINK_LIBRARIES = ", 0) == 0) {
      return line.substr(19);
    }
  }
  throw std::runtime_error("no link line of " + program + " in " + build_ninja.string());
}

std::vector<std::string> top_level_faults(const fs::path& root) {
  static const std::set<std::string> kNeeded = {
      "CMakeLists.txt", "gui",       "engine",          "pipeline",     "device",  "curricula",         "tests",
      "packaging",      "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "CMakePresets.json", ".clang-format",
      ".clang-tidy",    ".ci"};
  static const std::set<std::string> kOfGit = {".git", ".gitignore", ".gitattributes", ".gitmodules"};
  std::vector<std::string> ignored;  // plain patterns of .gitignore, as regular expressions of a name
  std::istringstream lines(fs::exists(root / ".gitignore") ? read_text(root / ".gitignore") : "");
  for (std::string line; std::getline(lines, line);) {
    std::string pattern;
    for (const char c : line) {
      if (c == '/') continue;
      if (c == '*')
        pattern += ".*";
      else if (c == '.')
        pattern += "\\.";
      else
        pattern += c;
    }
    if (!pattern.empty() && pattern[0] != '#') ignored.push_back(pattern);
  }
  std::vector<std::string> faults;
  for (const std::string& name : kNeeded) {
    if (!fs::exists(root / name)) faults.push_back(name + " is missing at the top level");
  }
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    const bool is_ignored =
        std::any_of(ignored.begin(), ignored.end(), [&name](const std::string& p) { return matches(name, p); });
    if (kNeeded.count(name) == 0 && kOfGit.count(name) == 0 && !is_ignored) {
      faults.push_back(name + " does not belong at the top level");
    }
  }
  return faults;
}

}  // namespace vallecula::architecture

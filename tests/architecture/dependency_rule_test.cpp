// The dependency rule kept on the tree as it stands, and proof that the check finds what it is for.
#include "tests/architecture/dependency_rule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <random>
#include <regex>

namespace vallecula::architecture {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = VALLECULA_SOURCE_DIR;
const fs::path kBuild = VALLECULA_BINARY_DIR;
const fs::path kQtHeaders = VALLECULA_QT_HEADERS;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

/// Every folder that holds a library; or only those below the application, which have something to keep out.
std::vector<std::string> folder_names(bool with_application) {
  std::vector<std::string> names;
  for (const FolderRule& rule : dependency_rule()) {
    if (with_application || rule.folder != "gui") names.push_back(rule.folder);
  }
  return names;
}

/// A throw-away tree with one file in it.
class ScratchTree : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("vallecula-architecture-" + std::to_string(std::random_device{}()));
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }
  void write(const fs::path& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  fs::path root_;
};

class EveryFolder : public testing::TestWithParam<std::string> {};
class EveryLibraryBelowTheApplication : public testing::TestWithParam<std::string> {};

TEST_P(EveryFolder, IncludesOnlyWhatItMay) {
  const FolderRule& rule = rule_of(GetParam());
  EXPECT_GT(source_files(rule, kSource), 2) << "the check read no sources: is VALLECULA_SOURCE_DIR right?";
  const auto found = forbidden_includes(rule, kSource, kQtHeaders);
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST_P(EveryFolder, IsOneLibraryAndItsTargetsLinkOnlyWhatTheyMay) {
  const FolderRule& rule = rule_of(GetParam());
  const auto targets = read_targets(kBuild / "tests" / "link_lines.txt");
  std::vector<std::string> libraries;
  for (const Target& target : targets) {
    if (target.folder == rule.folder && std::regex_search(target.type, std::regex("LIBRARY")))
      libraries.push_back(target.name);
  }
  EXPECT_EQ(libraries, std::vector<std::string>{"vallecula_" + rule.folder}) << "one CMake target a library";
  const auto found = forbidden_links(rule, targets);
  EXPECT_TRUE(found.empty()) << joined(found);
}

TEST_P(EveryLibraryBelowTheApplication, BringsNothingForbiddenToTheLinker) {
  const FolderRule& rule = rule_of(GetParam());
  const std::string line = link_line(kBuild / "build.ninja", "vallecula_" + rule.folder + "_tests");
  EXPECT_NE(line.find("libvallecula_" + rule.folder + ".a"), std::string::npos) << line;
  // Names only: the folders on the way to a library say nothing about it.
  std::smatch forbidden;
  const std::string names = std::regex_replace(line, std::regex("\\S*/"), "");
  EXPECT_FALSE(std::regex_search(names, forbidden, std::regex(rule.forbidden_on_link_line)))
      << "the link line of " << rule.folder << "'s tests holds '" << forbidden.str() << "': " << names;
}

INSTANTIATE_TEST_SUITE_P(DependencyRule, EveryFolder, testing::ValuesIn(folder_names(true)),
                         [](const auto& info) { return info.param; });
INSTANTIATE_TEST_SUITE_P(DependencyRule, EveryLibraryBelowTheApplication, testing::ValuesIn(folder_names(false)),
                         [](const auto& info) { return info.param; });

TEST(TopLevel, HoldsOnlyWhatBelongsThere) {
  const auto faults = top_level_faults(kSource);
  EXPECT_TRUE(faults.empty()) << joined(faults);
}

TEST(Includes, AreReadAsTheCompilerWould) {
  const auto found = includes_of(
      "#include <vector>\n"
      "// #include <a>\n"
      "/* #include <b>\n"
      "#include <c> */ int x = '\"';\n"
      "  #  include\t\"engine/scene.h\"  // why\n"
      "const char* url = \"http://x /* \";\n"
      "#include VALLECULA_CONFIG\n"
      "const char* text = R\"(\n#include <in_a_raw_string>\n)\";\n"
      "#if 0\n#include <last>\n#endif\n");
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].header, "vector");
  EXPECT_EQ(found[1].header, "engine/scene.h");
  EXPECT_EQ(found[1].mark, '"');
  EXPECT_EQ(found[1].line, 5);
  EXPECT_EQ(found[2].mark, 'm');
  EXPECT_EQ(found[3].header, "last");
}

struct Case {
  const char* folder;
  const char* header;
  char mark;
  bool allowed;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.header << (c.allowed ? " allowed in " : " refused in ") << c.folder << "/";
}

class Judgement : public testing::TestWithParam<Case> {};

TEST_P(Judgement, IsRight) {
  const Case& c = GetParam();
  const std::string why = objection(rule_of(c.folder), {1, c.header, c.mark}, kQtHeaders);
  EXPECT_EQ(why.empty(), c.allowed) << c.folder << " " << c.header << ": " << why;
}

INSTANTIATE_TEST_SUITE_P(
    DependencyRule, Judgement,
    testing::Values(
        // allowed
        Case{"engine", "engine/scene.h", '"', true}, Case{"engine", "Eigen/Dense", '<', true},
        Case{"engine", "atomic", '<', true}, Case{"engine", "sched.h", '<', true},
        Case{"device", "device/haptic_device.h", '"', true}, Case{"device", "dlfcn.h", '<', true},
        Case{"pipeline", "vtkPolyData.h", '<', true}, Case{"pipeline", "gdcmImageReader.h", '<', true},
        Case{"pipeline", "fstream", '<', true}, Case{"curricula", "QString", '<', true},
        Case{"curricula", "QSqlDatabase", '<', true}, Case{"curricula", "QtCore/QFile", '<', true},
        Case{"gui", "engine/scene.h", '"', true}, Case{"gui", "QWidget", '<', true},
        Case{"gui", "QVTKOpenGLNativeWidget.h", '<', true},
        // forbidden: arrows that point back
        Case{"engine", "device/haptic_device.h", '"', false}, Case{"engine", "curricula/scenario.h", '"', false},
        Case{"engine", "gui/session/trial_session.h", '"', false}, Case{"device", "engine/types.h", '"', false},
        Case{"pipeline", "engine/scene.h", '"', false}, Case{"curricula", "engine/tick_record.h", '"', false},
        Case{"curricula", "device/haptic_device.h", '"', false},
        Case{"gui", "tests/architecture/dependency_rule.h", '"', false},
        Case{"engine", "engine/../gui/commands/commands.h", '"', false},
        // forbidden: libraries that belong elsewhere
        Case{"engine", "vtkPolyData.h", '<', false}, Case{"engine", "QString", '<', false},
        Case{"engine", "fstream", '<', false}, Case{"engine", "filesystem", '<', false},
        Case{"engine", "yaml-cpp/yaml.h", '<', false}, Case{"device", "Eigen/Dense", '<', false},
        Case{"device", "QObject", '<', false}, Case{"device", "vtkMath.h", '<', false},
        Case{"pipeline", "QString", '<', false}, Case{"pipeline", "vtkEventQtSlotConnect.h", '<', false},
        Case{"pipeline", "QVTKOpenGLNativeWidget.h", '<', false}, Case{"pipeline", "hidapi/hidapi.h", '<', false},
        Case{"curricula", "QWidget", '<', false}, Case{"curricula", "QtWidgets/QWidget", '<', false},
        Case{"curricula", "QImage", '<', false}, Case{"curricula", "vtkMath.h", '<', false},
        Case{"curricula", "Eigen/Core", '<', false}, Case{"gui", "boost/asio.hpp", '<', false},
        // forbidden: names that do not start at the repository root, and names that cannot be checked
        Case{"engine", "scene.h", '"', false}, Case{"gui", "session/trial_session.h", '"', false},
        Case{"engine", "SOME_MACRO", 'm', false}));

TEST_F(ScratchTree, AForbiddenIncludeIsFoundWithItsFileAndLine) {
  write("engine/good.h", "#include <vector>\n#include \"engine/scene.h\"\n");
  write("engine/contact/bad.cpp", "// harmless\n\n#include <vtkPolyData.h>\n#include \"curricula/scenario.h\"\n");
  const auto found = forbidden_includes(rule_of("engine"), root_, kQtHeaders);
  ASSERT_EQ(found.size(), 2u) << joined(found);
  EXPECT_EQ(found[0].rfind("engine/contact/bad.cpp:3: vtkPolyData.h: ", 0), 0u) << found[0];
  EXPECT_EQ(found[1].rfind("engine/contact/bad.cpp:4: curricula/scenario.h: ", 0), 0u) << found[1];
}

TEST_F(ScratchTree, AForbiddenLinkIsFound) {
  write("link_lines.txt",
        "engine vallecula_engine STATIC_LIBRARY Eigen3::Eigen Qt5::Core vallecula::device\n"
        "pipeline vallecula_pipeline STATIC_LIBRARY VTK::IOXML VTK::GUISupportQt\n"
        "pipeline helper EXECUTABLE vallecula::pipeline\n");
  const auto targets = read_targets(root_ / "link_lines.txt");
  ASSERT_EQ(targets.size(), 3u);
  EXPECT_EQ(forbidden_links(rule_of("engine"), targets).size(), 2u);
  EXPECT_EQ(forbidden_links(rule_of("pipeline"), targets).size(), 1u);
  EXPECT_TRUE(forbidden_links(rule_of("gui"), targets).empty());
}

TEST_F(ScratchTree, AnOddTopLevelEntryIsFound) {
  write(".gitignore", "/build/\n*.user\n");
  write("build/x", "");
  write("project.user", "");
  write("utils/helper.cpp", "");
  const auto faults = top_level_faults(root_);
  const auto has = [&faults](const std::string& text) {
    return std::find(faults.begin(), faults.end(), text) != faults.end();
  };
  EXPECT_TRUE(has("utils does not belong at the top level"));
  EXPECT_TRUE(has("LICENSE is missing at the top level"));
  EXPECT_FALSE(has("build does not belong at the top level"));
  EXPECT_FALSE(has("project.user does not belong at the top level"));
}

}  // namespace
}  // namespace vallecula::architecture

// What the pipeline says to the command line, as the window says it.
#include "gui/import/window_message.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "tests/gui/program.h"

namespace vallecula::gui {
namespace {

/// Every text in the pipeline's sources that names an option of the command line: string literals that stand behind one
/// another are one text.
std::set<std::string> texts_with_options() {
  static const std::regex run(R"re("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)re");
  static const std::regex seam(R"re("\s*")re");
  std::set<std::string> texts;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(VALLECULA_SOURCE_DIR) / "pipeline")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename() == "ct_helper_main.cpp")
      continue;  // a helper started by hand says how it is meant to be started: no window hears it
    const std::string source = test::text_of(entry.path());
    for (std::sregex_iterator it(source.begin(), source.end(), run), end; it != end; ++it) {
      const std::string text = std::regex_replace(it->str(), seam, "");
      if (std::regex_search(text, std::regex("--[a-z]|`vallecula"))) texts.insert(text.substr(1, text.size() - 2));
    }
  }
  return texts;
}

TEST(WindowMessages, NameNoOptionOfTheCommandLine) {
  const auto texts = texts_with_options();
  EXPECT_GE(texts.size(), 10u) << "found too few: is the search still right?";
  for (const auto& text : texts) {
    const QString said = window_message(QString::fromStdString(text));
    EXPECT_FALSE(said.contains("--") || said.contains('`')) << text << "\n" << said.toStdString();
    EXPECT_GT(said.trimmed().size(), 3) << text;
  }
}

TEST(WindowMessages, AreSentencesOfTheirOwn) {
  EXPECT_EQ(window_sentence("series: the folder is empty; name a folder with a CT series"),
            "The folder is empty; choose a folder with a CT series");
  EXPECT_EQ(
      window_sentence("series: the tongue's seed lies outside the head; coordinates are LPS mm (x to the left, y to "
                      "the back, z to the head)"),
      "The tongue's seed lies outside the head; click a point inside it");
  EXPECT_EQ(window_sentence("files: disk full"), "Files: disk full") << "what else it names stays";
  EXPECT_EQ(window_sentence(""), "");
}

}  // namespace
}  // namespace vallecula::gui

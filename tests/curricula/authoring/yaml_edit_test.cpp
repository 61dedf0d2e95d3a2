// Changing one value of a curriculum's text keeps every other byte.
#include "curricula/authoring/yaml_edit.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "curricula/scenario.h"
#include "tests/curricula/full_course.h"

namespace vallecula::curricula {
namespace {

std::string shipped_text(const std::string& name) {
  std::ifstream in(std::string(VALLECULA_SOURCE_DIR) + "/curricula/courses/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

const char* const kSmall =
    "# the course\n"
    "id: a   # short\n"
    "text: >-\n"
    "  one\n"
    "  two\n"
    "\n"
    "group: { x: 1, y: [p, q] }  # in braces\n"
    "empty:\n"
    "list:\n"
    "  # about the first\n"
    "  - id: one\n"
    "    n: 1\n"
    "\n"
    "  - { id: two, n: 2 }\n"
    "\n"
    "  - id: three # end\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  EXPECT_EQ(text.find(what, at + 1), std::string::npos) << what << " stands there twice";
  return text.replace(at, what.size(), with);
}

TEST(YamlEdit, AValueChangesWhereItStands) {
  const YamlText text(kSmall);
  EXPECT_EQ(with_value(text, "id", yaml_text("b\nc\n")),
            replaced(kSmall, "id: a   # short\n", "id: |   # short\n  b\n  c\n"));
  EXPECT_EQ(with_value(text, "id", yaml_text("b")), replaced(kSmall, "id: a ", "id: b "));
  EXPECT_EQ(with_value(text, "group.x", yaml_plain("2.5")), replaced(kSmall, "x: 1,", "x: 2.5,"));
  EXPECT_EQ(with_value(text, "list[1].n", yaml_plain("-3")), replaced(kSmall, "n: 2 }", "n: -3 }"));
  EXPECT_EQ(with_value(text, "list[0].n", yaml_text("1")), replaced(kSmall, "    n: 1", "    n: \"1\""));
  EXPECT_EQ(with_value(text, "group.y", yaml_list({yaml_text("r")})), replaced(kSmall, "[p, q]", "[r]"));
  EXPECT_EQ(with_value(text, "text", yaml_text("short")), replaced(kSmall, "  one\n  two\n", "  short\n"));
  EXPECT_EQ(with_value(text, "text", yaml_text("a\nb: c\n")),
            replaced(kSmall, " >-\n  one\n  two\n", " >\n  a\n\n  b: c\n"));
  EXPECT_EQ(with_value(text, "text", yaml_group({{"en", yaml_text("x")}, {"de", yaml_text("z")}})),
            replaced(kSmall, "text: >-\n  one\n  two\n", "text:\n  en: x\n  de: z\n"));
}

TEST(YamlEdit, WhatIsNotThereIsAddedWithItsGroup) {
  const YamlText text(kSmall);
  EXPECT_EQ(with_value(text, "list[0].m", yaml_plain("4")), replaced(kSmall, "    n: 1\n", "    n: 1\n    m: 4\n"));
  EXPECT_EQ(with_value(text, "group.z", yaml_plain("4")), replaced(kSmall, "[p, q] }", "[p, q], z: 4 }"));
  EXPECT_EQ(with_value(text, "empty.a.b", yaml_plain("4")), replaced(kSmall, "empty:\n", "empty:\n  a:\n    b: 4\n"));
  EXPECT_EQ(with_value(text, "list[2].k", yaml_plain("true")), std::string(kSmall) + "    k: true\n");
}

TEST(YamlEdit, AFieldLeftOutTakesItsLineAndItsEmptyGroup) {
  const YamlText text(kSmall);
  EXPECT_EQ(without_value(text, "list[0].n"), replaced(kSmall, "    n: 1\n", ""));
  EXPECT_EQ(without_value(text, "list[0].id"), replaced(kSmall, "- id: one\n    n: 1", "- n: 1"));
  EXPECT_EQ(without_value(text, "group.x"), replaced(kSmall, "x: 1, ", ""));
  EXPECT_EQ(without_value(text, "group.y"), replaced(kSmall, ", y: [p, q]", ""));
  EXPECT_EQ(without_value(YamlText("a:\n  b:\n    c: 1\nd: 2\n"), "a.b.c"), "d: 2\n");
  EXPECT_THROW(without_value(YamlText("a:\n  b: 1\n"), "a.b"), std::runtime_error) << "nothing would be left";
}

TEST(YamlEdit, EntriesMoveWithTheirComments) {
  const YamlText text(kSmall);
  const std::string first = "  # about the first\n  - id: one\n    n: 1\n", second = "  - { id: two, n: 2 }\n";
  std::string swapped = kSmall;
  swapped.replace(swapped.find(first), (first + "\n" + second).size(), second + "\n" + first);
  EXPECT_EQ(with_item_moved(text, "list", 0, 1), swapped);
  EXPECT_EQ(with_item_moved(text, "group.y", 1, 0), replaced(kSmall, "[p, q]", "[q, p]"));
  EXPECT_EQ(without_item(text, "list", 1), replaced(kSmall, second + "\n", ""));
  EXPECT_EQ(with_item(text, "list", 3, yaml_group({{"id", yaml_text("four")}})),
            std::string(kSmall) + "\n  - id: four\n");
  EXPECT_EQ(with_item(text, "group.y", 0, yaml_text("a, b")), replaced(kSmall, "[p, q]", "[\"a, b\", p, q]"));
  EXPECT_EQ(with_item_copied(text, "list", 1, YamlText("deep:\n- id: five\n  t: |\n    x\n\n     y\n"), "deep", 0),
            replaced(kSmall, "    n: 1\n\n", "    n: 1\n\n  - id: five\n    t: |\n      x\n\n       y\n\n"));
}

TEST(YamlEdit, EveryValueOfEveryCourseCanBeSetAndSetBack) {
  for (const std::string& whole : {shipped_text("neonatal-intubation.yaml"), shipped_text("first-intubation.yaml"),
                                   std::string(testing::kFullCourse)}) {
    const YamlText text(whole);
    int changed = 0;
    const std::function<void(const YamlNode&, const std::string&)> walk = [&](const YamlNode& node,
                                                                              const std::string& path) {
      for (std::size_t i = 0; i < node.children.size(); ++i)
        walk(node.children[i], node.kind == YamlNode::Kind::list ? path + "[" + std::to_string(i) + "]"
                               : path.empty()                    ? node.children[i].key
                                                                 : path + "." + node.children[i].key);
      if (node.kind != YamlNode::Kind::scalar || ++changed % 7 != 0) return;  // each takes two readings of the course
      YamlNode other = node;
      other.value = node.is_text ? node.value + "x" : "77";
      const std::string edited = with_value(text, path, other);
      const YamlText again(edited);
      ASSERT_EQ(again.find(path)->value, other.value) << path;
      const std::size_t tail = whole.size() - node.end;
      EXPECT_EQ(edited.substr(0, node.begin), whole.substr(0, node.begin)) << path;
      EXPECT_EQ(edited.substr(edited.size() - tail), whole.substr(node.end)) << path;
      if (node.value.find('\n') == std::string::npos && whole[node.begin] != '>') {
        EXPECT_EQ(with_value(again, path, node), whole) << path;
      }
    };
    walk(text.root(), "");
    EXPECT_GT(changed, 100);
  }
}

TEST(YamlEdit, WindowsLineEndsAndAByteOrderMarkStay) {
  const YamlText text(
      "\xef\xbb\xbf"
      "a: \xc3\xa4\r\nb: |\r\n  x\r\n  y\r\nc: [1]\r\n");
  EXPECT_EQ(with_value(text, "c", yaml_list({yaml_plain("2")})),
            "\xef\xbb\xbf"
            "a: \xc3\xa4\r\nb: |\r\n  x\r\n  y\r\nc: [2]\r\n");
  EXPECT_EQ(with_value(text, "b", yaml_text("p\nq\n")),
            "\xef\xbb\xbf"
            "a: \xc3\xa4\r\nb: |\r\n  p\r\n  q\r\nc: [1]\r\n");
  EXPECT_EQ(with_value(text, "d", yaml_plain("1")), text.text() + "d: 1\r\n");
}

TEST(YamlEdit, HardTextsComeBackAsTheyAre) {
  for (const std::string value :
       {"",    " ",     "true",  "12",          "- no list",  "a: b",         "a #b", "#x",
        "'q'", "\"q\"", "\\",    "tab\tin",     "two\nlines", "two\nlines\n", "\n",   "  indented\nfirst",
        "{x}", "[y]",   "ends:", "caf\xc3\xa9", "% d",        "a\n\n\nb\n",   "&x",   "*y",
        "!z",  "0x10"}) {
    for (const char* where : {"id", "group.x", "text", "list[1].id", "list[0].id"}) {
      const std::string edited = with_value(YamlText(kSmall), where, yaml_text(value));
      EXPECT_EQ(YamlText(edited).find(where)->value, value) << where << ":\n" << edited;
    }
  }
}

TEST(YamlEdit, WhatCannotBeChangedInPlaceIsSaidSo) {
  EXPECT_THROW(YamlText("a: !tag 5\n"), CurriculumError);
  EXPECT_THROW(YamlText("? [x]\n: 1\n"), CurriculumError);
  EXPECT_THROW(YamlText("a: [\n"), CurriculumError);
  EXPECT_THROW(with_value(YamlText("- 1\n"), "a", yaml_plain("1")), std::runtime_error);
  EXPECT_THROW(with_item_moved(YamlText(kSmall), "list", 0, 3), std::runtime_error);
}

TEST(YamlEdit, ALineLeadsToItsField) {
  const YamlText text(kSmall);
  EXPECT_EQ(text.path_at(2), "id");
  EXPECT_EQ(text.path_at(5), "text");
  EXPECT_EQ(text.path_at(12), "list[0].n");
}

TEST(CurriculumProblems, AreAllFoundEachWithItsField) {
  std::string bad = testing::kFullCourse;
  EXPECT_TRUE(problems_of(bad).empty());
  bad = replaced(bad, "weight_kg: 3.2", "weight_kg: 32");
  bad = replaced(bad, "stylet_mm: 1.5", "stylet_mm: 1.5 mm");
  bad = replaced(bad, "title: Scenario two", "title: Scenario two\n    colour: blue");
  const auto problems = problems_of(bad);
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0].field, "scenarios[0].manikin.weight_kg");
  EXPECT_EQ(problems[0].value, "'32'");
  EXPECT_NE(problems[0].allowed.find("0.6 to 4.5 kg"), std::string::npos) << problems[0].allowed;
  EXPECT_EQ(problems[1].field, "scenarios[1].colour");
  EXPECT_EQ(problems[2].field, "scenarios[1].intubation.stylet_mm");
  for (const Problem& one : problems) EXPECT_EQ(one.line, YamlText(bad).find(one.field)->line);
}

TEST(CurriculumProblems, BetweenFieldsAreFoundInEachScenario) {
  std::string bad = testing::kFullCourse;
  bad = replaced(bad, "max_attempt_s: 60", "max_attempt_s: 20");
  bad = replaced(bad, "infants: 3", "infants: 2");
  bad = replaced(bad, "mouth_opening: [0.9, 1]", "mouth_opening: [1, 0.9]");
  const auto problems = problems_of(bad);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].field, "scenarios[0].pass.attempt_time_s");
  EXPECT_EQ(problems[1].field, "scenarios[1].variation.mouth_opening[1]");
}

TEST(CurriculumProblems, OfATextThatIsNoCurriculumAreOne) {
  for (const std::string& bad :
       {std::string(), std::string("a: [\n"), std::string("\xff\xfe"), std::string("schema: 3\n"),
        std::string("a: &x [1]\nb: *x\n"), std::string(11u << 20, 'x'), std::string("- 1\n")}) {
    const auto problems = problems_of(bad);
    ASSERT_EQ(problems.size(), 1u) << bad.substr(0, 20);
    EXPECT_FALSE(problems[0].message.empty());
  }
}

}  // namespace
}  // namespace vallecula::curricula

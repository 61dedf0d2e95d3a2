// The form's fields are the schema's, and the differences of two texts lead from one to the other.
#include "curricula/authoring/field_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "curricula/authoring/line_diff.h"
#include "curricula/authoring/yaml_edit.h"
#include "curricula/scenario.h"
#include "curricula/schema/reference_table.h"
#include "curricula/schema/schema_text.h"
#include "tests/curricula/full_course.h"

namespace vallecula::curricula {
namespace {

using Kind = FieldRule::Kind;

const FieldRule* find(const std::vector<FieldRule>& rules, const QString& path) {
  const QString name = path.section('.', 0, 0), rest = path.section('.', 1);
  for (const FieldRule& rule : rules)
    if (rule.name == name) return rest.isEmpty() ? &rule : find(rule.fields, rest);
  return nullptr;
}

TEST(FieldRules, EveryFieldOfTheReferenceTableHasOne) {
  const auto course = fields_of(curriculum_schema_2(), "curriculum");
  int rows = 0;
  for (const QString& line : QString::fromStdString(reference_table(curriculum_schema_2())).split('\n')) {
    if (!line.startsWith("| `")) continue;
    ++rows;
    const QString field = line.section('`', 1, 1).remove("[]");
    const FieldRule* rule = find(course, field);
    ASSERT_NE(rule, nullptr) << field.toStdString();
    EXPECT_EQ(rule->unit, line.section('|', 3, 3).trimmed()) << field.toStdString();
    EXPECT_EQ(rule->help, line.section('|', 6, 6).trimmed()) << field.toStdString();
    EXPECT_EQ(rule->required, line.section('|', 5, 5).trimmed() == "required") << field.toStdString();
    EXPECT_FALSE(rule->label.isEmpty() || rule->label.contains('_')) << field.toStdString();
  }
  EXPECT_GT(rows, 100);
}

TEST(FieldRules, ANumberKnowsItsRangeAndUnit) {
  const auto scenario = fields_of(curriculum_schema_2(), "scenario");
  EXPECT_EQ(find(scenario, "manikin.weight_kg")->allowed(), "0.6 to 4.5 kg");
  EXPECT_EQ(find(scenario, "variation.mouth_opening")->kind, Kind::range);
  EXPECT_EQ(find(scenario, "briefing")->kind, Kind::text);
  EXPECT_EQ(find(scenario, "distractions")->kind, Kind::groups);
  EXPECT_EQ(find(scenario, "distractions.answers")->kind, Kind::texts);
  EXPECT_EQ(find(scenario, "intubation.stylet")->kind, Kind::truth);
  EXPECT_EQ(find(scenario, "intubation.pass.outcomes")->kind, Kind::words);
  EXPECT_EQ(find(scenario, "intubation.catheter_f")->words_are_text, false);
  EXPECT_EQ(find(scenario, "intubation.tube")->words_are_text, true);
  EXPECT_EQ(label_of("peak_tongue_force_n"), "Peak tongue force");
  EXPECT_EQ(label_of("lowest_spo2_percent"), "Lowest SpO2");
  EXPECT_EQ(label_of("lowest_heart_per_min"), "Lowest heart");
}

/// Every field with a range is set beyond both its ends, as the form would, and told by its name.
TEST(FieldRules, EveryFieldBeyondItsRangeIsToldByItsName) {
  const YamlText course(testing::kFullCourse);
  int tried = 0;
  const std::function<void(const std::vector<FieldRule>&, const std::string&)> each =
      [&](const std::vector<FieldRule>& rules, const std::string& path) {
        for (const FieldRule& rule : rules) {
          std::string here = path + (path.empty() ? "" : ".") + rule.name.toStdString();
          if (rule.kind == Kind::groups) here += here == "scenarios" || here == "modules" ? "[1]" : "[0]";
          if (course.find(here) == nullptr) continue;
          each(rule.fields, here);
          std::vector<std::string> bad;
          if (rule.kind == Kind::number || rule.kind == Kind::whole_number)
            bad = {QString::number(rule.minimum - 0.7, 'g', 15).toStdString(),
                   QString::number(rule.maximum + 1, 'g', 15).toStdString(), "5 apples", ""};
          if (rule.kind == Kind::word || rule.kind == Kind::truth) bad = {"apples", ""};
          if (rule.name == "schema") bad = {"3", "0", "apples"};
          if (rule.longest > 0 && rule.kind == Kind::plain_text)
            bad = {std::string(static_cast<std::size_t>(rule.longest) + 1, 'x')};
          for (const std::string& value : bad) {
            const std::string text = with_value(course, here, yaml_plain(value));
            const auto problems = problems_of(text);
            const bool told = std::any_of(problems.begin(), problems.end(), [&](const Problem& p) {
              return p.field == here && !p.allowed.empty() && p.line == YamlText(text).find(here)->line;
            });
            EXPECT_TRUE(told) << here << " = '" << value << "'" << (problems.empty() ? "" : ": " + problems[0].message);
            ++tried;
          }
        }
      };
  each(fields_of(curriculum_schema_2(), "curriculum"), "");
  EXPECT_GT(tried, 150);
}

TEST(LineDiff, LeadsFromOneTextToTheOther) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::string before, after;
    for (std::string* text : {&before, &after})
      for (unsigned n = random() % 12; n > 0; --n)
        *text += std::string(1, static_cast<char>('a' + random() % 3)) + "\n";
    std::string first, second;
    std::size_t same = 0;
    for (const DiffLine& line : line_diff(before, after)) {
      if (line.kind != DiffLine::Kind::added) first += line.text + "\n";
      if (line.kind != DiffLine::Kind::removed) second += line.text + "\n";
      same += line.kind == DiffLine::Kind::same ? 1 : 0;
    }
    EXPECT_EQ(first, before);
    EXPECT_EQ(second, after);
    // The longest common subsequence, by trying all of them.
    std::size_t longest = 0;
    const std::size_t lines = before.size() / 2;
    for (unsigned mask = 0; mask < (1u << lines); ++mask) {
      std::size_t at = 0, taken = 0;
      bool fits = true;
      for (std::size_t i = 0; i < lines && fits; ++i) {
        if ((mask >> i & 1u) == 0) continue;
        while (at < after.size() && after[at] != before[2 * i]) at += 2;
        fits = at < after.size();
        at += 2;
        ++taken;
      }
      if (fits) longest = std::max(longest, taken);
    }
    EXPECT_EQ(same, longest) << before << "---\n" << after;
  }
}

}  // namespace
}  // namespace vallecula::curricula

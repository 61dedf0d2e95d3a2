// The quality report's order and words.
#include "pipeline/quality.h"

#include <gtest/gtest.h>

namespace vallecula::pipeline {
namespace {

TEST(QualityReport, NamesWhatWasNotSeenOnceARuleAndWithoutAFigure) {
  const Finding resting{Origin::inferred, "its leaf lies against the tongue"};
  const auto items = finding_items({{"airway", {}},
                                    {"bone_mandible", {Origin::from_model, "none in the scan"}},
                                    {"epiglottis", resting},
                                    {"epiglottis_tip", resting},
                                    {"tongue", {Origin::given, "drawn"}},
                                    {"vallecula", resting}});
  ASSERT_EQ(items.size(), 2u) << "measured and given need no second look";
  EXPECT_EQ(items[0].name, "mandible");
  EXPECT_EQ(items[0].note, "template: none in the scan");
  EXPECT_EQ(items[1].name, "epiglottis, epiglottis tip, vallecula");
  EXPECT_EQ(items[1].note, "inferred: its leaf lies against the tongue");
  for (const auto& item : items) {
    EXPECT_EQ(value_text(item), "");
    EXPECT_TRUE(item.judged && !item.ok);
  }
}

TEST(QualityReport, IsReadInGroupsWhatIsToBeCheckedFirst) {
  const std::vector<QualityItem> items{{"a", 1.0, "mm", true, ""},
                                       {"b", 2.0, "mm", true, "", false},
                                       {"c", 3.0, "mm", false, ""},
                                       {"d", 4.0, "mm", true, ""}};
  const auto groups = in_groups(items);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].title, "To be checked first");
  ASSERT_EQ(groups[0].items.size(), 1u);
  EXPECT_EQ(groups[0].items[0].name, "c");
  ASSERT_EQ(groups[1].items.size(), 2u);
  EXPECT_EQ(groups[1].items[0].name + groups[1].items[1].name, "ad") << "as they came";
  EXPECT_EQ(groups[2].items.at(0).name, "b") << "a figure without a limit is neither good nor bad";
  EXPECT_EQ(in_groups({items[0]}).size(), 1u) << "no empty group";
  EXPECT_TRUE(in_groups({}).empty());
}

TEST(QualityReport, SaysFiguresAsAPersonWritesThem) {
  const auto text = [](std::optional<double> value, const char* unit) {
    return value_text({"", value, unit, true, ""});
  };
  EXPECT_EQ(text(2.2361, "ml"), "2.24 ml");
  EXPECT_EQ(text(0.04349, "ml"), "0.0435 ml");
  EXPECT_EQ(text(16490.0, "triangles"), "16490 triangles");
  EXPECT_EQ(text(-1234.5, "HU"), "-1234 HU");
  EXPECT_EQ(text(0.0, ""), "0") << "a zero that was counted is said";
  EXPECT_EQ(text(std::nullopt, ""), "");
}

}  // namespace
}  // namespace vallecula::pipeline

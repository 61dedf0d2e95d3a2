// The quality report on the screen.
#include <QAbstractTextDocumentLayout>
#include <QScrollBar>
#include <QTextDocument>

#include "gui/import/quality_list.h"
#include "tests/gui/window_screen.h"

namespace vallecula::gui::window_test {
namespace {

const std::vector<pipeline::QualityItem> kItems{
    {"airway volume", 11.12, "ml", true, ""},
    {"glottis area", 6.51, "mm2", true, "", false},
    {"tongue volume", 102.1, "ml", false, "usual for a head of this size: 6 < 55 ml; check its labels"},
    {"carina", std::nullopt, "", false, "inferred: below the scan; continued along the trachea, scaled with the head"}};

class WindowQuality : public Screen {};

TEST_F(WindowQuality, BeginsWithWhatIsToBeCheckedAndHidesNothing) {
  for (const auto remarks : {QualityList::Remarks::below, QualityList::Remarks::beside}) {
    QualityList list(remarks);
    list.resize(390, 300);  // as narrow as the check's side
    list.show();
    list.show_items(kItems);
    EXPECT_EQ(list.to_check(), 2);
    const QString text = list.toPlainText();
    int last = -1;
    for (const char* part : {"To be checked first (2)", "tongue volume", "carina", "Within limits (1)", "airway volume",
                             "For information (1)", "glottis area"}) {
      const int at = text.indexOf(part);
      EXPECT_GT(at, last) << part << "\n" << text.toStdString();
      last = at;
    }
    EXPECT_TRUE(text.contains("6 < 55 ml")) << "a remark is text, not markup";
    EXPECT_TRUE(text.contains("6.51 mm²"));
    EXPECT_LE(list.document()->documentLayout()->documentSize().width(), list.viewport()->width() + 1) << "cut off";
  }
}

TEST_F(WindowQuality, SaysWhatAFigureWasBefore) {
  QualityList list(QualityList::Remarks::beside);
  auto before = kItems;
  before[0].value = 9.0;
  list.show_items(kItems, before);
  EXPECT_TRUE(list.toPlainText().contains("11.1 ml (was 9 ml)")) << list.toPlainText().toStdString();
  EXPECT_EQ(list.toPlainText().count("was"), 1) << "and nothing of what stayed";
  list.show_items(kItems);
  EXPECT_FALSE(list.toPlainText().contains("was"));
}

}  // namespace
}  // namespace vallecula::gui::window_test

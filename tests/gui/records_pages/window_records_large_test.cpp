// The progress page with text a third larger: nothing is cut, in both languages, and the page scrolls.
#include <QTabWidget>

#include "gui/pages/home_page.h"
#include "gui/pages/look_settings.h"
#include "gui/records_pages/progress_tab.h"
#include "gui/records_pages/trial_chart.h"
#include "gui/session/languages.h"
#include "tests/gui/accessible.h"
#include "tests/gui/painted_words.h"
#include "tests/gui/records_pages/window_records.h"

namespace vallecula::gui::window_test {
namespace {

class WindowRecordsLargeText : public WindowRecords, public ::testing::WithParamInterface<const char*> {
 protected:
  WindowRecordsLargeText() {
    LookSettings look;
    look.text_scale = 1.35;
    keep_look(look);
    apply_look(look);
    EXPECT_TRUE(install_language(*qApp, GetParam()));
  }
  ~WindowRecordsLargeText() override {
    window_.reset();
    apply_look({});
    install_language(*qApp, "en");
  }
};

TEST_P(WindowRecordsLargeText, NothingOfAPersonsProgressIsCut) {
  {
    Records records(records_location());
    for (int day = 1; day <= 12; ++day) records.add(row(0, day, day != 1 && day != 3));
  }
  open();
  window_->resize(1280, 800);
  window_->home_page().findChild<QPushButton*>("records")->click();
  ASSERT_EQ(window_->page_name(), "records");
  auto* tabs = page().findChild<QTabWidget*>();
  tabs->setCurrentWidget(page().findChild<ProgressTab*>());
  auto charts = page().findChild<ProgressTab*>()->findChildren<TrialChart*>();
  ASSERT_EQ(charts.size(), 2);
  const bool drawn =
      wait_for([&] { return charts[0]->labels().size() >= 8 && charts[1]->labels().size() >= 8; }, 20000);
  keep_picture(*window_, std::string("records-large-") + GetParam() + ".png");
  ASSERT_TRUE(drawn);
  QApplication::processEvents();
  EXPECT_EQ(window_->size(), QSize(1280, 800));
  EXPECT_EQ(cut_texts(page()), std::vector<std::string>()) << lines(cut_texts(page()));
  for (TrialChart* chart : charts) {
    EXPECT_GE(chart->height(), 8 * chart->fontMetrics().lineSpacing()) << "as many lines as it takes to be read";
    const auto trouble = trouble_of(painted_words(*chart), chart->size());
    EXPECT_EQ(trouble, std::vector<std::string>()) << lines(trouble);
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, WindowRecordsLargeText, ::testing::Values("en", "de"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace vallecula::gui::window_test

#include "gui/report/markdown.h"

#include <gtest/gtest.h>

#include "gui/commands/headless_application.h"

namespace vallecula::gui {
namespace {

TEST(Markdown, IsShownAndAsksNobodyForAnything) {
  const HeadlessApplication application;
  const QString html = html_of(
      "**Lift**, see\n\n- one\n- two\n\n![x](http://example.org/x.png) [there](http://example.org) "
      "<script>alert(1)</script> 3 < 4");
  EXPECT_TRUE(html.contains("<li>one") || html.contains("one</li>")) << html.toStdString();
  EXPECT_TRUE(html.contains("<b>Lift</b>, see")) << html.toStdString();
  EXPECT_TRUE(html_of("*softly*").contains("<i>softly</i>"));
  EXPECT_FALSE(html.contains("**")) << html.toStdString();
  EXPECT_FALSE(html.contains("example.org")) << html.toStdString();
  EXPECT_FALSE(html.contains("<img")) << html.toStdString();
  EXPECT_FALSE(html.contains("<a ")) << html.toStdString();
  EXPECT_FALSE(html.contains("<script")) << html.toStdString();
  EXPECT_TRUE(html.contains("3 &lt; 4")) << html.toStdString();
  EXPECT_TRUE(html_of(curricula::Text()).isEmpty());
}

}  // namespace
}  // namespace vallecula::gui

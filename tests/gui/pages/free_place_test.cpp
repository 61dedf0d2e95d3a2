// Where a panel that leaves its window comes to lie: beside it, else over no other panel, and always on the screen.
#include "gui/pages/free_place.h"

#include <gtest/gtest.h>

namespace vallecula::gui {
namespace {

const QRect kScreen(0, 0, 1920, 1080);

TEST(FreePlace, IsBesideTheWindowWhereThereIsRoom) {
  const QRect window(100, 100, 1200, 800);
  const QPoint first = free_place({400, 300}, kScreen, window, {});
  EXPECT_EQ(first, QPoint(1300, 100)) << "at its right, level with its top";
  const QPoint second = free_place({400, 300}, kScreen, window, {QRect(first, QSize(400, 300))});
  EXPECT_EQ(second, QPoint(1300, 400)) << "below the first";
  EXPECT_EQ(free_place({400, 300}, kScreen, {720, 100, 1200, 800}, {}), QPoint(320, 100)) << "else at its left";
}

TEST(FreePlace, IsOverThePictureRatherThanOverAPanelWhereTheWindowFillsTheScreen) {
  const std::vector<QRect> panels{{1200, 0, 720, 500}, {1200, 500, 720, 580}};
  const QSize size(700, 400);
  const QRect place(free_place(size, kScreen, kScreen, panels), size);
  EXPECT_TRUE(kScreen.contains(place));
  for (const QRect& panel : panels) EXPECT_FALSE(place.intersects(panel));
}

TEST(FreePlace, LeavesNoScreen) {
  for (const QRect& window : {QRect(-300, -200, 900, 700), QRect(1500, 700, 1200, 800), kScreen})
    EXPECT_TRUE(kScreen.contains(QRect(free_place({500, 500}, kScreen, window, {window}), QSize(500, 500))));
  EXPECT_EQ(free_place({4000, 3000}, kScreen, {0, 0, 800, 600}, {}), QPoint(0, 0)) << "larger than the screen";
  const QRect second_screen(1920, 0, 1280, 1024);
  const QPoint there = free_place({400, 300}, second_screen, {1920, 0, 1280, 1024}, {});
  EXPECT_TRUE(second_screen.contains(QRect(there, QSize(400, 300)))) << "on the window's own";
}

}  // namespace
}  // namespace vallecula::gui

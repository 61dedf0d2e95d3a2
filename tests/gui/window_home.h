// The way from the window's first page to the others, as a person goes it.
#pragma once

#include <gtest/gtest.h>

#include <QPushButton>

#include "gui/pages/home_page.h"
#include "gui/pages/main_window.h"

namespace vallecula::gui::window_test {

/// Clicks the choice of this name on the first page.
inline void choose_at_home(MainWindow& window, const char* choice) {
  ASSERT_EQ(window.page_name(), "home");
  auto* button = window.home_page().findChild<QPushButton*>(choice);
  ASSERT_NE(button, nullptr) << choice;
  button->click();
}

/// To where scenario, patient and device are chosen.
inline void open_course_page(MainWindow& window) {
  choose_at_home(window, "course");
  ASSERT_EQ(window.page_name(), "start");
}

}  // namespace vallecula::gui::window_test

// What was opened lately, in a person's words: a trial by its scenario's title and a course by its own, not by their
// files' names.
#pragma once

#include <QString>
#include <vector>

#include "gui/session/recent_files.h"

namespace vallecula::gui {

struct RecentEntry {
  RecentFile file;
  QString words;
};

/// Asks the disk: not for the window's thread. What holds no title (a trial that was cut off) keeps its name.
std::vector<RecentEntry> with_words(const std::vector<RecentFile>& files);

}  // namespace vallecula::gui

// The series at a place, for a person to choose one.
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>
#include <vector>

namespace vallecula::gui {

struct SeriesRow {
  int number = 1;       ///< what ImportChoice::series takes; 0: there is no series at all
  QString description;  ///< kind, size, voxels; nothing of the patient
  bool usable = false;
  QString why;       ///< not usable: what is wrong and how to mend it
  QImage thumbnail;  ///< null where there is none
};

/// All series of a folder, or of one file. Seconds of work: not for the window's thread. A place that holds nothing
/// readable is one row that says so. What `progress` (0..1) throws ends it and reaches the caller.
std::vector<SeriesRow> series_at(const std::filesystem::path& source,
                                 const std::function<void(double)>& progress = {});

}  // namespace vallecula::gui

// The series at a place, for a person to choose one.
#pragma once

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>
#include <vector>

namespace vallecula::gui {

struct SeriesRow {
  int number = 1;       ///< counted from 1
  QString id;           ///< what ImportChoice::series takes
  QString description;  ///< matrix, slices, voxels; nothing of the patient
  bool usable = false;
  QString why;       ///< not usable: what is wrong and how to mend it; usable: notes
  QImage thumbnail;  ///< a mid-sagittal cut; null where there is none
};

/// All series of a folder, or of one file. Seconds of work: not for the window's thread. `progress` gets 0..1 and may
/// throw to end it. A place that holds nothing readable is one row that says so.
std::vector<SeriesRow> series_at(const std::filesystem::path& source, const std::function<void(double)>& progress);

}  // namespace vallecula::gui

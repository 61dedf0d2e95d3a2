#include "gui/import/series_rows.h"

#include <QCoreApplication>
#include <cstring>

#include "pipeline/dicom/read_series.h"

namespace vallecula::gui {
namespace {

QImage picture_of(const pipeline::Thumbnail& thumbnail) {
  if (thumbnail.grey.empty()) return {};
  QImage picture(thumbnail.width, thumbnail.height, QImage::Format_Grayscale8);
  for (int y = 0; y < thumbnail.height; ++y)
    std::memcpy(picture.scanLine(y), &thumbnail.grey[static_cast<std::size_t>(y) * thumbnail.width],
                static_cast<std::size_t>(thumbnail.width));
  return picture;
}

}  // namespace

std::vector<SeriesRow> series_at(const std::filesystem::path& source, const std::function<void(double)>& progress) {
  std::vector<SeriesRow> rows;
  try {
    for (const auto& entry : pipeline::list_series(source, true, progress))
      rows.push_back({entry.number, QString::fromStdString(pipeline::described(entry)), entry.usable,
                      QString::fromStdString(entry.reason), picture_of(entry.thumbnail)});
  } catch (const pipeline::SeriesError& error) {
    rows.push_back(
        {0, QCoreApplication::translate("SeriesRows", "No series"), false, QString::fromUtf8(error.what()), {}});
  }
  return rows;
}

}  // namespace vallecula::gui

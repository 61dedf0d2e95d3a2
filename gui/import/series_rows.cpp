#include "gui/import/series_rows.h"

#include <algorithm>
#include <cmath>

#include "gui/views/slice_picture.h"
#include "pipeline/dicom/read_series.h"

namespace vallecula::gui {
namespace {

constexpr int kThumbnail = 160;  // pixels

QString millimetres(double mm) { return QString::number(mm, 'g', 3); }

QImage thumbnail_of(const pipeline::Hounsfield& hu) {
  const auto& g = hu.grid;
  const QImage cut = slice_picture(hu, SlicePlane::sagittal, g.size[0] / 2, GreyTable({200.0, 1400.0}), {});
  const double wide = g.size[1] * g.spacing[1], high = g.size[2] * g.spacing[2], most = std::max(wide, high);
  return cut.scaled(std::max(1, static_cast<int>(std::lround(kThumbnail * wide / most))),
                    std::max(1, static_cast<int>(std::lround(kThumbnail * high / most))), Qt::IgnoreAspectRatio,
                    Qt::SmoothTransformation);
}

}  // namespace

std::vector<SeriesRow> series_at(const std::filesystem::path& source, const std::function<void(double)>& progress) {
  SeriesRow row;
  try {
    const auto series = pipeline::read_ct_series(source, progress);
    row.usable = true;
    row.description = QString("CT, %1 slices of %2 x %3, voxels %4 x %5 x %6 mm")
                          .arg(series.slices)
                          .arg(series.matrix[0])
                          .arg(series.matrix[1])
                          .arg(millimetres(series.source_spacing[0]), millimetres(series.source_spacing[1]),
                               millimetres(series.source_spacing[2]));
    for (const auto& note : series.notes) row.why += (row.why.isEmpty() ? "" : "\n") + QString::fromStdString(note);
    row.thumbnail = thumbnail_of(series.hu);
  } catch (const pipeline::SeriesError& error) {
    row.description = "cannot be used";
    row.why = QString::fromUtf8(error.what());
  }
  return {row};
}

}  // namespace vallecula::gui

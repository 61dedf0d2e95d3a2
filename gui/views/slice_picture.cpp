#include "gui/views/slice_picture.h"

#include <algorithm>

#include "pipeline/package/label_map.h"

namespace vallecula::gui {
namespace {

constexpr std::array<double, 3> kThresholdTint{0.35, 0.95, 0.95};

QRgb mixed(int grey, const std::array<double, 3>& colour, double opacity) {
  const auto channel = [&](double c) {
    return std::clamp(static_cast<int>((1.0 - opacity) * grey + opacity * 255.0 * c + 0.5), 0, 255);
  };
  return qRgb(channel(colour[0]), channel(colour[1]), channel(colour[2]));
}

}  // namespace

QImage slice_picture(const pipeline::Hounsfield& hu, SlicePlane plane, int index, const GreyTable& grey,
                     const LabelOverlay& overlay) {
  const SliceAxes axes = axes_of(plane);
  const auto& grid = hu.grid;
  const std::array<std::size_t, 3> step{1, static_cast<std::size_t>(grid.size[0]),
                                        static_cast<std::size_t>(grid.size[0]) * grid.size[1]};
  const int columns = grid.size[axes.across], rows = grid.size[axes.down];
  std::array<const std::array<double, 3>*, 256> colour{};
  if (overlay.labels != nullptr && overlay.opacity > 0.0)
    for (const auto& label : pipeline::kLabelNames)
      if (overlay.visible[label.value]) colour[label.value] = &label.rgb;

  QImage picture(columns, rows, QImage::Format_RGB32);
  for (int row = 0; row < rows; ++row) {
    auto* line = reinterpret_cast<QRgb*>(picture.scanLine(row));
    const int down = axes.down_sign > 0.0 ? row : rows - 1 - row;
    std::size_t at =
        static_cast<std::size_t>(index) * step[axes.through] + static_cast<std::size_t>(down) * step[axes.down];
    for (int column = 0; column < columns; ++column, at += step[axes.across]) {
      const std::int16_t value = hu.voxels[at];
      const int g = grey[value];
      const auto* over = overlay.labels != nullptr ? colour[overlay.labels->voxels[at]] : nullptr;
      line[column] = over != nullptr ? mixed(g, *over, overlay.opacity) : qRgb(g, g, g);
      if (overlay.threshold && value >= (*overlay.threshold)[0] && value <= (*overlay.threshold)[1])
        line[column] = mixed(g, kThresholdTint, 0.45);
    }
  }
  return picture;
}

}  // namespace vallecula::gui

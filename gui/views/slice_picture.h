// One slice as a picture, a pixel a voxel: grey by window, labels over it.
#pragma once

#include <QImage>
#include <array>
#include <optional>

#include "gui/views/grey_window.h"
#include "gui/views/slice_plane.h"
#include "pipeline/volume.h"

namespace vallecula::gui {

struct LabelOverlay {
  const pipeline::Labels* labels = nullptr;  ///< on the scan's grid; none: grey only
  double opacity = 0.4;                      ///< 0..1
  std::array<bool, 256> visible{};           ///< by label value
  /// Voxels between these HU are tinted: what a threshold would take.
  std::optional<std::array<double, 2>> threshold;
};

/// Columns run along axes_of(plane).across, rows downwards on the screen; `index` counts along `through` and must lie
/// in the grid.
QImage slice_picture(const pipeline::Hounsfield& hu, SlicePlane plane, int index, const GreyTable& grey,
                     const LabelOverlay& overlay);

}  // namespace vallecula::gui

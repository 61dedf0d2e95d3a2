#include "pipeline/dicom/volume_header.h"

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {

std::size_t bytes_of(VoxelType type) {
  switch (type) {
    case VoxelType::int8:
    case VoxelType::uint8:
      return 1;
    case VoxelType::int16:
    case VoxelType::uint16:
      return 2;
    case VoxelType::float64:
      return 8;
    default:
      return 4;
  }
}

void check_volume_header(const VolumeHeader& header) {
  const auto& g = header.geometry;
  std::int64_t count = 1;
  for (const int n : g.size) {
    if (n < 2) throw SeriesError("is no volume of three dimensions; export the CT as one volume");
    count *= n;
    if (n > kLargestSide || count > kMostVoxels) {
      throw SeriesError("its header asks for " + std::to_string(g.size[0]) + " x " + std::to_string(g.size[1]) + " x " +
                        std::to_string(g.size[2]) + " voxels, more than any CT this program reads; is it damaged?");
    }
  }
  bool good = std::isfinite(header.slope) && std::isfinite(header.intercept) && header.slope != 0.0;
  for (int k = 0; k < 3; ++k) {
    const double spacing = norm(g.step[k]);
    good = good && std::isfinite(g.origin[k]) && std::abs(g.origin[k]) < 1e5 && spacing > 1e-3 && spacing < 100.0;
  }
  const double volume = std::abs(dot(cross(g.step[0], g.step[1]), g.step[2]));
  good = good && volume > 0.1 * norm(g.step[0]) * norm(g.step[1]) * norm(g.step[2]);
  if (!good) throw SeriesError("its header gives no place and size that a CT can have; export it again");
}

}  // namespace vallecula::pipeline

// The few operations on voxel volumes that the segmentation is made of. VTK's own work on boxes of voxels; these work
// in millimetres, so that anisotropic series are treated alike.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// Inclusive voxel ranges.
struct Box {
  std::array<int, 3> low{0, 0, 0};
  std::array<int, 3> high{-1, -1, -1};
  bool empty() const { return high[0] < low[0] || high[1] < low[1] || high[2] < low[2]; }
};

Box whole(const Grid& grid);
/// Smallest box around the ones, widened by `margin_mm` and cut at the grid.
Box bounds_of(const Mask& mask, double margin_mm = 0.0);
/// Box between two points (any order), cut at the grid.
Box box_between(const Grid& grid, const std::array<double, 3>& a, const std::array<double, 3>& b);
Grid cropped(const Grid& grid, const Box& box);

template <class T>
Volume<T> cropped(const Volume<T>& volume, const Box& box) {
  Volume<T> out(cropped(volume.grid, box));
  const int length = box.high[0] - box.low[0] + 1;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y)
      std::copy_n(&volume.at(box.low[0], y, z), length, &out.at(0, y - box.low[1], z - box.low[2]));
  }
  return out;
}

/// Writes `part` back to where `box` was cut out.
template <class T>
void paste(const Volume<T>& part, const Box& box, Volume<T>& into) {
  const int length = box.high[0] - box.low[0] + 1;
  for (int z = box.low[2]; z <= box.high[2]; ++z) {
    for (int y = box.low[1]; y <= box.high[1]; ++y)
      std::copy_n(&part.at(0, y - box.low[1], z - box.low[2]), length, &into.at(box.low[0], y, z));
  }
}

std::size_t count(const Mask& mask);
Mask all_of(const Mask& a, const Mask& b);
Mask any_of(const Mask& a, const Mask& b);
Mask without(const Mask& a, const Mask& b);
Mask inverted(const Mask& a);

template <class T, class Test>
Mask where(const Volume<T>& volume, const Test& test) {
  Mask out(volume.grid);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i) out.voxels[i] = test(volume.voxels[i]) ? 1 : 0;
  return out;
}

/// Exact Euclidean distance (mm, between voxel centres) to the nearest one; 1e9 where there is none (Felzenszwalb and
/// Huttenlocher 2012).
Volume<float> distance_to(const Mask& mask);
/// Positive inside, about half a voxel each side of the border.
Volume<float> signed_distance(const Mask& mask);
Mask dilated(const Mask& mask, double mm);
Mask eroded(const Mask& mask, double mm);  ///< the grid's border does not erode
Mask opened(const Mask& mask, double mm);
Mask closed(const Mask& mask, double mm);

/// Gaussian of the given standard deviation; the border value continues outside.
Volume<float> smoothed(const Volume<float>& volume, double sigma_mm);
Volume<float> to_float(const Hounsfield& volume);
Volume<float> to_float(const Mask& mask);

/// 6-connected components: id 0 is "not in the mask"; ids 1.. in order of size, largest first.
struct Components {
  Volume<int> id;
  std::vector<std::size_t> sizes;  ///< sizes[id]
  Mask mask(int which) const;
};
Components components(const Mask& mask);
/// The id of the piece with the voxel nearest to a point, within `reach_mm` of it; 0 where there is none.
int piece_at(const Components& parts, const std::array<double, 3>& point, double reach_mm);
Mask largest_component(const Mask& mask);
/// The 6-connected parts of `allowed` that hold a one of `seed`.
Mask grown(const Mask& seed, const Mask& allowed);
/// Adds what is enclosed by ones (not 6-connected to the grid's border through zeros).
Mask with_holes_filled(const Mask& mask);
/// What ones enclose within one axial slice, on a grid of that slice alone.
Mask holes_of_slice(const Mask& mask, int z);

/// Shares `allowed` among the markers (values > 0) by flooding in order of `cost` (seeded watershed); a cheaper place
/// is flooded first, ties by distance travelled. 0 where no marker reaches.
Volume<std::uint8_t> flooded(const Volume<float>& cost, const Volume<std::uint8_t>& markers, const Mask& allowed);

/// Shares `allowed` among the markers by who travels there more cheaply; `cost` is the price of a millimetre, > 0.
/// Unlike flooding, a small gap in a ridge lets only its surroundings through.
Volume<std::uint8_t> shared_by_travel(const Volume<float>& cost, const Volume<std::uint8_t>& markers,
                                      const Mask& allowed);

/// Shortest way (mm, through 26 neighbours) inside `allowed` from the ones of `seed`; 1e9 where there is none.
Volume<float> path_length(const Mask& seed, const Mask& allowed);

/// Trilinear value at a point, mm; the border value continues outside.
double value_at(const Volume<float>& volume, const std::array<double, 3>& p);
/// The same of grey values; exactly a voxel's own at its centre.
double grey_at(const Hounsfield& hu, const std::array<double, 3>& p);

}  // namespace vallecula::pipeline

#include "gui/views/label_surfaces.h"

#include <vtkNew.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>
#include <array>

#include "gui/session/poly_data.h"
#include "pipeline/mesh/isosurface.h"
#include "pipeline/package/label_map.h"
#include "pipeline/segment/volume_ops.h"

namespace vallecula::gui {
namespace {

using pipeline::Box;

// So many voxels along a structure are enough for a look.
constexpr double kVoxels = 110.0, kFinestMm = 0.5, kCoarsestMm = 1.6;

std::array<Box, 256> boxes_of(const pipeline::Labels& labels) {
  std::array<Box, 256> boxes;
  for (auto& box : boxes) box.low = labels.grid.size;
  const auto& n = labels.grid.size;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) {
        Box& box = boxes[labels.at(x, y, z)];
        const std::array<int, 3> c{x, y, z};
        for (int a = 0; a < 3; ++a) {
          box.low[a] = std::min(box.low[a], c[a]);
          box.high[a] = std::max(box.high[a], c[a]);
        }
      }
  return boxes;
}

/// The share of a block of voxels that is inside, with an empty rim so that the surface is closed: a thin wall thins
/// out instead of getting holes.
template <class Inside>
pipeline::Volume<float> shares(const pipeline::Labels& labels, const Box& box, double wanted_mm, const Inside& inside) {
  const auto& g = labels.grid;
  pipeline::Grid coarse;
  std::array<int, 3> stride{};
  for (int a = 0; a < 3; ++a) {
    stride[a] = std::max(1, static_cast<int>(wanted_mm / g.spacing[a] + 0.25));
    coarse.spacing[a] = stride[a] * g.spacing[a];
    coarse.size[a] = (box.high[a] - box.low[a]) / stride[a] + 5;
    coarse.origin[a] = g.origin[a] + (box.low[a] - 2 * stride[a] + 0.5 * (stride[a] - 1)) * g.spacing[a];
  }
  pipeline::Volume<float> out(coarse, 0.0f);
  const float share = 1.0f / static_cast<float>(stride[0] * stride[1] * stride[2]);
  for (int z = box.low[2]; z <= box.high[2]; ++z)
    for (int y = box.low[1]; y <= box.high[1]; ++y)
      for (int x = box.low[0]; x <= box.high[0]; ++x)
        if (inside(labels.at(x, y, z)))
          out.at(2 + (x - box.low[0]) / stride[0], 2 + (y - box.low[1]) / stride[1],
                 2 + (z - box.low[2]) / stride[2]) += share;
  return out;
}

double voxel_for(const pipeline::Grid& grid, const Box& box) {
  double extent = 0.0;
  for (int a = 0; a < 3; ++a) extent = std::max(extent, (box.high[a] - box.low[a]) * grid.spacing[a]);
  return std::clamp(extent / kVoxels, kFinestMm, kCoarsestMm);
}

vtkSmartPointer<vtkPolyData> surface_of(pipeline::Volume<float> field) {
  const auto& d = field.grid.spacing;
  field = pipeline::smoothed(field, 0.6 * std::max({d[0], d[1], d[2]}));
  for (float& v : field.voxels) v -= 0.4f;  // a little below half: thin walls stay whole
  const auto surface = pipeline::isosurface(field);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(poly_data(surface.points, surface.triangles));
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}

}  // namespace

std::map<std::uint8_t, vtkSmartPointer<vtkPolyData>> label_surfaces(const pipeline::Labels& labels,
                                                                    const std::function<bool()>& go_on) {
  std::map<std::uint8_t, vtkSmartPointer<vtkPolyData>> surfaces;
  const auto boxes = boxes_of(labels);
  Box all;
  all.low = labels.grid.size;
  for (const auto& label : pipeline::kLabelNames) {
    const Box& box = boxes[label.value];
    if (box.empty()) continue;
    for (int a = 0; a < 3; ++a) {
      all.low[a] = std::min(all.low[a], box.low[a]);
      all.high[a] = std::max(all.high[a], box.high[a]);
    }
    if (label.value == pipeline::kSkin) continue;
    if (go_on && !go_on()) return surfaces;
    surfaces[label.value] =
        surface_of(shares(labels, box, voxel_for(labels.grid, box), [&](std::uint8_t v) { return v == label.value; }));
  }
  if (!all.empty() && !boxes[pipeline::kSkin].empty() && (!go_on || go_on()))
    surfaces[pipeline::kSkin] =
        surface_of(shares(labels, all, voxel_for(labels.grid, all), [](std::uint8_t v) { return v != 0; }));
  return surfaces;
}

}  // namespace vallecula::gui

#include "pipeline/mesh/isosurface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "pipeline/mesh/vector3.h"

namespace vallecula::pipeline {

Surface isosurface(const Volume<float>& field) {
  const auto& g = field.grid;
  const float scale = static_cast<float>(*std::min_element(g.spacing.begin(), g.spacing.end()));
  vtkNew<vtkImageData> image;
  image->SetDimensions(g.size[0] + 2, g.size[1] + 2, g.size[2] + 2);
  image->SetSpacing(g.spacing.data());
  image->SetOrigin(g.origin[0] - g.spacing[0], g.origin[1] - g.spacing[1], g.origin[2] - g.spacing[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(values, image->GetNumberOfPoints(), -scale);
  const std::size_t row = g.size[0] + 2;
  const std::size_t plane = row * (g.size[1] + 2);
  for (int z = 0; z < g.size[2]; ++z) {
    for (int y = 0; y < g.size[1]; ++y) {
      for (int x = 0; x < g.size[0]; ++x) {
        float v = std::clamp(field.at(x, y, z), -scale, scale);
        const float least = 0.03F * scale;
        if (std::abs(v) < least) v = v < 0.0F ? -least : least;
        values[(z + 1) * plane + (y + 1) * row + x + 1] = v;
      }
    }
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  auto* out = contour->GetOutput();
  Surface s;
  s.points.resize(static_cast<std::size_t>(out->GetNumberOfPoints()));
  for (std::size_t i = 0; i < s.points.size(); ++i) out->GetPoint(static_cast<vtkIdType>(i), s.points[i].data());
  vtkIdType n = 0;
  const vtkIdType* ids = nullptr;
  auto* cells = out->GetPolys();
  s.triangles.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
  double volume = 0.0;
  for (cells->InitTraversal(); cells->GetNextCell(n, ids);) {
    s.triangles.push_back({static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2])});
    volume += dot(s.points[ids[0]], cross(s.points[ids[1]], s.points[ids[2]]));
  }
  if (volume < 0.0) {
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
  }
  return s;
}

}  // namespace vallecula::pipeline

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
namespace {

/// From sample numbers (-1 is the padding before the first) to mm.
double coordinate(const std::vector<double>& axis, double index) {
  const int n = static_cast<int>(axis.size());
  const int i = std::clamp(static_cast<int>(std::floor(index)), 0, n - 2);
  return axis[i] + (index - i) * (axis[i + 1] - axis[i]);
}

}  // namespace

Surface isosurface(const std::array<std::vector<double>, 3>& axes, const std::vector<float>& values) {
  const std::array<int, 3> n{static_cast<int>(axes[0].size()), static_cast<int>(axes[1].size()),
                             static_cast<int>(axes[2].size())};
  float scale = 1e9F;
  for (const auto& axis : axes) {
    for (std::size_t i = 1; i < axis.size(); ++i) scale = std::min(scale, static_cast<float>(axis[i] - axis[i - 1]));
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(n[0] + 2, n[1] + 2, n[2] + 2);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* padded = static_cast<float*>(image->GetScalarPointer());
  std::fill_n(padded, image->GetNumberOfPoints(), -scale);
  const std::size_t row = n[0] + 2;
  const std::size_t plane = row * (n[1] + 2);
  const float least = 0.03F * scale;
  std::size_t k = 0;
  for (int z = 0; z < n[2]; ++z) {
    for (int y = 0; y < n[1]; ++y) {
      for (int x = 0; x < n[0]; ++x, ++k) {
        float v = values[k];
        if (std::abs(v) < least) v = v < 0.0F ? -least : least;
        padded[(z + 1) * plane + (y + 1) * row + x + 1] = v;
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
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    std::array<double, 3> index{};
    out->GetPoint(static_cast<vtkIdType>(i), index.data());
    for (int a = 0; a < 3; ++a) s.points[i][a] = coordinate(axes[a], index[a]);
  }
  vtkIdType corners = 0;
  const vtkIdType* ids = nullptr;
  auto* cells = out->GetPolys();
  s.triangles.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
  double volume = 0.0;
  for (cells->InitTraversal(); cells->GetNextCell(corners, ids);) {
    s.triangles.push_back({static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2])});
    volume += dot(s.points[ids[0]], cross(s.points[ids[1]], s.points[ids[2]]));
  }
  if (volume < 0.0) {
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
  }
  return s;
}

Surface isosurface(const Volume<float>& field) {
  std::array<std::vector<double>, 3> axes;
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < field.grid.size[a]; ++i) axes[a].push_back(field.grid.origin[a] + i * field.grid.spacing[a]);
  }
  return isosurface(axes, field.voxels);
}

std::vector<double> graded_axis(double low, double high, double fine_low, double fine_high, double fine,
                                double coarse) {
  fine_low = std::clamp(fine_low, low, high);
  fine_high = std::clamp(fine_high, fine_low, high);
  std::vector<double> below;
  double step = fine;
  for (double v = fine_low - step; v > low; v -= step) {
    below.push_back(v);
    step = std::min(1.25 * step, coarse);
  }
  if (below.empty() || below.back() - low > 0.3 * step) {
    below.push_back(low);
  } else {
    below.back() = low;
  }
  if (fine_low - low < 1e-9) below.clear();
  std::vector<double> axis(below.rbegin(), below.rend());
  const int cells = std::max(1, static_cast<int>(std::ceil((fine_high - fine_low) / fine)));
  for (int i = 0; i <= cells; ++i) axis.push_back(fine_low + (fine_high - fine_low) * i / cells);
  step = fine;
  for (double v = fine_high + step; v < high; v += step) {
    axis.push_back(v);
    step = std::min(1.25 * step, coarse);
  }
  if (high - axis.back() > 0.3 * step) {
    axis.push_back(high);
  } else if (high > fine_high) {
    axis.back() = high;
  }
  return axis;
}

}  // namespace vallecula::pipeline

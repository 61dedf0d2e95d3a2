#include "gui/views/openness.h"

#include <vtkImageData.h>
#include <vtkImageStencilToImage.h>
#include <vtkNew.h>
#include <vtkPolyDataToImageStencil.h>

#include <algorithm>
#include <cmath>

namespace vallecula::gui {
namespace {
constexpr int kDirections = 28;
constexpr double kVoxelsAcross =
    110.0;  // the longest side of the grid: fine enough for a lip, cheap enough to wait for
constexpr double kPi = 3.14159265358979323846;
}  // namespace

Openness::Openness(const std::vector<vtkPolyData*>& solids, double reach_mm) : reach_(reach_mm) {
  double bounds[6] = {1e30, -1e30, 1e30, -1e30, 1e30, -1e30};
  for (auto* solid : solids) {
    double b[6];
    solid->GetBounds(b);
    for (int axis = 0; axis < 3; ++axis) {
      bounds[2 * axis] = std::min(bounds[2 * axis], b[2 * axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], b[2 * axis + 1]);
    }
  }
  double longest = 1.0;
  for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, bounds[2 * axis + 1] - bounds[2 * axis]);
  spacing_ = std::max(0.8, longest / kVoxelsAcross);
  for (int axis = 0; axis < 3; ++axis) {
    origin_[axis] = bounds[2 * axis] - spacing_;
    size_[axis] = static_cast<int>((bounds[2 * axis + 1] - bounds[2 * axis]) / spacing_) + 3;
  }
  voxels_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], 0);
  for (auto* solid : solids) {
    vtkNew<vtkPolyDataToImageStencil> stencil;
    stencil->SetInputData(solid);
    stencil->SetOutputOrigin(origin_.data());
    stencil->SetOutputSpacing(spacing_, spacing_, spacing_);
    stencil->SetOutputWholeExtent(0, size_[0] - 1, 0, size_[1] - 1, 0, size_[2] - 1);
    vtkNew<vtkImageStencilToImage> image;
    image->SetInputConnection(stencil->GetOutputPort());
    image->SetInsideValue(1);
    image->SetOutsideValue(0);
    image->SetOutputScalarTypeToUnsignedChar();
    image->Update();
    const auto* inside = static_cast<const std::uint8_t*>(image->GetOutput()->GetScalarPointer());
    for (std::size_t i = 0; i < voxels_.size(); ++i) voxels_[i] |= inside[i];
  }
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < kDirections; ++i) {
    const double radius = std::sqrt((i + 0.5) / kDirections);  // uniform on the disc = cosine-weighted on the dome
    directions_.push_back(
        {radius * std::cos(i * golden), radius * std::sin(i * golden), std::sqrt(1.0 - radius * radius)});
  }
}

bool Openness::solid(double x, double y, double z) const {
  const int i = static_cast<int>((x - origin_[0]) / spacing_ + 0.5),
            j = static_cast<int>((y - origin_[1]) / spacing_ + 0.5),
            k = static_cast<int>((z - origin_[2]) / spacing_ + 0.5);
  if (i < 0 || j < 0 || k < 0 || i >= size_[0] || j >= size_[1] || k >= size_[2]) return false;
  return voxels_[(static_cast<std::size_t>(k) * size_[1] + j) * size_[0] + i] != 0;
}

double Openness::at(const std::array<double, 3>& p, const std::array<double, 3>& n) const {
  // Any frame about the normal will do; Duff et al. 2017 give one without a branch at the poles.
  const double sign = std::copysign(1.0, n[2]), a = -1.0 / (sign + n[2]), b = n[0] * n[1] * a;
  const std::array<double, 3> u{1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
      v{b, sign + n[1] * n[1] * a, -n[1]};
  const double lift = 1.3 * spacing_;  // off the point's own voxel
  double open = 0.0;
  for (const auto& d : directions_) {
    std::array<double, 3> ray{};
    for (int axis = 0; axis < 3; ++axis) ray[axis] = d[0] * u[axis] + d[1] * v[axis] + d[2] * n[axis];
    double free = 1.0;
    for (double t = 0.5 * spacing_; t < reach_; t += spacing_) {
      if (solid(p[0] + lift * n[0] + t * ray[0], p[1] + lift * n[1] + t * ray[1], p[2] + lift * n[2] + t * ray[2])) {
        free = t / reach_;
        break;
      }
    }
    open += free;
  }
  return open / static_cast<double>(directions_.size());
}

}  // namespace vallecula::gui

// A surface swept along what the second hand holds: points fixed to a place along the axis and across it, moved with
// the rod's nodes. Its triangles and texture never change.
#pragma once

#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "engine/snapshot.h"

namespace vallecula::gui {

/// Name of the point array (3 floats) with the axis' direction, for shaders that must know it.
constexpr const char* kAlongAxis = "AlongAxis";

/// Where the axis is and how it lies, at any distance from the tip; straight on beyond the grip.
class SweptAxis {
 public:
  /// The rod of a snapshot, m. Takes its length as it lies: a rod stretches by less than a per cent.
  SweptAxis(const std::array<engine::Vec3, engine::kTubeNodes>& nodes,
            const std::array<engine::Quat, engine::kTubeSegments>& frames);
  struct Place {
    engine::Vec3 at;    ///< m
    engine::Mat3 axes;  ///< columns: along (to the connector), across, concave side
  };
  Place at(double from_tip_m) const;
  double length_m() const { return segment_ * engine::kTubeSegments; }

 private:
  std::array<engine::Vec3, engine::kTubeNodes> nodes_;
  std::array<engine::Quat, engine::kTubeNodes> frames_;  ///< at the nodes
  double segment_ = 1e-3;
};

class SweptSurface {
 public:
  struct Point {
    double from_tip_m = 0.0;
    engine::Vec3 offset_m = engine::Vec3::Zero();  ///< in the axis' frame
    engine::Vec3 normal = engine::Vec3::UnitY();   ///< likewise
    std::array<float, 2> texture{};
  };
  SweptSurface(std::vector<Point> points, const std::vector<std::array<int, 3>>& triangles);
  /// A body of revolution about the axis from rings (distance from the tip, radius, m); `around` points each.
  static SweptSurface turned(const std::vector<std::array<double, 2>>& rings, int around);
  void update(const SweptAxis& axis);
  /// Points (mm), normals, texture coordinates and kAlongAxis; the same object for life.
  vtkPolyData* surface() const { return surface_; }

 private:
  std::vector<Point> points_;
  vtkSmartPointer<vtkPolyData> surface_;
  vtkSmartPointer<vtkFloatArray> normals_, along_;
};

}  // namespace vallecula::gui

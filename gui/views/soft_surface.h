// The skin of the soft tissue as the operator sees it: a fine surface that rides on the tetrahedra, or, where there is
// none, their boundary, made finer and round for the eye.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "gui/views/fine_tongue.h"
#include "gui/views/openness.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

class SoftSurface {
 public:
  /// `levels`: how often every triangle is split in four (curved by Phong tessellation: the mesh's own nodes stay where
  /// the engine put them).
  SoftSurface(const pipeline::TetMesh& mesh, int levels);
  /// `fine` (mm, at rest, closed, outward) rides on the tetrahedra instead; coarser than that is their own boundary.
  SoftSurface(const pipeline::TetMesh& mesh, const pipeline::Surface& fine);
  /// Shades the colours by the light that reaches the tongue at rest.
  void shade(const Openness& openness);
  /// New node positions: x y z (m) per node of the tet mesh, in the package's order. Anything else is ignored.
  void update(const std::vector<float>& soft_points_m);
  /// Shows this many levels fewer than there are.
  void set_coarser(int levels);
  /// Points (mm), normals and colours; the same object for life, changed in place by update().
  vtkPolyData* surface() const { return surface_; }
  /// The tetrahedra's own boundary at rest, closed (mm).
  vtkSmartPointer<vtkPolyData> boundary() const;

 private:
  struct Level {
    std::vector<std::array<int, 2>> edges;  ///< a new point in the middle of each; numbered after the coarser points
    std::vector<std::array<int, 3>> triangles;  ///< of the finer mesh
  };
  SoftSurface(const pipeline::TetMesh& mesh, int levels, const pipeline::Surface* fine);
  void compute_normals(const std::vector<std::array<int, 3>>& triangles, std::size_t points);
  void refine_and_publish();

  std::size_t nodes_ = 0;                      ///< of the tet mesh
  std::vector<int> node_of_;                   ///< tet-mesh node of each boundary point
  std::vector<std::array<int, 3>> triangles_;  ///< boundary, outward
  std::vector<Level> levels_;
  std::size_t shown_levels_ = 0;
  std::vector<TetTie> ties_;  ///< of the fine surface's points, the last ones
  std::vector<std::array<int, 3>> fine_;
  bool fine_shown_ = false;
  std::vector<std::array<float, 3>> points_, normals_, bumps_;
  vtkSmartPointer<vtkPolyData> surface_;
};

}  // namespace vallecula::gui

// Surfaces as they are drawn: with fewer triangles than they were made of. Without a graphics card a view costs by its
// triangles, whether a flat place has four of them or forty.
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace vallecula::gui {

/// Points and triangles alone (no arrays), at most about so many of them, by quadric error (Garland and Heckbert 1997):
/// curved places keep theirs. A surface that has no more is given back with the same points in the same order.
vtkSmartPointer<vtkPolyData> with_fewer_triangles(vtkPolyData* surface, int triangles);

/// The same, with the point arrays of the nearest place on what it was made of.
vtkSmartPointer<vtkPolyData> with_fewer_triangles_and_its_arrays(vtkPolyData* surface, int triangles);

}  // namespace vallecula::gui

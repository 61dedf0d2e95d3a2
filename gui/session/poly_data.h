// A triangle mesh as VTK takes it.
#pragma once

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

namespace vallecula::gui {

inline vtkSmartPointer<vtkCellArray> cells_of(const std::vector<std::array<int, 3>>& triangles) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& t : triangles) {
    const vtkIdType ids[3] = {t[0], t[1], t[2]};
    cells->InsertNextCell(3, ids);
  }
  return cells;
}

/// Points (three numbers each) times `scale` with their triangles, in single precision unless told VTK_DOUBLE.
template <class Points>
vtkSmartPointer<vtkPolyData> poly_data(const Points& points, const std::vector<std::array<int, 3>>& triangles,
                                       double scale = 1.0, int precision = VTK_FLOAT) {
  auto at = vtkSmartPointer<vtkPoints>::New();
  at->SetDataType(precision);
  for (const auto& p : points) at->InsertNextPoint(scale * p[0], scale * p[1], scale * p[2]);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(at);
  data->SetPolys(cells_of(triangles));
  return data;
}

}  // namespace vallecula::gui

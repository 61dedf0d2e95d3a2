// A package surface as VTK data.
#pragma once

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

inline vtkNew<vtkPolyData> to_vtk(const Surface& s) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(s.points.size()));
  for (std::size_t i = 0; i < s.points.size(); ++i) points->SetPoint(static_cast<vtkIdType>(i), s.points[i].data());
  vtkNew<vtkCellArray> cells;
  for (const auto& t : s.triangles) {
    const std::array<vtkIdType, 3> ids{t[0], t[1], t[2]};
    cells->InsertNextCell(3, ids.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

}  // namespace vallecula::pipeline

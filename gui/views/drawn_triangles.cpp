#include "gui/views/drawn_triangles.h"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkQuadricDecimation.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>

namespace vallecula::gui {

vtkSmartPointer<vtkPolyData> with_fewer_triangles(vtkPolyData* surface, int triangles) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(surface->GetPoints());
  result->SetPolys(surface->GetPolys());
  if (surface->GetNumberOfPolys() <= triangles) return result;
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(result);
  decimation->SetTargetReduction(1.0 - triangles / static_cast<double>(surface->GetNumberOfPolys()));
  decimation->VolumePreservationOn();
  decimation->Update();
  return decimation->GetOutput();
}

vtkSmartPointer<vtkPolyData> with_fewer_triangles_and_its_arrays(vtkPolyData* surface, int triangles) {
  const auto result = with_fewer_triangles(surface, triangles);
  vtkNew<vtkStaticCellLocator> places;
  places->SetDataSet(surface);
  places->BuildLocator();
  vtkPointData *from = surface->GetPointData(), *to = result->GetPointData();
  to->InterpolateAllocate(from, result->GetNumberOfPoints());
  vtkNew<vtkGenericCell> triangle;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i) {
    double p[3], nearest[3], distance2 = 0.0, coordinates[3], weights[3];
    vtkIdType cell = -1;
    int part = 0;
    result->GetPoint(i, p);
    places->FindClosestPoint(p, nearest, triangle, cell, part, distance2);
    triangle->EvaluatePosition(nearest, nullptr, part, coordinates, distance2, weights);
    to->InterpolatePoint(from, i, triangle->GetPointIds(), weights);
  }
  return result;
}

}  // namespace vallecula::gui

#include "pipeline/mesh/projector.h"

#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include "pipeline/mesh/to_vtk.h"

namespace vallecula::pipeline {

struct Projector::Locator {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkStaticCellLocator> cells;
};

Projector::Projector(const Surface& surface) : locator_(std::make_unique<Locator>()) {
  locator_->data->ShallowCopy(to_vtk(surface));
  locator_->cells->SetDataSet(locator_->data);
  locator_->cells->BuildLocator();
}

Projector::~Projector() = default;

Point Projector::nearest(const Point& p) const {
  Point closest = p;
  vtkIdType cell = -1;
  int sub = 0;
  double d2 = 0.0;
  locator_->cells->FindClosestPoint(p.data(), closest.data(), cell, sub, d2);
  return cell >= 0 ? closest : p;
}

}  // namespace vallecula::pipeline

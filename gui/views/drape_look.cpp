#include "gui/views/drape_look.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vallecula::gui {
namespace {

constexpr int kClothSides = 64, kClothRings = 30;
constexpr double kStep_mm = 5.0, kOverSkin_mm = 3.0;
constexpr double kShoulders_mm = 40.0;         // from the hem down to where the cloth is as wide as a body
constexpr double kWider = 1.5, kDeeper = 1.2;  // there, to the sides and to the front: times the neck
constexpr double kFold_mm = 1.3, kFolds = 9.0;

using ClothRing = std::array<double, kClothSides>;

double cloth_angle(int i) { return 2.0 * M_PI * i / kClothSides; }

/// Each direction no less than about its neighbours: a cloth spans what is hollow.
void span_hollows(ClothRing& ring) {
  for (int pass = 0; pass < 4; ++pass) {
    ClothRing next = ring;
    for (int i = 0; i < kClothSides; ++i)
      next[i] = std::max(ring[i], 0.5 * (ring[(i + 1) % kClothSides] + ring[(i + kClothSides - 1) % kClothSides]));
    ring = next;
  }
}

}  // namespace

vtkSmartPointer<vtkActor> drape(const PatientLook& look) {
  const auto& landmarks = look.package.landmarks;
  const auto carina = landmarks.find("carina");
  const auto face = look.package.surfaces.find("face");
  if (carina == landmarks.end() || face == look.package.surfaces.end()) return nullptr;
  const double hem_z = 0.5 * (look.framing.glottis[2] + carina->second[2]), x = look.framing.midline_x_mm;
  double front = 1e30, back = -1e30;
  for (const auto& p : face->second.points) {
    if (std::abs(p[2] - hem_z) > kStep_mm) continue;
    front = std::min(front, p[1]);
    back = std::max(back, p[1]);
  }
  if (!(front < back)) return nullptr;
  const double y = 0.5 * (front + back);
  std::array<ClothRing, kClothRings> rings{};
  for (const auto& p : face->second.points) {
    const int row = static_cast<int>(std::lround((hem_z - p[2]) / kStep_mm));
    if (row < 0) continue;
    const double turn = std::atan2(p[1] - y, p[0] - x) / (2.0 * M_PI);
    const int i = static_cast<int>(std::lround((turn + 1.0) * kClothSides)) % kClothSides;
    double& reach = rings[static_cast<std::size_t>(std::min(row, kClothRings - 1))][static_cast<std::size_t>(i)];
    reach = std::max(reach, std::hypot(p[0] - x, p[1] - y));
  }
  for (ClothRing& ring : rings) span_hollows(ring);
  for (int row = 1; row < kClothRings; ++row)  // it hangs: nowhere narrower than above
    for (int i = 0; i < kClothSides; ++i) rings[row][i] = std::max(rings[row][i], rings[row - 1][i]);
  const ClothRing neck = rings.front();
  const double wide = kWider * std::max(neck[0], neck[kClothSides / 2]), deep = kDeeper * 0.5 * (back - front);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  for (int row = 0; row < kClothRings; ++row) {
    const double down = std::min(1.0, row * kStep_mm / kShoulders_mm), eased = down * down * (3.0 - 2.0 * down);
    for (int i = 0; i < kClothSides; ++i) {
      const double body = 1.0 / std::hypot(std::cos(cloth_angle(i)) / wide, std::sin(cloth_angle(i)) / deep);
      const double fold = eased * kFold_mm * std::sin(kFolds * cloth_angle(i) + 0.25 * row);
      const double reach =
          kOverSkin_mm + fold + std::max(rings[row][i], neck[i] + eased * std::max(0.0, body - neck[i]));
      points->InsertNextPoint(x + reach * std::cos(cloth_angle(i)), y + reach * std::sin(cloth_angle(i)),
                              hem_z - row * kStep_mm);
      if (row == 0) continue;
      const vtkIdType next = (i + 1) % kClothSides, above = (row - 1) * kClothSides, here = row * kClothSides;
      const vtkIdType quad[4] = {above + i, above + next, here + next, here + i};
      quads->InsertNextCell(4, quad);
    }
  }
  vtkNew<vtkPolyData> cloth;
  cloth->SetPoints(points);
  cloth->SetPolys(quads);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(cloth);
  normals->SplittingOff();
  normals->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(normals->GetOutput());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.58, 0.66, 0.70);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.65);
  return actor;
}

}  // namespace vallecula::gui

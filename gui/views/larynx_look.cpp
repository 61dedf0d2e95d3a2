#include "gui/views/larynx_look.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "gui/session/poly_data.h"
#include "gui/views/tissue_colours.h"
#include "gui/views/tissue_shading.h"

namespace vallecula::gui {
namespace {

using engine::Vec3;

/// A cord's section from below its free edge to the wall: share of the way from edge to wall, height over the edge (mm
/// in a larynx of term size). For the eye.
constexpr std::array<std::array<double, 2>, 7> kSection{
    {{0.35, -1.5}, {0.08, -0.55}, {0.0, 0.0}, {0.10, 0.30}, {0.45, 0.55}, {0.80, 0.45}, {1.0, 0.30}}};
constexpr int kColumns = static_cast<int>(kSection.size());
constexpr double kTermLength = 0.007;  // m, of the cords
constexpr double kAbove = 0.0012;     // m: in front of the mucosa as it was imaged, whose slit is that of cords at rest
constexpr double kIntoWall = 0.0014;  // m that the drawing goes on behind the mucosa, in a larynx of that size
constexpr double kTouching = 0.00015;  // m of air that is drawn between cord and tube, or the two would flicker

int point_of(int side, int row, int column) { return (side * CordsLook::kRows + row) * kColumns + column; }

const engine::AirwayRing& cords_of(const engine::AirwayCourse& course) {
  const auto found = std::find_if(course.airway.begin(), course.airway.end(),
                                  [](const auto& ring) { return ring.part == engine::AirwayPart::cords; });
  if (found == course.airway.end())
    throw std::runtime_error("the airway has no cut at the cords: import the patient again");
  return *found;
}

/// Taut around what stands out: the least concave line that is nowhere below `edge`.
void draw_taut(std::array<std::array<double, 2>, CordsLook::kRows>& edges, int side) {
  auto taut = edges;
  for (int row = 1; row + 1 < CordsLook::kRows; ++row)
    for (int a = 0; a < row; ++a)
      for (int b = row + 1; b < CordsLook::kRows; ++b)
        taut[row][side] = std::max(taut[row][side], edges[a][side] + (edges[b][side] - edges[a][side]) * (row - a) /
                                                                         static_cast<double>(b - a));
  edges = taut;
}

/// Where the axis goes through the cut, nearest to its middle; false where it does not.
bool crossing(const engine::Snapshot& snapshot, const Vec3& centre, const Vec3& along, Vec3& at) {
  double nearest = std::numeric_limits<double>::max();
  for (int i = 0; i + 1 < engine::kTubeNodes; ++i) {
    const double a = (snapshot.tube_axis[i] - centre).dot(along), b = (snapshot.tube_axis[i + 1] - centre).dot(along);
    if ((a > 0.0) == (b > 0.0)) continue;
    const Vec3 p = snapshot.tube_axis[i] + a / (a - b) * (snapshot.tube_axis[i + 1] - snapshot.tube_axis[i]);
    if ((p - centre).norm() >= nearest) continue;
    nearest = (p - centre).norm();
    at = p;
  }
  return nearest < 0.02;  // one that goes by far beside the larynx crosses its plane too
}

}  // namespace

Vec3 shift_of(const engine::AirwayCourse& course, const engine::AirwayRing& ring, const engine::Snapshot& snapshot) {
  const auto body = static_cast<std::size_t>(std::max(0, course.larynx_body));
  if (course.larynx_body < 0 || body >= snapshot.body_displacement.size()) return Vec3::Zero();
  return ring.larynx_share * snapshot.body_displacement[body];
}

CordsLook::CordsLook(const engine::IntubationDescription& intubation)
    : course_(intubation.course),
      ring_(cords_of(intubation.course)),
      glottis_(intubation.glottis),
      tube_radius_(0.5 * intubation.tube.outer_diameter),
      catheter_radius_(0.5 * intubation.catheter_outer_m) {
  std::vector<std::array<double, 3>> points(2 * kRows * kColumns);
  std::vector<std::array<int, 3>> triangles;
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetName("Colours");
  rgb->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> wet, normals;
  wet->SetName(kWetness);
  wet->SetNumberOfComponents(2);
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  normals->Fill(0.0);
  const Colour mucosa = tissue_colour(pipeline::Tissue::larynx);
  for (int side = 0; side < 2; ++side)
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        // White at the ligament, pinker towards the wall and where the arytenoids' mucosa goes on behind it.
        const double behind = std::clamp((row / (kRows - 1.0) - 0.55) / 0.3, 0.0, 1.0);
        const double pale = std::max(0.0, 1.0 - 1.1 * kSection[column][0]) * (1.0 - 0.6 * behind);
        for (int c = 0; c < 3; ++c)
          rgb->InsertNextValue(
              static_cast<unsigned char>(255.0 * (mucosa[c] + pale * (kCordColour[c] - mucosa[c]))));
        wet->InsertNextTuple2(0.8, 0.85);  // deep in the throat
        if (row == 0 || column == 0) continue;
        const int a = point_of(side, row - 1, column - 1), b = point_of(side, row - 1, column),
                  c = point_of(side, row, column - 1), d = point_of(side, row, column);
        // Rows go back, columns out to the left or right: seen from the mouth both sides turn the same way round.
        if (side == 0)
          triangles.insert(triangles.end(), {{a, b, c}, {b, d, c}});
        else
          triangles.insert(triangles.end(), {{a, c, b}, {b, c, d}});
      }
  surface_ = poly_data(points, triangles);
  surface_->GetPointData()->SetScalars(rgb);
  surface_->GetPointData()->AddArray(wet);
  surface_->GetPointData()->SetNormals(normals);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface_);
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDirectScalars();
  actor_ = vtkSmartPointer<vtkActor>::New();
  actor_->SetMapper(mapper);
  actor_->VisibilityOff();
  shade_as_tissue(actor_, mapper);
}

void CordsLook::update(const engine::Snapshot& snapshot) {
  actor_->SetVisibility(snapshot.has_intubation);
  if (!snapshot.has_intubation) return;
  const Vec3 left = ring_.left, front = ring_.along.cross(ring_.left), up = -ring_.along;
  const double size = glottis_.length_m / kTermLength;
  const Vec3 commissure =
      ring_.centre + shift_of(course_, ring_, snapshot) + ring_.to_front_m * front + kAbove * size * up;
  const auto behind = [&](int row) { return glottis_.length_m * row / (kRows - 1); };
  Vec3 tube = Vec3::Zero();
  const bool between = crossing(snapshot, commissure - ring_.to_front_m * front, ring_.along, tube);
  const double radius =
      (snapshot.intubation.in_hand == engine::InHand::catheter ? catheter_radius_ : tube_radius_) + kTouching;
  for (int row = 0; row < kRows; ++row) {
    const double d = behind(row), free = half_width(glottis_, snapshot.intubation.glottis_opening, d);
    edges_[row] = {free, free};
    if (!between) continue;
    const double along = d + (tube - commissure).dot(front), across = (tube - commissure).dot(left);
    if (std::abs(along) >= radius) continue;
    const double half = std::sqrt(radius * radius - along * along);
    edges_[row] = {std::max(free, half + across), std::max(free, half - across)};
  }
  if (between)
    for (int side = 0; side < 2; ++side) draw_taut(edges_, side);
  auto* points = surface_->GetPoints();
  for (int side = 0; side < 2; ++side)
    for (int row = 0; row < kRows; ++row) {
      const double d = behind(row), edge = edges_[row][side],
                   wall = std::max(half_width(glottis_, 1.0, std::max(d, 0.15 * glottis_.length_m)), edge) +
                          kIntoWall * size;
      for (int column = 0; column < kColumns; ++column) {
        const double out = edge + kSection[column][0] * (wall - edge),
                     flat = 0.3 + 0.7 * std::min(1.0, d / (0.3 * glottis_.length_m));
        const Vec3 p = 1000.0 * (commissure - d * front + (side == 0 ? out : -out) * left) +
                       size * flat * kSection[column][1] * up;
        points->SetPoint(point_of(side, row, column), p.data());
      }
    }
  auto* normals = vtkFloatArray::SafeDownCast(surface_->GetPointData()->GetNormals());
  const auto at = [&](int side, int row, int column) {
    return Vec3(points->GetPoint(point_of(side, std::clamp(row, 0, kRows - 1), std::clamp(column, 0, kColumns - 1))));
  };
  for (int side = 0; side < 2; ++side)
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        const Vec3 back = at(side, row + 1, column) - at(side, row - 1, column),
                   out = at(side, row, column + 1) - at(side, row, column - 1);
        const Vec3 normal = (side == 0 ? 1.0 : -1.0) * out.cross(back).normalized();
        normals->SetTuple(point_of(side, row, column), normal.data());
      }
  points->Modified();
  normals->Modified();
  surface_->Modified();
}

namespace {

// Fluid with some froth, whose surface trembles in the lamp's light; nearly opaque: mucus and saliva hide what they
// cover.
const char* const kFluidPixel = R"(
  vec2 at = vertexMCVSOutput.xz;
  vec2 wave = 0.22 * vec2(sin(0.9 * at.x + 0.7 * at.y) + 0.5 * sin(2.1 * at.y), cos(0.8 * at.x - 1.1 * at.y));
  vec3 n = normalize(normalVCVSOutput + vec3(wave, 0.0));
  vec3 eye = normalize(-vertexVC.xyz);
  float rim = pow(1.0 - clamp(dot(n, eye), 0.0, 1.0), 3.0);
  float gloss = pow(max(dot(n, normalize(eye + vec3(0.0, 0.5, 0.9))), 0.0), 40.0)
              + 0.6 * pow(max(dot(n, normalize(eye + vec3(-0.6, 0.6, 0.5))), 0.0), 60.0);
  float froth = 0.0;
  for (int layer = 0; layer < 2; ++layer) {
    vec2 grid = (0.75 + 0.55 * float(layer)) * at + 7.3 * float(layer), cell = floor(grid);
    vec3 chance = fract(sin(vec3(dot(cell, vec2(12.99, 78.23)), dot(cell, vec2(39.35, 11.14)), dot(cell, vec2(73.16, 52.24)))) * 43758.5);
    float size = 0.10 + 0.22 * chance.z, far = length(grid - cell - 0.35 - 0.3 * chance.xy);
    float bubble = smoothstep(size, size - 0.05, far) * (0.35 + 0.65 * smoothstep(size - 0.10, size - 0.02, far));
    froth = max(froth, bubble * step(0.62, chance.x));
  }
  vec3 fluid = mix(vec3(0.74, 0.62, 0.57), vec3(0.95, 0.94, 0.91), 0.7 * froth + 0.5 * rim);
  fragOutput0 = vec4(fluid + vec3(0.8 * gloss), clamp(0.78 + 0.17 * froth + rim + gloss, 0.0, 0.97));
)";

}  // namespace

SecretionsLook::SecretionsLook(const engine::Secretions& secretions) : secretions_(secretions) {
  // A round pool of the area that it spreads over: the walls about it hide what is too much of it.
  constexpr int kCorners = 48;
  const double radius = 1000.0 * std::sqrt(secretions.area_m2 / M_PI);
  const Vec3 up = secretions.up.normalized(),
             right = up.cross(Vec3::UnitZ()).norm() > 0.1 ? up.cross(Vec3::UnitZ()).normalized() : Vec3::UnitX();
  std::vector<Vec3> points{Vec3::Zero()};
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * M_PI * k / kCorners;
    points.push_back(radius * (std::cos(angle) * right + std::sin(angle) * up.cross(right)));
    triangles.push_back({0, 1 + k, 1 + (k + 1) % kCorners});
  }
  const auto surface = poly_data(points, triangles);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < points.size(); ++i) normals->InsertNextTuple(up.data());
  surface->GetPointData()->SetNormals(normals);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  actor_ = vtkSmartPointer<vtkActor>::New();
  actor_->SetMapper(mapper);
  actor_->VisibilityOff();
  actor_->ForceTranslucentOn();
  auto* shader = actor_->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n  out vec4 vertexMCVSOutput;\n",
                                     false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true,
                                     "//VTK::Normal::Impl\n  vertexMCVSOutput = vertexMC;\n", false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, "//VTK::Normal::Dec\n  in vec4 vertexMCVSOutput;\n",
                                       false);
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kFluidPixel, false);
}

void SecretionsLook::update(const engine::Snapshot& snapshot) {
  const double volume = snapshot.has_intubation ? 1e-6 * snapshot.intubation.secretions_ml : 0.0;
  actor_->SetVisibility(volume > 1e-9);
  const Vec3 level = 1000.0 * (secretions_.floor + volume / secretions_.area_m2 * secretions_.up);
  actor_->SetPosition(level.x(), level.y(), level.z());
}

}  // namespace vallecula::gui

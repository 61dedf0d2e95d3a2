#include "gui/views/patient_look.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkLoopSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkPolyDataNormals.h>
#include <vtkReverseSense.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gui/session/poly_data.h"
#include "gui/views/drawn_triangles.h"
#include "gui/views/fine_tongue.h"
#include "gui/views/openness.h"
#include "gui/views/tissue_colours.h"
#include "gui/views/tissue_shading.h"
#include "pipeline/package/label_map.h"

namespace vallecula::gui {
namespace {

using pipeline::Point;
using pipeline::Surface;
using pipeline::Tissue;

constexpr double kEyeMovesMm = 40.0;  // of an operator who leans to a side
constexpr int kFaceTriangles = 18000;  // of the whole head: a quarter of the built-in infant's of 3.2 kg, which moves no point by more than 0.12 mm
constexpr double kWidestView = 6.0;  // as a share of the framed face: a view under the monitor is four times as wide as high

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point mix(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point& a) { return std::sqrt(dot(a, a)); }
double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

const Point& landmark(const pipeline::PatientPackage& package, const char* name) {
  const auto found = package.landmarks.find(name);
  if (found == package.landmarks.end())
    throw std::runtime_error("patient package " + package.name + " has no landmark '" + name + "': import it again");
  return found->second;
}

const Surface* surface(const pipeline::PatientPackage& package, const char* name) {
  const auto found = package.surfaces.find(name);
  return found == package.surfaces.end() || found->second.triangles.empty() ? nullptr : &found->second;
}

double distance_to_outline(const Point& p, const std::vector<Point>& outline) {
  double nearest = 1e30;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point ab = minus(outline[(i + 1) % outline.size()], a), ap = minus(p, a);
    const double t = std::clamp(dot(ap, ab) / std::max(dot(ab, ab), 1e-9), 0.0, 1.0);
    nearest = std::min(nearest, length(minus(ap, {t * ab[0], t * ab[1], t * ab[2]})));
  }
  return nearest;
}

std::vector<std::vector<int>> neighbours_of(const Surface& face) {
  std::vector<std::vector<int>> neighbours(face.points.size());
  for (const auto& t : face.triangles)
    for (int c = 0; c < 3; ++c) neighbours[t[c]].push_back(t[(c + 1) % 3]);
  return neighbours;  // on a closed surface every edge is walked once each way: each neighbour once
}

// One value of N numbers per point from one per triangle: the mean of the triangles that meet there.
template <std::size_t N, class OfTissue>
std::vector<std::array<double, N>> to_points(const Surface& face, OfTissue of_tissue) {
  std::vector<std::array<double, N>> values(face.points.size());
  std::vector<double> count(face.points.size(), 0.0);
  for (std::size_t i = 0; i < face.triangles.size(); ++i) {
    const std::array<double, N> value =
        of_tissue(i < face.tissue.size() ? static_cast<Tissue>(face.tissue[i]) : Tissue::skin);
    for (int corner : face.triangles[i]) {
      for (std::size_t c = 0; c < N; ++c) values[corner][c] += value[c];
      count[corner] += 1.0;
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    for (double& c : values[i]) c /= std::max(count[i], 1.0);
  return values;
}

// Lets what lies side by side run into each other, as lip does into skin; each pass reaches half an edge further.
template <std::size_t N>
void blend(std::vector<std::array<double, N>>& values, const std::vector<std::vector<int>>& neighbours, int passes) {
  auto next = values;
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (neighbours[i].empty()) continue;
      std::array<double, N> sum{};
      for (int n : neighbours[i])
        for (std::size_t c = 0; c < N; ++c) sum[c] += values[n][c];
      for (std::size_t c = 0; c < N; ++c)
        next[i][c] = 0.5 * values[i][c] + 0.5 * sum[c] / static_cast<double>(neighbours[i].size());
    }
    values.swap(next);
  }
}

/// An empty array of kWetness for that many points.
vtkSmartPointer<vtkFloatArray> wetness_array(vtkIdType points) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(kWetness);
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(points);
  return array;
}

Framing framing_of(const pipeline::PatientPackage& package) {
  Framing framing;
  framing.eye = landmark(package, "operator_eye");
  framing.glottis = landmark(package, "glottis_centre");
  const Point upper = landmark(package, "upper_gum_midline"), lower = landmark(package, "lower_gum_midline");
  framing.mouth = mix(upper, lower, 0.5);
  framing.midline_x_mm = (upper[0] + lower[0] + framing.glottis[0]) / 3.0;
  // The lips say how big the mouth is; without them (a closed mouth, no lip found) the way to the glottis does.
  double width = 0.55 * length(minus(framing.glottis, upper));
  if (const Surface* face = surface(package, "face")) {
    double low = 1e30, high = -1e30;
    for (std::size_t i = 0; i < face->triangles.size() && i < face->tissue.size(); ++i)
      if (static_cast<Tissue>(face->tissue[i]) == Tissue::lip)
        for (int corner : face->triangles[i]) {
          low = std::min(low, face->points[corner][0]);
          high = std::max(high, face->points[corner][0]);
        }
    if (high > low) width = std::clamp(high - low, 0.7 * width, 1.6 * width);
  }
  framing.face_mm = 2.9 * width;
  framing.mouth_mm = 0.8 * width;
  framing.inside = mix(framing.mouth, framing.glottis, 0.3);
  return framing;
}

// The operator's eye moves by a head's sway at most: triangles that face away from all of its places or lie far outside
// its view are never drawn.
void keep_what_the_eye_can_see(vtkPolyData* face, const Framing& framing) {
  const Point axis = minus(framing.mouth, framing.eye);
  const double widest = std::cos(std::atan(kWidestView * 0.5 * framing.face_mm / length(axis)));
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < face->GetNumberOfCells(); ++i) {
    face->GetCellPoints(i, ids);
    Point a, b, c;
    face->GetPoint(ids->GetId(0), a.data());
    face->GetPoint(ids->GetId(1), b.data());
    face->GetPoint(ids->GetId(2), c.data());
    const Point ab = minus(b, a), ac = minus(c, a), look = minus(a, framing.eye);
    const Point normal{ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]};
    if (dot(normal, look) < kEyeMovesMm * length(normal) && dot(look, axis) > widest * length(look) * length(axis))
      kept->InsertNextCell(ids);
  }
  face->SetPolys(kept);
}

// Of the same points, so that it moves with the face: the triangles whose first corner `keep` is true of. Without a
// graphics card a view costs by its triangles, whether they come to lie in the picture or not.
template <class Keep>
vtkSmartPointer<vtkPolyData> part_of(vtkPolyData* face, Keep keep) {
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < face->GetNumberOfCells(); ++i) {
    face->GetCellPoints(i, ids);
    Point p;
    face->GetPoint(ids->GetId(0), p.data());
    if (keep(p)) kept->InsertNextCell(ids);
  }
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->ShallowCopy(face);
  part->SetPolys(kept);
  return part;
}

// What lies about the way from the lips to the glottis.
vtkSmartPointer<vtkPolyData> near_the_mouth(vtkPolyData* face, const Framing& framing) {
  const Point way = minus(framing.glottis, framing.mouth);
  return part_of(face, [&](const Point& p) {
    const Point from = minus(p, framing.mouth);
    const double t = std::clamp(dot(from, way) / dot(way, way), -0.3, 1.3);
    return length(minus(from, {t * way[0], t * way[1], t * way[2]})) < 0.35 * framing.face_mm;
  });
}

// What lies in a cone three times as wide as the framed mouth is high, about the way to what is in it.
vtkSmartPointer<vtkPolyData> in_the_close_view(vtkPolyData* face, const Framing& framing) {
  const Point axis = minus(framing.inside, framing.eye);
  const double widest = std::cos(std::atan(1.5 * framing.mouth_mm / length(axis)));
  return part_of(face, [&](const Point& p) {
    const Point look = minus(p, framing.eye);
    return dot(look, axis) > widest * length(look) * length(axis);
  });
}

// A bump map of one value a point: the normal leans away from where the grain rises.
void tilt_normal(float* normal, const std::array<double, 3>& slope, double amount) {
  const double along = slope[0] * normal[0] + slope[1] * normal[1] + slope[2] * normal[2];
  double size = 0.0;
  for (int c = 0; c < 3; ++c) {
    normal[c] -= static_cast<float>(amount * (slope[c] - along * normal[c]));
    size += normal[c] * normal[c];
  }
  for (int c = 0; c < 3; ++c) normal[c] /= static_cast<float>(std::sqrt(std::max(size, 1e-12)));
}

vtkSmartPointer<vtkPolyData> make_face(const pipeline::PatientPackage& package, const Openness& openness) {
  const Surface& face = *surface(package, "face");
  const auto neighbours = neighbours_of(face);
  auto colours = to_points<3>(face, tissue_colour);
  auto wet = to_points<1>(face, [](Tissue tissue) { return std::array<double, 1>{tissue_wetness(tissue)}; });
  blend(colours, neighbours, 14);
  blend(wet, neighbours, 8);
  const Point glottis = landmark(package, "glottis_centre");
  const Surface* opening = surface(package, "glottis");

  vtkNew<vtkPolyDataNormals> with_normals;
  with_normals->SetInputData(to_poly_data(face));
  with_normals->SplittingOff();
  with_normals->ConsistencyOff();
  with_normals->Update();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(with_normals->GetOutput());
  auto* normals = vtkFloatArray::SafeDownCast(result->GetPointData()->GetNormals());

  auto rgb = vtkSmartPointer<vtkUnsignedCharArray>::New();
  rgb->SetName("Colours");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(static_cast<vtkIdType>(face.points.size()));
  std::vector<std::array<double, 1>> open(face.points.size());
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const float* n = normals->GetPointer(3 * static_cast<vtkIdType>(i));
    open[i] = {openness.at(face.points[i], {n[0], n[1], n[2]})};
  }
  blend(open, neighbours, 4);  // the grid's own steps
  const auto wetness = wetness_array(static_cast<vtkIdType>(face.points.size()));
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    const Point& p = face.points[i];
    Colour colour = mottled(colours[i], p, 0.07 + 0.07 * wet[i][0]);
    const Point from_glottis = minus(p, glottis);
    if (opening != nullptr && length(from_glottis) < 14.0) {
      const double cord = 1.0 - smooth_step(0.7, 2.2, distance_to_outline(p, opening->points));
      for (int c = 0; c < 3; ++c) colour[c] += cord * (kCordColour[c] - colour[c]);
    }
    for (int c = 0; c < 3; ++c) rgb->SetComponent(id, c, 255.0 * colour[c]);
    wetness->SetTuple2(id, wet[i][0], 0.30 + 0.70 * std::min(1.0, 1.25 * open[i][0]));
    tilt_normal(normals->GetPointer(3 * id), grain_slope(p, 1.3 + 0.9 * wet[i][0]), 0.015 + 0.07 * wet[i][0]);
  }
  result->GetPointData()->SetScalars(rgb);
  result->GetPointData()->AddArray(wetness);
  return result;
}

// Pale mucosa over whitish cartilage: open rings, about as many as a trachea has, that stand out a little at the front
// and the sides; none on the soft back wall, none in the first millimetres, where the cricoid is.
void colour_trachea(vtkPolyData* trachea, const Point& glottis, const Point& cranial, double to_carina_mm) {
  constexpr double kRings = 16.0, kSubglottis = 0.10, kRingStandsOut = 0.35;
  const vtkIdType count = trachea->GetNumberOfPoints();
  const auto colours = [&](const char* name) {
    auto rgb = vtkSmartPointer<vtkUnsignedCharArray>::New();
    rgb->SetName(name);
    rgb->SetNumberOfComponents(3);
    rgb->SetNumberOfTuples(count);
    trachea->GetPointData()->AddArray(rgb);
    return rgb;
  };
  const auto natural = colours(kTracheaNatural), blue = colours(kTracheaBlue);
  const auto wetness = wetness_array(count);
  auto* direction = vtkFloatArray::SafeDownCast(trachea->GetPointData()->GetNormals());
  for (vtkIdType i = 0; i < count; ++i) {
    double p[3];
    trachea->GetPoint(i, p);
    float* n = direction->GetPointer(3 * i);
    // A hair inside the wall it coincides with.
    trachea->GetPoints()->SetPoint(i, p[0] + 0.15 * n[0], p[1] + 0.15 * n[1], p[2] + 0.15 * n[2]);
    const double depth = -dot(minus({p[0], p[1], p[2]}, glottis), cranial) / to_carina_mm;
    const double phase = 2.0 * 3.14159265 * kRings * (depth - kSubglottis);
    const double front = smooth_step(-0.75, -0.35, n[1]);  // the wall's inner side faces the front where it is the back
    const double ringed = (1.0 - front) * smooth_step(kSubglottis, kSubglottis + 0.03, depth);
    const double ring = smooth_step(-0.3, 0.5, -std::cos(phase)) * ringed;
    const Colour wall = mottled(kTracheaColour, {p[0], p[1], p[2]}, 0.10);
    for (int c = 0; c < 3; ++c) {
      natural->SetComponent(i, c, 255.0 * std::clamp(wall[c] + 0.75 * ring * (kCartilageColour[c] - wall[c]), 0.0, 1.0));
      blue->SetComponent(i, c, 255.0 * std::clamp(kAirwayBlue[c] + 0.06 * std::sin(phase), 0.0, 1.0));
    }
    wetness->SetTuple2(i, 0.8, 1.0 - 0.55 * std::clamp(depth, 0.0, 1.0));
    tilt_normal(n, {cranial[0], cranial[1], cranial[2]}, kRingStandsOut * ringed * std::sin(phase));
  }
  trachea->GetPointData()->AddArray(wetness);
}

vtkSmartPointer<vtkPolyData> make_trachea(const pipeline::PatientPackage& package) {
  auto result = vtkSmartPointer<vtkPolyData>::New();
  const Surface* airway = surface(package, "airway");
  if (airway == nullptr) return result;
  const Point glottis = landmark(package, "glottis_centre"), cranial = landmark(package, "glottis_normal"),
              carina = landmark(package, "carina");
  vtkNew<vtkPlane> below;
  below->SetOrigin(glottis[0] - 0.4 * cranial[0], glottis[1] - 0.4 * cranial[1], glottis[2] - 0.4 * cranial[2]);
  below->SetNormal(cranial[0], cranial[1], cranial[2]);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(to_poly_data(*airway));
  clip->SetClipFunction(below);
  clip->InsideOutOn();
  vtkNew<vtkPolyDataConnectivityFilter> part;  // the plane also cuts the food way's pouches: those are not trachea
  part->SetInputConnection(clip->GetOutputPort());
  part->SetExtractionModeToClosestPointRegion();
  part->SetClosestPoint(carina.data());
  part->Update();
  if (part->GetOutput()->GetNumberOfCells() == 0) return result;
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(part->GetOutputPort());
  clean->SetTolerance(0.002);  // slivers that the plane left
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(clean->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  vtkNew<vtkLoopSubdivisionFilter> round;  // its rim is looked at from near
  round->SetInputConnection(triangles->GetOutputPort());
  round->SetNumberOfSubdivisions(1);
  vtkNew<vtkReverseSense> inside_out;  // it is looked into from above
  inside_out->SetInputConnection(round->GetOutputPort());
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(inside_out->GetOutputPort());
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  result->DeepCopy(normals->GetOutput());
  if (result->GetNumberOfPoints() == 0) return result;

  colour_trachea(result, glottis, cranial, std::max(1.0, -dot(minus(carina, glottis), cranial)));
  return result;
}

std::optional<Surface> fine_tongue(const pipeline::PatientPackage& package, const std::filesystem::path& folder) {
  if (folder.empty()) return std::nullopt;
  try {
    return segmented_tongue(package, pipeline::read_label_map(folder / "labels.nrrd"));
  } catch (const pipeline::LabelMapError&) {  // a trial needs the tetrahedra alone
    return std::nullopt;
  }
}

}  // namespace

vtkSmartPointer<vtkPolyData> to_poly_data(const Surface& surface) {
  return poly_data(surface.points, surface.triangles);
}

void PatientLook::update(const engine::Snapshot& snapshot) {
  if (snapshot.soft_points == shown_soft_ && snapshot.body_displacement == shown_bodies_ &&
      snapshot.lip_displacement == shown_lips_)
    return;
  shown_soft_ = snapshot.soft_points;
  shown_bodies_ = snapshot.body_displacement;
  shown_lips_ = snapshot.lip_displacement;
  soft->update(snapshot.soft_points);
  for (MovingSurface& surface : moving) surface.update(snapshot);
}

std::shared_ptr<PatientLook> make_patient_look(pipeline::PatientPackage package,
                                               const std::function<void(const std::string&, double)>& progress,
                                               Seen seen, const std::filesystem::path& folder) {
  const auto report = [&](const std::string& stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  if (surface(package, "face") == nullptr)
    throw std::runtime_error("patient package " + package.name + " has no face surface to draw: import it again");
  if (package.tongue.tets.empty())
    throw std::runtime_error("patient package " + package.name + " has no tongue mesh to draw: import it again");
  report("surfaces", 0.0);
  auto look = std::make_shared<PatientLook>();
  look->framing = framing_of(package);
  if (const auto fine = fine_tongue(package, folder))
    look->soft = std::make_unique<SoftSurface>(package.tongue, *fine);
  else
    look->soft = std::make_unique<SoftSurface>(package.tongue, package.tongue.tets.size() > 12000 ? 1 : 2);
  report("light and shade", 0.3);
  const auto face = to_poly_data(*surface(package, "face"));
  const auto soft = look->soft->boundary();
  const Openness openness({face, soft}, 0.33 * look->framing.face_mm);
  look->face = with_fewer_triangles_and_its_arrays(make_face(package, openness), kFaceTriangles);
  look->around_mouth = near_the_mouth(look->face, look->framing);
  if (seen == Seen::from_the_eye) keep_what_the_eye_can_see(look->face, look->framing);
  look->seen_close = in_the_close_view(look->face, look->framing);
  look->soft->shade(openness);
  report("airway", 0.9);
  look->trachea = make_trachea(package);
  look->motion = std::make_unique<AnatomyMotion>(package);
  look->moving = {{look->face, *look->motion, MovingSurface::Kind::solid},
                  {look->trachea, *look->motion, MovingSurface::Kind::solid}};
  look->package = std::move(package);
  report("ready", 1.0);
  return look;
}

}  // namespace vallecula::gui

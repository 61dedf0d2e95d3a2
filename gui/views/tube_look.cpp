#include "gui/views/tube_look.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkUniforms.h>

#include <QFont>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace vallecula::gui {
namespace {

using engine::Vec3;

constexpr int kAround = 20;
constexpr double kRing = 0.0015;  // m between the rings of triangles
constexpr int kBevelRings = 8;
constexpr double kPrintPerM = 14e3;   // pixels
constexpr double kStandsOut = 0.018;  // m that the stylet stands out of the connector (assumed)

/// The wall as rings that begin at the bevel: its first ring is the opening's rim.
SweptSurface tube_wall(const engine::TubeDesign& tube) {
  const double r = 0.5 * tube.outer_diameter, slope = 1.0 / std::tan(tube.bevel_rad);
  const Vec3 faces = tube.bevel_faces.normalized();
  const double bevel_ends = 2.0 * r * slope + kRing;
  const int straight = static_cast<int>(std::ceil((tube.length - bevel_ends) / kRing)), rings = kBevelRings + straight;
  std::vector<SweptSurface::Point> points;
  std::vector<std::array<int, 3>> triangles;
  for (int ring = 0; ring <= rings; ++ring)
    for (int k = 0; k <= kAround; ++k) {  // the first column again at the end: the print's other edge
      const double angle = 2.0 * M_PI * k / kAround;
      const Vec3 out(0.0, std::cos(angle), std::sin(angle));
      const double begins = r * (1.0 + out.dot(faces)) * slope;
      const double along = ring < kBevelRings
                               ? begins + (bevel_ends - begins) * ring / kBevelRings
                               : bevel_ends + (tube.length - bevel_ends) * (ring - kBevelRings) / straight;
      points.push_back(
          {along, r * out, out, {static_cast<float>(along / tube.length), static_cast<float>(1.0 * k / kAround)}});
      if (ring == 0 || k == kAround) continue;
      const int a = ring * (kAround + 1) + k, before = a - (kAround + 1);
      triangles.push_back({before, before + 1, a});
      triangles.push_back({before + 1, a + 1, a});
    }
  return SweptSurface(std::move(points), triangles);
}

/// The cut face of the wall at the bevel, seen from both sides.
SweptSurface bevel_face(const engine::TubeDesign& tube) {
  const double outer = 0.5 * tube.outer_diameter, inner = 0.5 * tube.inner_diameter,
               slope = 1.0 / std::tan(tube.bevel_rad);
  const Vec3 faces = tube.bevel_faces.normalized();
  const Vec3 normal = (slope * faces - Vec3::UnitX()).normalized();
  std::vector<SweptSurface::Point> points;
  std::vector<std::array<int, 3>> triangles;
  for (int k = 0; k < kAround; ++k) {
    const double angle = 2.0 * M_PI * k / kAround;
    const Vec3 out(0.0, std::cos(angle), std::sin(angle));
    for (const double radius : {outer, inner})
      points.push_back({(outer + radius * out.dot(faces)) * slope, radius * out, normal, {}});
    const int a = 2 * k, b = 2 * ((k + 1) % kAround);
    triangles.push_back({a, a + 1, b});
    triangles.push_back({b, a + 1, b + 1});
  }
  return SweptSurface(std::move(points), triangles);
}

vtkSmartPointer<vtkTexture> texture_of(const QImage& print) {
  const QImage rgba = print.convertToFormat(QImage::Format_RGBA8888);
  vtkNew<vtkImageData> image;
  image->SetDimensions(rgba.width(), rgba.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < rgba.height(); ++y)
    std::memcpy(image->GetScalarPointer(0, y, 0), rgba.constScanLine(y), 4 * static_cast<std::size_t>(rgba.width()));
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOff();
  return texture;
}

// A wall of clear plastic, darker and denser the longer the way of the eye's ray in it: at the sides of the tube, as
// one sees it, hardly anything is seen through. `hollow` is the inner diameter over the outer.
const char* const kClearDeclarations = R"(//VTK::Normal::Dec
  in vec3 AlongAxis;
  out vec3 alongVC;
)";
const char* const kClearVertex = R"(//VTK::Normal::Impl
  alongVC = normalize(normalMatrix * AlongAxis);
)";
const char* const kClearPixelDeclarations = R"(//VTK::Normal::Dec
  in vec3 alongVC;
)";
const char* const kClearPixel = R"(
  vec3 eye = cameraParallel == 1 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 across = eye - dot(eye, alongVC) * alongVC;
  float facing = clamp(abs(dot(normalVCVSOutput, eye)) / max(length(across), 0.05), 0.0, 1.0);
  float beside = sqrt(max(0.0, 1.0 - facing * facing));                 // 0 in the middle of the tube, 1 at its side
  float wall = (facing - sqrt(max(0.0, hollow * hollow - beside * beside))) / sqrt(1.0 - hollow * hollow);
  float dense = mix(0.30, 0.85, smoothstep(0.30, 1.0, wall));
  vec3 clear = mix(vec3(0.86, 0.92, 0.94), vec3(0.60, 0.69, 0.73), smoothstep(0.70, 1.0, beside));
  vec3 half1 = normalize(eye + vec3(-0.35, 0.60, 0.70)), half2 = normalize(eye + vec3(0.70, 0.25, 0.60));
  float gloss = pow(max(dot(normalVCVSOutput, half1), 0.0), 60.0) + 0.5 * pow(max(dot(normalVCVSOutput, half2), 0.0), 30.0);
  clear *= 0.80 + 0.20 * max(normalVCVSOutput.y, 0.0);
  fragOutput0 = vec4(clear + vec3(0.75 * gloss), clamp(dense + 0.8 * gloss, 0.0, 0.97));
)";
const char* const kPrintPixel = R"(
  vec4 ink = texture(actortexture, tcoordVCVSOutput);
  fragOutput0 = vec4(mix(fragOutput0.rgb, ink.rgb, ink.a), max(fragOutput0.a, ink.a));
)";

void make_clear(vtkActor* actor, double hollow, bool printed) {
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  mapper->MapDataArrayToVertexAttribute(kAlongAxis, kAlongAxis, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  auto* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::Normal::Dec", true, kClearDeclarations, false);
  shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, kClearVertex, false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, kClearPixelDeclarations, false);
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kClearPixel, false);
  if (printed) shader->AddFragmentShaderReplacement("//VTK::TCoord::Impl", true, kPrintPixel, false);
  shader->GetFragmentCustomUniforms()->SetUniformf("hollow", static_cast<float>(hollow));
  actor->ForceTranslucentOn();
  actor->GetProperty()->BackfaceCullingOn();
}

void make_solid(vtkActor* actor, double red, double green, double blue, double gloss) {
  auto* property = actor->GetProperty();
  property->SetColor(red, green, blue);
  property->SetAmbient(0.25);
  property->SetDiffuse(0.75);
  property->SetSpecular(gloss);
  property->SetSpecularPower(30.0);
}

}  // namespace

QImage tube_print(const engine::TubeDesign& tube) {
  const double round = M_PI * tube.outer_diameter;
  QImage print(static_cast<int>(std::lround(kPrintPerM * tube.length)),
               static_cast<int>(std::lround(kPrintPerM * round)), QImage::Format_ARGB32);
  print.fill(QColor(20, 22, 26, 0));
  QPainter painter(&print);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(1e-3 * kPrintPerM, 1e-3 * kPrintPerM);  // mm
  const double round_mm = 1e3 * round, length_mm = 1e3 * tube.length;
  const QColor ink(20, 22, 26), line(40, 90, 190);
  painter.setPen(Qt::NoPen);
  // Columns begin at +y and go on to +z, the concave side, at a quarter: the convex side is at three quarters.
  painter.setBrush(line);
  painter.drawRect(QRectF(0.0, 0.75 * round_mm - 0.25, length_mm, 0.5));
  painter.setBrush(ink);
  const auto ring = [&](double from_mm, double wide_mm) {  // a little beyond both edges, so that they meet
    painter.setPen(Qt::NoPen);
    painter.drawRect(QRectF(from_mm, -1.0, wide_mm, round_mm + 2.0));
  };
  ring(1e3 * (tube.cord_mark_from_tip - tube.cord_mark_width), 1e3 * tube.cord_mark_width);
  QFont font("DejaVu Sans");
  font.setBold(true);
  font.setPixelSize(20);  // scaled below: small sizes are not drawn well
  painter.setFont(font);
  const auto write = [&](double at_mm, double around, const QString& text) {
    painter.save();
    painter.translate(at_mm, around * round_mm);
    painter.scale(0.115, 0.115);
    painter.setPen(ink);
    painter.drawText(QRectF(-60, -20, 120, 40), Qt::AlignCenter, text);
    painter.restore();
  };
  for (int cm = tube.first_cm_mark; 10.0 * cm < length_mm - 4.0; ++cm) {
    ring(10.0 * cm - 0.18, 0.36);
    for (const double around : {0.25, 0.58, 0.92}) write(10.0 * cm + 2.6, around, QString::number(cm));
  }
  const double size_at = 10.0 * tube.first_cm_mark - 4.5;
  for (const double around : {0.25, 0.58, 0.92})
    write(size_at, around, QString::number(1e3 * tube.inner_diameter, 'f', 1));
  return print;
}

TubeLook::TubeLook(const engine::IntubationDescription& intubation) {
  if (intubation.stylet) add_stylet(intubation.tube, *intubation.stylet);
  add_tube(intubation.tube);
  if (intubation.catheter_outer_m > 0.0) add_catheter(intubation.catheter_outer_m);
  for (const bool see_through : {false, true})
    for (const Part& part : parts_)
      if ((part.actor->GetForceTranslucent() != 0) == see_through) actors_.push_back(part.actor);
}

vtkActor* TubeLook::add(SweptSurface surface, bool of_catheter, bool of_stylet) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface.surface());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->VisibilityOff();
  parts_.push_back({std::move(surface), actor, of_catheter, of_stylet});
  return actor;
}

void TubeLook::add_tube(const engine::TubeDesign& tube) {
  const double hollow = tube.inner_diameter / tube.outer_diameter;
  make_solid(add(bevel_face(tube), false, false), 0.82, 0.88, 0.90, 0.3);
  vtkActor* wall = add(tube_wall(tube), false, false);
  wall->SetTexture(texture_of(tube_print(tube)));
  make_clear(wall, hollow, true);
  // A 15 mm connector, its barb in the tube (ISO 5356-1's cone; its length is for the eye).
  const double end = tube.length, barb = 0.5 * tube.outer_diameter + 0.0004;
  make_solid(add(SweptSurface::turned({{end - 0.004, 0.0},
                                       {end - 0.004, barb},
                                       {end, barb + 0.0003},
                                       {end + 0.0005, 0.0085},
                                       {end + 0.0025, 0.0088},
                                       {end + 0.0030, 0.0074},
                                       {end + 0.0160, 0.0077},
                                       {end + 0.0165, 0.0070},
                                       {end + 0.0130, 0.0062}},
                                      40),
                 false, false),
             0.30, 0.55, 0.78, 0.5);
}

void TubeLook::add_stylet(const engine::TubeDesign& tube, const engine::Stylet& stylet) {
  const double r = 0.5 * stylet.diameter, from = stylet.short_of_tip, to = tube.length + kStandsOut;
  std::vector<std::array<double, 2>> rings{{from, 0.0}, {from + 0.3 * r, 0.7 * r}};
  for (double at = from + r; at < to; at += 2.0 * kRing) rings.push_back({at, r});
  rings.push_back({to, r});
  rings.push_back({to + r, 0.0});
  make_solid(add(SweptSurface::turned(rings, 12), false, true), 0.44, 0.47, 0.52, 0.8);
}

void TubeLook::add_catheter(double outer_m) {
  const engine::TubeDesign catheter = engine::suction_catheter(outer_m);
  const double r = 0.5 * outer_m, length = catheter.length;
  std::vector<std::array<double, 2>> rings{{0.0, 0.8 * r}, {0.2 * r, r}};
  for (double at = 2.0 * kRing; at < length; at += kRing) rings.push_back({at, r});
  vtkActor* wall = add(SweptSurface::turned(rings, 16), true, false);
  make_clear(wall, catheter.inner_diameter / catheter.outer_diameter, false);
  make_solid(add(SweptSurface::turned({{length - 0.012, r},
                                       {length - 0.012, 0.0035},
                                       {length, 0.0045},
                                       {length + 0.020, 0.0050},
                                       {length + 0.020, 0.0}},
                                      24),
                 true, false),
             0.20, 0.45, 0.80, 0.4);  // 8 F is blue
}

void TubeLook::update(const engine::Snapshot& snapshot) {
  const bool there = snapshot.has_intubation && snapshot.step >= 0;
  catheter_shown_ = there && snapshot.intubation.in_hand == engine::InHand::catheter;
  if (!there) {
    for (const auto& actor : actors_) actor->VisibilityOff();
    return;
  }
  const SweptAxis axis(snapshot.tube_axis, snapshot.tube_frames);
  for (Part& part : parts_) {
    const bool shown = part.of_catheter == catheter_shown_ &&
                       (!part.of_stylet || snapshot.intubation.in_hand == engine::InHand::tube_with_stylet);
    part.actor->SetVisibility(shown);
    if (shown) part.surface.update(axis);
  }
}

}  // namespace vallecula::gui

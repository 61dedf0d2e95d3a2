#include "gui/lab/tissue_picture.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <QApplication>
#include <QElapsedTimer>

#include "gui/session/poly_data.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;

constexpr double kMm = 1000.0;         // VTK's clipping and picking like numbers near one
constexpr double kSharp = 40.0;        // degrees: edges of a tool stay edges
constexpr double kFar = 400.0;         // mm, camera to centre; the projection is parallel
constexpr int kFirstPictureMs = 5000;  // how long OpenGL may take to come up

vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData* data, double feature_angle) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetFeatureAngle(feature_angle);
  normals->SplittingOn();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data, const QColor& colour, double opacity) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();  // wires on a surface lie in front of it
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

}  // namespace

TissuePicture::TissuePicture(int width, int height) : GlView(nullptr) {
  setAttribute(Qt::WA_DontShowOnScreen);
  setFixedSize(width, height);
  renderer()->SetBackground(1, 1, 1);
  renderer()->SetTwoSidedLighting(true);
}

void TissuePicture::add_surface(const std::vector<Vec3>& points, const Triangles& triangles, const QColor& colour,
                                double opacity) {
  renderer()->AddActor(actor_of(with_normals(poly_data(points, triangles, kMm), 180.0), colour, opacity));
}

void TissuePicture::add_coloured(const std::vector<Vec3>& points, const Triangles& triangles,
                                 const std::vector<QColor>& colours) {
  const auto data = poly_data(points, triangles, kMm);
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  rgb->SetName("colour");
  for (const QColor& c : colours) rgb->InsertNextTuple3(c.red(), c.green(), c.blue());
  data->GetPointData()->SetScalars(rgb);
  const auto actor = actor_of(with_normals(data, 180.0), Qt::white, 1.0);
  actor->GetMapper()->ScalarVisibilityOn();
  actor->GetProperty()->SetAmbient(0.5);
  actor->GetProperty()->SetDiffuse(0.5);
  renderer()->AddActor(actor);
}

void TissuePicture::add_wireframe(const std::vector<Vec3>& points, const Triangles& triangles, const QColor& colour,
                                  double opacity) {
  const auto actor = actor_of(poly_data(points, triangles, kMm), colour, opacity);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(1.2f);
  renderer()->AddActor(actor);
}

void TissuePicture::add_tool(const engine::TriangleMesh& tool, const engine::Pose& pose, const QColor& colour,
                             double opacity) {
  std::vector<Vec3> placed;
  placed.reserve(tool.points.size());
  for (const Vec3& p : tool.points) placed.push_back(pose.to_world(p));
  const auto actor = actor_of(with_normals(poly_data(placed, tool.triangles, kMm), kSharp), colour, opacity);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(30);
  renderer()->AddActor(actor);
}

void TissuePicture::add_balls(const std::vector<Ball>& balls, const QColor& colour) {
  vtkNew<vtkPoints> at;
  vtkNew<vtkFloatArray> size;
  for (const Ball& b : balls) {
    at->InsertNextPoint(kMm * b.centre.x(), kMm * b.centre.y(), kMm * b.centre.z());
    size->InsertNextValue(static_cast<float>(kMm * b.radius));
  }
  vtkNew<vtkPolyData> where;
  where->SetPoints(at);
  where->GetPointData()->SetScalars(size);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.0);
  ball->SetThetaResolution(balls.size() > 3000 ? 10 : 24);
  ball->SetPhiResolution(balls.size() > 3000 ? 8 : 16);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputData(where);
  glyphs->SetSourceConnection(ball->GetOutputPort());
  glyphs->SetScaleModeToScaleByScalar();
  glyphs->Update();
  renderer()->AddActor(actor_of(glyphs->GetOutput(), colour, 1.0));
}

void TissuePicture::look(const Vec3& centre, const Vec3& from, const Vec3& up, double across) {
  auto* camera = renderer()->GetActiveCamera();
  const Vec3 at = kMm * centre, eye = at + kFar * from.normalized();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(at.x(), at.y(), at.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  camera->SetParallelScale(0.5 * kMm * across * height() / width());
  camera->SetClippingRange(1.0, 2 * kFar);
}

QImage TissuePicture::still() {
  show();
  QElapsedTimer timer;
  timer.start();
  while (!isValid() && timer.elapsed() < kFirstPictureMs) QApplication::processEvents(QEventLoop::AllEvents, 20);
  const QImage image = picture();
  hide();
  return image;
}

}  // namespace vallecula::gui

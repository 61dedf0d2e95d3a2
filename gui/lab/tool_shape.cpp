#include "gui/lab/tool_shape.h"

#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "engine/mesh/triangle_bvh.h"
#include "engine/tool/shapes.h"
#include "gui/lab/number_text.h"
#include "gui/session/files.h"

namespace vallecula::gui {

namespace {

using engine::TriangleMesh;
using engine::Vec3;

constexpr double kLargest = 1.0;  // m: a tool beyond it was given in other units
constexpr int kSphereRings = 6;   // 32,768 triangles: 0.03 % of the radius off at most

double metres(const std::string& word, const std::string& what) {
  const std::optional<double> value = number_in(word);
  if (!value || !(*value > 0) || !(*value < kLargest))
    throw std::invalid_argument("--tool " + what + ": '" + word + "' is not a length in metres above 0 and below 1");
  return *value;
}

template <class Reader>
void read_with(const std::string& file, vtkTriangleFilter* triangles) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkCleanPolyData> clean;  // a corner that each triangle brings its own copy of becomes one
  clean->SetInputConnection(reader->GetOutputPort());
  clean->SetAbsoluteTolerance(0.0);
  clean->ToleranceIsAbsoluteOn();
  triangles->SetInputConnection(clean->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
}

TriangleMesh mesh_file(const std::string& file, double unit_m) {
  read_file(file);  // says what is wrong with the name or the permission
  vtkNew<vtkTriangleFilter> triangles;
  const std::string kind = std::filesystem::path(file).extension().string();
  if (kind == ".stl") {
    read_with<vtkSTLReader>(file, triangles);
  } else if (kind == ".obj") {
    read_with<vtkOBJReader>(file, triangles);
  } else if (kind == ".ply") {
    read_with<vtkPLYReader>(file, triangles);
  } else {
    throw std::invalid_argument("--tool " + file + ": give box:LxWxH, sphere:R, or a file .stl, .obj or .ply");
  }
  vtkPolyData* data = triangles->GetOutput();
  TriangleMesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    mesh.points.push_back(unit_m * Vec3(p[0], p[1], p[2]));
    if (!mesh.points.back().allFinite())
      throw std::runtime_error(file + ": point " + std::to_string(i) + " is not finite");
    if (mesh.points.back().norm() > kLargest)
      throw std::runtime_error(file + ": point " + std::to_string(i) + " lies " +
                               std::to_string(mesh.points.back().norm()) +
                               " m from the origin; a tool is smaller than 1 m (see --length-unit)");
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
    data->GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() != 3) continue;
    mesh.triangles.push_back(
        {static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)), static_cast<int>(ids->GetId(2))});
  }
  if (mesh.triangles.empty()) throw std::runtime_error(file + ": holds no triangles");
  const int open = engine::count_open_edges(mesh);
  if (open > 0)
    throw std::runtime_error(file + ": its surface is not closed (" + std::to_string(open) +
                             " edges do not have a triangle on each side); close it and write it again");
  double volume = 0.0;
  for (const auto& t : mesh.triangles) volume += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6;
  if (volume < 0)  // wound the other way round throughout
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

TriangleMesh tool_shape(const std::string& what, double unit_m) {
  if (what.rfind("sphere:", 0) == 0) return engine::sphere_surface(metres(what.substr(7), what), kSphereRings);
  if (what.rfind("box:", 0) == 0) {
    const std::size_t first = what.find('x', 4),
                      second = first == std::string::npos ? first : what.find('x', first + 1);
    if (second == std::string::npos)
      throw std::invalid_argument("--tool " + what + ": write box:LxWxH in metres, for instance box:0.06x0.01x0.003");
    return engine::box_surface(Vec3::Zero(), Vec3(metres(what.substr(4, first - 4), what),
                                                  metres(what.substr(first + 1, second - first - 1), what),
                                                  metres(what.substr(second + 1), what)));
  }
  return mesh_file(what, unit_m);
}

}  // namespace vallecula::gui

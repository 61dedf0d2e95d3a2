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
#include <map>
#include <stdexcept>

#include "engine/mesh/triangle_bvh.h"
#include "gui/session/files.h"

namespace vallecula::gui {

namespace {

using engine::TriangleMesh;
using engine::Vec3;

constexpr double kLargest = 1.0;     // m: a tool beyond it was given in other units
constexpr int kSphereRings = 5;      // subdivisions of an icosahedron: 20 * 4^5 triangles, 0.1 % of the radius off at most

double metres(const std::string& word, const std::string& what) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !(value > 0) || !(value < kLargest))
    throw std::invalid_argument("--tool " + what + ": '" + word + "' is not a length in metres above 0 and below 1");
  return value;
}

TriangleMesh box(const Vec3& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(0.5 * Vec3((i & 1) ? size.x() : -size.x(), (i & 2) ? size.y() : -size.y(),
                                     (i & 4) ? size.z() : -size.z()));
  static constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// An icosahedron, its triangles halved along every edge and pushed out to the sphere.
TriangleMesh sphere(double radius) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  for (double a : {-1.0, 1.0})
    for (double b : {-g, g}) {
      mesh.points.emplace_back(0, a, b);
      mesh.points.emplace_back(a, b, 0);
      mesh.points.emplace_back(b, 0, a);
    }
  for (Vec3& p : mesh.points) p.normalize();
  const double edge = (2 / std::sqrt(1 + g * g)) * 1.01;
  for (int i = 0; i < 12; ++i)
    for (int j = i + 1; j < 12; ++j)
      for (int k = j + 1; k < 12; ++k) {
        const Vec3 &a = mesh.points[i], &b = mesh.points[j], &c = mesh.points[k];
        if ((a - b).norm() > edge || (b - c).norm() > edge || (c - a).norm() > edge) continue;
        const bool outward = (b - a).cross(c - a).dot(a) > 0;
        mesh.triangles.push_back({i, outward ? j : k, outward ? k : j});
      }
  for (int ring = 0; ring < kSphereRings; ++ring) {
    std::map<std::pair<int, int>, int> middle;
    const auto halve = [&](int a, int b) {
      const auto [it, fresh] = middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.points.size()));
      if (fresh) mesh.points.push_back((mesh.points[a] + mesh.points[b]).normalized());
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = halve(a, b), bc = halve(b, c), ca = halve(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& p : mesh.points) p *= radius;
  return mesh;
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
    mesh.triangles.push_back({static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)), static_cast<int>(ids->GetId(2))});
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
  if (what.rfind("sphere:", 0) == 0) return sphere(metres(what.substr(7), what));
  if (what.rfind("box:", 0) == 0) {
    const std::size_t first = what.find('x', 4), second = first == std::string::npos ? first : what.find('x', first + 1);
    if (second == std::string::npos)
      throw std::invalid_argument("--tool " + what + ": write box:LxWxH in metres, for instance box:0.06x0.01x0.003");
    return box(Vec3(metres(what.substr(4, first - 4), what), metres(what.substr(first + 1, second - first - 1), what),
                    metres(what.substr(second + 1), what)));
  }
  return mesh_file(what, unit_m);
}

}  // namespace vallecula::gui

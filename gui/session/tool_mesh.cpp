#include "gui/session/tool_mesh.h"

#include <vtkCleanPolyData.h>
#include <vtkDecimatePro.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkObject.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "engine/mesh/triangle_bvh.h"
#include "gui/session/files.h"
#include "gui/session/ply_file.h"
#include "gui/session/poly_data.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

using engine::TriangleMesh;
using engine::Vec3;

constexpr double kLargest = 1.0;       // m: a tool beyond it was given in other units
constexpr double kLeastVolume = 1e-9;  // m3, one cubic millimetre: less is a sheet or a speck, not a tool
// What keeps a surface from being reduced is noise of the size of its triangles, which folds it: no field is exact
// there.
constexpr const char* kRough =
    "; it is rough: smooth it in a mesh editor, else contact forces may be wrong and steps come late";
constexpr double kMostMoved = 0.0002;  // m, by reducing: what contact resolves

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

std::string lower_case_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

vtkSmartPointer<vtkPolyData> in_double(const TriangleMesh& mesh) {
  return poly_data(mesh.points, mesh.triangles, 1.0, VTK_DOUBLE);
}

/// VTK's readers write pages about a file they cannot read; what is wrong is said here, in one line.
class QuietVtk {
 public:
  QuietVtk() { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(was_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int was_ = vtkObject::GetGlobalWarningDisplay();
};

/// What the reader found, before any filter trusts its point numbers.
template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(const fs::path& file) {
  const QuietVtk quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(file.string().c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> read_kind(const fs::path& file, const std::string& bytes) {
  const std::string kind = lower_case_ending(file);
  if (kind == ".stl") return read_with<vtkSTLReader>(file);
  if (kind == ".obj") return read_with<vtkOBJReader>(file);
  if (kind == ".ply") {
    try {
      return in_double(mesh_from_ply(bytes));
    } catch (const std::runtime_error& error) {
      refuse(file, error.what());
    }
  }
  refuse(file, "is of no kind that is read as a tool; give a file .stl, .obj or .ply");
}

void check_cells(const fs::path& file, vtkPolyData* data) {
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
    data->GetCellPoints(c, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      if (ids->GetId(k) < 0 || ids->GetId(k) >= data->GetNumberOfPoints())
        refuse(file, "face " + std::to_string(c) + " names point " + std::to_string(ids->GetId(k)) +
                         ", which does not exist; the file is damaged");
  }
}

void check_points(const fs::path& file, vtkPolyData* data, double unit_m, const std::string& option) {
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    const Vec3 metres = unit_m * Vec3(p[0], p[1], p[2]);
    if (!metres.allFinite()) refuse(file, "point " + std::to_string(i) + " is not finite");
    if (metres.norm() > kLargest)
      refuse(file, "point " + std::to_string(i) + " lies " + std::to_string(metres.norm()) +
                       " m from the origin; a tool is smaller than 1 m (see " + option + ")");
  }
}

/// Edges that run the same way in both of their triangles: 0 where neighbours are turned alike.
int count_turned_edges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> directed;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
  int turned = 0;
  for (const auto& [edge, count] : directed)
    if (count == 2 && directed.count({edge.second, edge.first}) == 0) ++turned;
  return turned;
}

/// One mesh a part of the surface that is not joined to the rest; all of them keep the whole's points.
std::vector<std::vector<std::size_t>> parts_of(const TriangleMesh& mesh) {
  std::vector<int> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles)
    for (int k = 1; k < 3; ++k) parent[root(t[k])] = root(t[0]);
  std::map<int, std::vector<std::size_t>> parts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) parts[root(mesh.triangles[t][0])].push_back(t);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [first, triangles] : parts) result.push_back(std::move(triangles));
  return result;
}

/// Turns parts that face inwards. A part within another's box may be a hollow of it, and stays.
int turn_outwards(TriangleMesh& mesh) {
  struct Part {
    Extent box;
    double volume;
  };
  const auto triangles_of_parts = parts_of(mesh);
  std::vector<Part> parts;
  for (const auto& triangles : triangles_of_parts) {
    TriangleMesh alone;
    for (const std::size_t t : triangles)
      for (const int v : mesh.triangles[t]) alone.points.push_back(mesh.points[v]);
    for (int i = 0; i < static_cast<int>(alone.points.size()); i += 3) alone.triangles.push_back({i, i + 1, i + 2});
    parts.push_back({extent_of(alone), enclosed_volume(alone)});
  }
  int turned = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto holds = [&](const Part& other) {
      return &other != &parts[i] && (other.box.low.array() < parts[i].box.low.array()).all() &&
             (other.box.high.array() > parts[i].box.high.array()).all();
    };
    if (parts[i].volume >= 0 || std::any_of(parts.begin(), parts.end(), holds)) continue;
    for (const std::size_t t : triangles_of_parts[i]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    ++turned;
  }
  return turned;
}

/// The triangles of `data`, with points in `unit_m`.
TriangleMesh from_vtk(vtkPolyData* data, double unit_m) {
  TriangleMesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    double p[3];
    data->GetPoint(i, p);
    mesh.points.push_back(unit_m * Vec3(p[0], p[1], p[2]));
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
    data->GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() != 3) continue;
    mesh.triangles.push_back(
        {static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(1)), static_cast<int>(ids->GetId(2))});
  }
  return mesh;
}

}  // namespace

void reduce_tool_mesh(ToolMesh& tool, const fs::path& file, std::size_t most) {
  const std::size_t count = tool.surface.triangles.size();
  if (count <= most) return;
  const vtkSmartPointer<vtkPolyData> whole = in_double(tool.surface);
  char text[160];
  for (std::size_t target = most; target < count; target *= 2) {
    vtkNew<vtkDecimatePro> decimation;
    decimation->SetInputData(whole);
    decimation->SetTargetReduction(1.0 - static_cast<double>(target) / static_cast<double>(count));
    decimation->PreserveTopologyOn();  // quadric decimation pinches thin blades into open edges
    decimation->Update();
    TriangleMesh reduced = from_vtk(decimation->GetOutput(), 1.0);
    if (reduced.triangles.empty() || engine::count_open_edges(reduced) > 0) continue;
    const engine::TriangleBvh now(reduced);
    double moved = 0.0;
    for (const Vec3& p : tool.surface.points) moved = std::max(moved, std::abs(now.signed_distance(p, kMostMoved)));
    if (!(moved < kMostMoved)) continue;
    std::snprintf(text, sizeof text, ": reduced from %zu to %zu triangles; no point of it moved by more than %.3f mm",
                  count, reduced.triangles.size(), 1e3 * moved);
    tool.notices.push_back(file.filename().string() + text +
                           (reduced.triangles.size() > most + most / 10 ? kRough : ""));
    tool.surface = std::move(reduced);
    return;
  }
  std::snprintf(text, sizeof text, ": has %zu triangles and cannot be reduced without moving it by %.1f mm", count,
                1e3 * kMostMoved);
  tool.notices.push_back(file.filename().string() + text + kRough);
}

double enclosed_volume(const TriangleMesh& mesh) {
  // About a point of the surface, not the origin: a scan may stand far from it.
  const Vec3 from = mesh.points.empty() ? Vec3(Vec3::Zero()) : mesh.points.front();
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += (mesh.points[t[0]] - from).dot((mesh.points[t[1]] - from).cross(mesh.points[t[2]] - from)) / 6;
  return volume;
}

Extent extent_of(const TriangleMesh& mesh) {
  Extent extent{Vec3::Constant(1e30), Vec3::Constant(-1e30)};
  for (const Vec3& p : mesh.points) {
    extent.low = extent.low.cwiseMin(p);
    extent.high = extent.high.cwiseMax(p);
  }
  return extent;
}

ToolMesh read_tool_mesh(const fs::path& file, double unit_m, const std::string& unit_option) {
  const std::string bytes = read_file(file);  // says what is wrong with the name or the permission
  const vtkSmartPointer<vtkPolyData> raw = read_kind(file, bytes);
  check_cells(file, raw);
  check_points(file, raw, unit_m, unit_option);  // before a filter sorts points that may not be numbers
  vtkNew<vtkCleanPolyData> clean;                // a corner that each triangle brings its own copy of becomes one
  clean->SetInputData(raw);
  clean->SetAbsoluteTolerance(0.0);
  clean->ToleranceIsAbsoluteOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(clean->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();

  ToolMesh tool;
  tool.surface = from_vtk(triangles->GetOutput(), unit_m);
  if (tool.surface.triangles.empty()) refuse(file, "holds no triangles");
  const int open = engine::count_open_edges(tool.surface);
  const int turned_edges = open > 0 ? count_turned_edges(tool.surface) : 0;
  if (turned_edges > 0)
    refuse(file, "its triangles are not turned alike (at " + std::to_string(turned_edges) +
                     " edges two neighbours face opposite ways); orient them in a mesh editor and write it again");
  if (open > 0)
    refuse(file, "its surface is not closed (" + std::to_string(open) +
                     " edges do not have a triangle on each side); close it and write it again");
  if (const int turned = turn_outwards(tool.surface); turned > 0)
    tool.notices.push_back(file.filename().string() + ": its surface faced inwards and was turned" +
                           (turned > 1 ? " (" + std::to_string(turned) + " parts)" : std::string()));
  if (!(enclosed_volume(tool.surface) > kLeastVolume))
    refuse(file, "encloses no volume (" + std::to_string(1e9 * enclosed_volume(tool.surface)) +
                     " mm3); a tool is a solid (see " + unit_option + ")");
  return tool;
}

}  // namespace vallecula::gui

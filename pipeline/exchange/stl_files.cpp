#include "pipeline/exchange/stl_files.h"

#include <vtkNew.h>
#include <vtkSTLWriter.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "pipeline/mesh/to_vtk.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

void write_stl(const Surface& surface, const fs::path& file) {
  const auto aside = fs::path(file.string() + ".part");
  const auto shape = to_vtk(surface);
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileName(aside.c_str());
  writer->SetFileTypeToBinary();
  writer->SetHeader("Vallecula; mm; SPACE=LPS");
  writer->SetInputData(shape);
  std::error_code failed;
  if (writer->Write() == 1) fs::rename(aside, file, failed);
  if (writer->GetErrorCode() == 0 && !failed && fs::exists(file)) return;
  fs::remove(aside, failed);
  throw PackageError("file " + file.filename().string() +
                     ": cannot be written; is the folder writable and the disk not "
                     "full?");
}

}  // namespace

Surface border_of(const TetMesh& mesh) {
  // Faces of positively oriented tetrahedra, seen from outside.
  constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::map<std::array<int, 3>, std::pair<int, std::array<int, 3>>> faces;
  for (const auto& t : mesh.tets) {
    for (const auto& f : kFaces) {
      const std::array<int, 3> face{t[f[0]], t[f[1]], t[f[2]]};
      auto key = face;
      std::sort(key.begin(), key.end());
      auto& entry = faces[key];
      ++entry.first;
      entry.second = face;
    }
  }
  Surface out;
  std::vector<int> to(mesh.points.size(), -1);
  for (const auto& [key, entry] : faces) {
    if (entry.first != 1) continue;
    auto triangle = entry.second;
    for (int& v : triangle) {
      auto& n = to[static_cast<std::size_t>(v)];
      if (n < 0) {
        n = static_cast<int>(out.points.size());
        out.points.push_back(mesh.points[static_cast<std::size_t>(v)]);
      }
      v = n;
    }
    out.triangles.push_back(triangle);
  }
  return out;
}

std::vector<std::string> write_stl_files(const PatientPackage& package, const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!fs::is_directory(folder))
    throw PackageError("folder " + folder.filename().string() + ": cannot be created; choose another");
  auto surfaces = package.surfaces;
  surfaces["tongue"] = border_of(package.tongue);
  std::vector<std::string> names;
  for (const auto& [name, surface] : surfaces) {
    names.push_back(name + ".stl");
    write_stl(surface, folder / names.back());
  }
  return names;
}

}  // namespace vallecula::pipeline

#include "pipeline/package/mesh_files.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>

namespace vallecula::pipeline {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw PackageError("package file " + file.filename().string() + ": " + what + "; import the series again");
}

vtkNew<vtkPoints> to_vtk(const std::vector<Point>& points) {
  vtkNew<vtkPoints> out;
  out->SetDataTypeToDouble();
  out->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) out->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  return out;
}

vtkNew<vtkUnsignedCharArray> to_vtk(const std::vector<std::uint8_t>& values, const char* name) {
  vtkNew<vtkUnsignedCharArray> out;
  out->SetName(name);
  out->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) out->SetValue(static_cast<vtkIdType>(i), values[i]);
  return out;
}

void say_words(vtkDataObject* data, const char* name, std::initializer_list<const char*> words) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const char* word : words) array->InsertNextValue(word);
  data->GetFieldData()->AddArray(array);
}

void say_unit_and_frame(vtkDataObject* data) {
  say_words(data, "unit", {"mm"});
  say_words(data, "frame", {"LPS"});
}

/// By the number in the array "tissue". For other programs: patient.yaml says what the trainer uses.
void say_materials(vtkDataObject* data, const std::map<std::string, Material>& materials) {
  const std::array<std::pair<const char*, double Material::*>, 3> kinds{
      {{"young_pa", &Material::young_pa}, {"poisson", &Material::poisson}, {"density_kg_m3", &Material::density_kg_m3}}};
  for (const auto& [name, member] : kinds) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const char* tissue : {"tongue", "epiglottis"}) array->InsertNextValue(materials.at(tissue).*member);
    data->GetFieldData()->AddArray(array);
  }
}

template <class Writer, class Data>
void write(Data* data, const std::filesystem::path& file) {
  vtkNew<Writer> writer;
  writer->SetFileName(file.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetInputData(data);
  if (writer->Write() != 1) fail(file, "cannot be written; is there space on the disk");
}

/// Remembers that a reader complained instead of letting VTK print to the terminal.
class ErrorFlag : public vtkCommand {
 public:
  static ErrorFlag* New() { return new ErrorFlag; }
  void Execute(vtkObject*, unsigned long, void*) override { raised = true; }
  bool raised = false;
};

template <class Reader>
void read(Reader* reader, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) fail(file, "is missing");
  vtkNew<ErrorFlag> error;
  reader->AddObserver(vtkCommand::ErrorEvent, error);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (error->raised || reader->GetErrorCode() != 0) fail(file, "cannot be read as a VTK XML file");
  const auto* unit = vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("unit"));
  if (unit == nullptr || const_cast<vtkStringArray*>(unit)->GetValue(0) != "mm")
    fail(file, "does not say that it is in mm");
}

std::vector<Point> points_of(vtkPoints* points, const std::filesystem::path& file) {
  std::vector<Point> out(points == nullptr ? 0 : static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (std::size_t i = 0; i < out.size(); ++i) {
    points->GetPoint(static_cast<vtkIdType>(i), out[i].data());
    for (const double v : out[i]) {
      if (!std::isfinite(v)) fail(file, "point " + std::to_string(i) + " is not a finite number");
    }
  }
  if (out.empty()) fail(file, "has no points");
  return out;
}

std::vector<std::uint8_t> values_of(vtkFieldData* data, const char* name, std::size_t count, int highest,
                                    const std::filesystem::path& file) {
  auto* array = data->GetArray(name);
  if (array == nullptr || static_cast<std::size_t>(array->GetNumberOfTuples()) != count) {
    fail(file, std::string("the array \"") + name + "\" is missing or has the wrong length");
  }
  std::vector<std::uint8_t> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double v = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(v >= 0.0 && v <= highest)) fail(file, std::string("\"") + name + "\" holds an unknown value");
    out[i] = static_cast<std::uint8_t>(v);
  }
  return out;
}

template <std::size_t N>
std::vector<std::array<int, N>> cells_of(vtkCellArray* cells, std::size_t points, const std::filesystem::path& file) {
  std::vector<std::array<int, N>> out;
  out.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
  vtkIdType n = 0;
  const vtkIdType* ids = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(n, ids);) {
    if (n != static_cast<vtkIdType>(N)) fail(file, "holds a cell with " + std::to_string(n) + " corners");
    std::array<int, N> cell{};
    for (std::size_t k = 0; k < N; ++k) {
      if (ids[k] < 0 || static_cast<std::size_t>(ids[k]) >= points)
        fail(file, "a cell names a point that does not exist");
      cell[k] = static_cast<int>(ids[k]);
    }
    out.push_back(cell);
  }
  if (out.empty()) fail(file, "has no cells");
  return out;
}

double six_volumes(const TetMesh& m, const std::array<int, 4>& t) {
  std::array<Point, 3> e{};
  for (int k = 0; k < 3; ++k) {
    for (int a = 0; a < 3; ++a) e[k][a] = m.points[t[k + 1]][a] - m.points[t[0]][a];
  }
  return (e[0][1] * e[1][2] - e[0][2] * e[1][1]) * e[2][0] + (e[0][2] * e[1][0] - e[0][0] * e[1][2]) * e[2][1] +
         (e[0][0] * e[1][1] - e[0][1] * e[1][0]) * e[2][2];
}

}  // namespace

void write_surface(const Surface& surface, const std::filesystem::path& file) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(to_vtk(surface.points));
  vtkNew<vtkCellArray> cells;
  for (const auto& t : surface.triangles) {
    const std::array<vtkIdType, 3> ids{t[0], t[1], t[2]};
    cells->InsertNextCell(3, ids.data());
  }
  data->SetPolys(cells);
  if (!surface.tissue.empty()) data->GetCellData()->AddArray(to_vtk(surface.tissue, "tissue"));
  say_unit_and_frame(data);
  write<vtkXMLPolyDataWriter>(data.Get(), file);
}

void write_tet_mesh(const TetMesh& mesh, const std::map<std::string, Material>& materials,
                    const std::filesystem::path& file) {
  vtkNew<vtkUnstructuredGrid> data;
  data->SetPoints(to_vtk(mesh.points));
  vtkNew<vtkCellArray> cells;
  for (const auto& t : mesh.tets) {
    const std::array<vtkIdType, 4> ids{t[0], t[1], t[2], t[3]};
    cells->InsertNextCell(4, ids.data());
  }
  data->SetCells(VTK_TETRA, cells);
  data->GetCellData()->AddArray(to_vtk(mesh.tissue, "tissue"));
  data->GetPointData()->AddArray(to_vtk(mesh.anchor, "anchor"));
  if (!mesh.contact.empty()) data->GetPointData()->AddArray(to_vtk(mesh.contact, "contact"));
  say_unit_and_frame(data);
  say_words(data, "tissue_names", {"tongue", "epiglottis"});
  say_words(data, "anchor_names", {"free", "mandible", "hyoid", "larynx"});
  say_words(data, "contact_names", {"inside", "free", "tissue"});
  say_materials(data, materials);
  write<vtkXMLUnstructuredGridWriter>(data.Get(), file);
}

Surface read_surface(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  read(reader.Get(), file);
  auto* data = reader->GetOutput();
  Surface surface;
  surface.points = points_of(data->GetPoints(), file);
  surface.triangles = cells_of<3>(data->GetPolys(), surface.points.size(), file);
  if (data->GetCellData()->HasArray("tissue")) {
    surface.tissue =
        values_of(data->GetCellData(), "tissue", surface.triangles.size(), static_cast<int>(Tissue::larynx), file);
  }
  return surface;
}

TetMesh read_tet_mesh(const std::filesystem::path& file) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  read(reader.Get(), file);
  auto* data = reader->GetOutput();
  TetMesh mesh;
  mesh.points = points_of(data->GetPoints(), file);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
    if (data->GetCellType(i) != VTK_TETRA) fail(file, "holds a cell that is not a tetrahedron");
  }
  mesh.tets = cells_of<4>(data->GetCells(), mesh.points.size(), file);
  mesh.tissue = values_of(data->GetCellData(), "tissue", mesh.tets.size(), 1, file);
  mesh.anchor = values_of(data->GetPointData(), "anchor", mesh.points.size(), static_cast<int>(Anchor::larynx), file);
  if (data->GetPointData()->HasArray("contact")) {
    mesh.contact =
        values_of(data->GetPointData(), "contact", mesh.points.size(), static_cast<int>(Contact::tissue), file);
  }
  for (const auto& t : mesh.tets) {
    if (!(six_volumes(mesh, t) > 0.0)) fail(file, "holds a flat or inverted tetrahedron");
  }
  return mesh;
}

}  // namespace vallecula::pipeline

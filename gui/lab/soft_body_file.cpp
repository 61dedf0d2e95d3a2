#include "gui/lab/soft_body_file.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "engine/mesh/soft_mesh.h"
#include "gui/lab/number_text.h"
#include "gui/session/files.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

constexpr long kMostNodes = 2'000'000;  // a million tetrahedra take hours a second of motion; more is a damaged header

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

/// Lines of numbers, comments (#) and blank lines left out.
class NumberLines {
 public:
  explicit NumberLines(const fs::path& file) : file_(file), in_(file) {
    std::error_code error;
    if (!in_ || fs::is_directory(file, error)) refuse(file, "cannot be opened; check the name and the permission");
  }
  /// The next line's numbers; empty at the end of the file.
  std::vector<double> next() {
    std::string line;
    while (std::getline(in_, line)) {
      ++number_;
      line.resize(std::min(line.size(), line.find('#')));
      std::istringstream words(line);
      std::vector<double> values;
      std::string word;
      while (words >> word) {
        const std::optional<double> value = number_in(word);
        if (!value)
          refuse(file_, "line " + std::to_string(number_) + ": '" + word.substr(0, 40) + "' is not a finite number");
        values.push_back(*value);
      }
      if (!values.empty()) return values;
    }
    return {};
  }
  std::string where() const { return "line " + std::to_string(number_) + ": "; }

 private:
  fs::path file_;
  std::ifstream in_;
  int number_ = 0;
};

void read_tetgen(const fs::path& named, SoftBodyFile& body) {
  const fs::path nodes = fs::path(named).replace_extension(".node"), eles = fs::path(named).replace_extension(".ele");
  NumberLines node_lines(nodes);
  const std::vector<double> head = node_lines.next();
  if (head.size() < 2 || head[1] != 3 || !(head[0] >= 4) || head[0] > kMostNodes)
    refuse(nodes,
           "its first line must be 'number of points, 3, ...' with 4 to " + std::to_string(kMostNodes) + " points");
  const long count = static_cast<long>(head[0]);
  for (long i = 0; i < count; ++i) {
    const std::vector<double> v = node_lines.next();
    if (v.size() < 4)
      refuse(nodes,
             node_lines.where() + "expected 'number x y z'; the file says it has " + std::to_string(count) + " points");
    if (i == 0) body.first_number = static_cast<int>(v[0]);
    if (v[0] != static_cast<double>(body.first_number + i))
      refuse(nodes, node_lines.where() + "point numbers must run on from " + std::to_string(body.first_number));
    body.soft.nodes.emplace_back(v[1], v[2], v[3]);
  }
  if (body.first_number != 0 && body.first_number != 1)
    refuse(nodes, "points are numbered from " + std::to_string(body.first_number) + "; TetGen numbers from 0 or 1");
  NumberLines ele_lines(eles);
  const std::vector<double> ele_head = ele_lines.next();
  if (ele_head.size() < 2 || ele_head[1] != 4 || !(ele_head[0] >= 1) || ele_head[0] > 8.0 * kMostNodes)
    refuse(eles,
           "its first line must be 'number of tetrahedra, 4, ...' (quadratic tetrahedra with 10 nodes are not read)");
  for (long t = 0; t < static_cast<long>(ele_head[0]); ++t) {
    const std::vector<double> v = ele_lines.next();
    if (v.size() < 5) refuse(eles, ele_lines.where() + "expected 'number a b c d'");
    std::array<int, 4> tet;
    for (int k = 0; k < 4; ++k) {
      const double index = v[k + 1] - body.first_number;
      if (!(index >= 0) || !(index < static_cast<double>(count)) || index != std::floor(index))
        refuse(eles,
               ele_lines.where() + "point " + std::to_string(static_cast<long long>(v[k + 1])) + " does not exist");
      tet[k] = static_cast<int>(index);
    }
    body.soft.tets.push_back(tet);
  }
}

void read_vtu(const fs::path& file, SoftBodyFile& body) {
  read_file(file);  // says what is wrong with the name or the permission
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  if (reader->CanReadFile(file.string().c_str()) == 0)
    refuse(file, "is not a VTK XML file of an unstructured grid (.vtu)");
  reader->SetFileName(file.string().c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || grid->GetNumberOfPoints() < 4 || grid->GetNumberOfPoints() > kMostNodes)
    refuse(file, "holds no readable grid of 4 to " + std::to_string(kMostNodes) + " points");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    double p[3];
    grid->GetPoint(i, p);
    body.soft.nodes.emplace_back(p[0], p[1], p[2]);
    if (!body.soft.nodes.back().allFinite()) refuse(file, "point " + std::to_string(i) + " is not finite");
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    if (grid->GetCellType(c) != VTK_TETRA) continue;
    grid->GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() != 4)
      refuse(file, "cell " + std::to_string(c) + " has " + std::to_string(ids->GetNumberOfIds()) +
                       " points, a tetrahedron 4");
    for (int k = 0; k < 4; ++k)
      if (ids->GetId(k) < 0 || ids->GetId(k) >= grid->GetNumberOfPoints())
        refuse(file, "cell " + std::to_string(c) + " names point " + std::to_string(ids->GetId(k)) +
                         ", which does not exist");
    std::array<int, 4> tet;
    for (int k = 0; k < 4; ++k) tet[k] = static_cast<int>(ids->GetId(k));
    body.soft.tets.push_back(tet);
  }
  if (body.soft.tets.empty()) refuse(file, "holds no linear tetrahedra");
}

/// Every tetrahedron of positive volume, all joined, every node used.
void check_mesh(const fs::path& file, SoftBodyFile& body) {
  auto& soft = body.soft;
  const auto volume = [&](const std::array<int, 4>& k) {
    return engine::tet_volume(soft.nodes[k[0]], soft.nodes[k[1]], soft.nodes[k[2]], soft.nodes[k[3]]);
  };
  double mean = 0.0;
  std::size_t negative = 0, first_negative = 0;
  for (std::size_t t = 0; t < soft.tets.size(); ++t) {
    const double v = volume(soft.tets[t]);
    mean += std::abs(v) / static_cast<double>(soft.tets.size());
    if (v < 0 && negative++ == 0) first_negative = t;
  }
  if (negative > 0 && 2 * negative <= soft.tets.size())
    refuse(file, "tetrahedron " + std::to_string(first_negative) + " is inverted (volume " +
                     std::to_string(volume(soft.tets[first_negative]) * 1e9) + " mm3), " + std::to_string(negative) +
                     " of " + std::to_string(soft.tets.size()) + " are; repair the mesh");
  if (negative > 0)
    for (std::size_t t = 0; t < soft.tets.size(); ++t) {
      if (volume(soft.tets[t]) > 0)
        refuse(file, "tetrahedron " + std::to_string(t) + " is inverted against the others; repair the mesh");
      std::swap(soft.tets[t][2], soft.tets[t][3]);
    }
  for (std::size_t t = 0; t < soft.tets.size(); ++t)
    if (!(volume(soft.tets[t]) > 1e-6 * mean))
      refuse(file, "tetrahedron " + std::to_string(t) + " is flat (volume " +
                       std::to_string(volume(soft.tets[t]) * 1e9) + " mm3, mean " + std::to_string(mean * 1e9) +
                       " mm3); remesh it");
  std::vector<int> parent(soft.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<char> used(soft.nodes.size(), 0);
  for (const auto& k : soft.tets)
    for (int v : k) {
      used[v] = 1;
      parent[root(v)] = root(k[0]);
    }
  for (std::size_t i = 0; i < soft.nodes.size(); ++i) {
    if (!used[i]) refuse(file, "point " + std::to_string(i + body.first_number) + " belongs to no tetrahedron");
    if (root(static_cast<int>(i)) != root(0))
      refuse(file, "the mesh falls into parts that are not joined (points " + std::to_string(body.first_number) +
                       " and " + std::to_string(i + body.first_number) + "); give one body");
  }
}

void check_fixed(const engine::SoftBodyDescription& soft, const std::string& by) {
  const auto fixed = std::count(soft.node_anchor.begin(), soft.node_anchor.end(), 0);
  if (fixed < 3)
    throw std::invalid_argument(by + " fixes " + std::to_string(fixed) + " nodes; a body must be held by 3 at least");
  if (fixed == static_cast<std::ptrdiff_t>(soft.nodes.size()))
    throw std::invalid_argument(by + " fixes every node; nothing is left to move");
}

}  // namespace

SoftBodyFile read_soft_body(const fs::path& file, double unit_m) {
  SoftBodyFile body;
  const std::string kind = file.extension().string();
  if (kind == ".vtu") {
    read_vtu(file, body);
  } else if (kind == ".node" || kind == ".ele") {
    read_tetgen(file, body);
  } else {
    refuse(file, "is of an unknown kind; give a .vtu, .node or .ele file");
  }
  for (engine::Vec3& p : body.soft.nodes) p *= unit_m;
  check_mesh(file, body);
  body.soft.materials = {engine::TissueMaterial{}};
  body.soft.bodies = {engine::SprungBody{}};
  body.soft.tet_material.assign(body.soft.tets.size(), 0);
  body.soft.tet_structure.assign(body.soft.tets.size(), engine::Structure::tongue);
  body.soft.node_anchor.assign(body.soft.nodes.size(), -1);
  return body;
}

void fix_nodes_by_rule(engine::SoftBodyDescription& soft, const std::string& rule) {
  std::string text = rule;
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  const std::optional<double> value = text.size() > 2 ? number_in(std::string_view(text).substr(2)) : std::nullopt;
  if (!value || text[0] < 'x' || text[0] > 'z' || (text[1] != '<' && text[1] != '>'))
    throw std::invalid_argument("--fix '" + rule + "': write an axis, < or >, and metres, for instance 'z<-0.003'");
  for (std::size_t i = 0; i < soft.nodes.size(); ++i) {
    const double at = soft.nodes[i][text[0] - 'x'];
    if (text[1] == '<' ? at < *value : at > *value) soft.node_anchor[i] = 0;
  }
  check_fixed(soft, "--fix '" + rule + "'");
}

void fix_nodes_by_file(SoftBodyFile& body, const fs::path& file) {
  NumberLines lines(file);
  for (std::vector<double> v = lines.next(); !v.empty(); v = lines.next())
    for (double number : v) {
      const double index = number - body.first_number;
      if (!(index >= 0) || !(index < static_cast<double>(body.soft.nodes.size())) || index != std::floor(index))
        refuse(file, lines.where() + "node " + std::to_string(static_cast<long long>(number)) + " does not exist");
      body.soft.node_anchor[static_cast<std::size_t>(index)] = 0;
    }
  check_fixed(body.soft, file.string());
}

void write_soft_body(const fs::path& file, const std::vector<engine::Vec3>& nodes,
                     const std::vector<std::array<int, 4>>& tets) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const engine::Vec3& p : nodes) points->InsertNextPoint(p.data());
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->Allocate(static_cast<vtkIdType>(tets.size()));
  for (const auto& t : tets) {
    const vtkIdType ids[4] = {t[0], t[1], t[2], t[3]};
    grid->InsertNextCell(VTK_TETRA, 4, ids);
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->WriteToOutputStringOn();
  writer->Write();
  write_file_whole(file, writer->GetOutputString());
}

}  // namespace vallecula::gui

// Surfaces for other programs.
#include "pipeline/exchange/stl_files.h"

#include <gtest/gtest.h>

#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/vector3.h"
#include "tests/pipeline/exchange/exchange_folder.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;
using test::expect_message;

class StlFiles : public test::ExchangeFolder {};

TEST_F(StlFiles, BorderOfTetrahedraIsClosedAndLooksOutwards) {
  // A cube of five tetrahedra.
  TetMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  mesh.points.push_back({9, 9, 9});  // used by none
  mesh.tets = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}};
  for (auto& t : mesh.tets) {
    const auto& p = mesh.points;
    if (dot(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), p[t[3]] - p[t[0]]) < 0) std::swap(t[0], t[1]);
  }
  const auto border = border_of(mesh);
  EXPECT_EQ(border.points.size(), 8u);
  EXPECT_EQ(border.triangles.size(), 12u);
  const auto f = facts_of(border);
  EXPECT_TRUE(f.closed && f.manifold) << f.fault;
  EXPECT_NEAR(f.volume_mm3, 1.0, 1e-12);

  PatientPackage package;
  package.surfaces["face"] = border;
  package.tongue = mesh;
  EXPECT_EQ(write_stl_files(package, folder_ / "stl"), (std::vector<std::string>{"face.stl", "tongue.stl"}));
  const auto bytes = text_of(folder_ / "stl" / "tongue.stl");
  EXPECT_EQ(bytes.size(), 84u + 50u * 12u) << "binary STL";
  EXPECT_NE(bytes.substr(0, 80).find("LPS"), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "stl"), fs::directory_iterator()), 2);
  write("file", "in the way");
  EXPECT_THROW(write_stl_files(package, folder_ / "file"), PackageError);
}

}  // namespace
}  // namespace vallecula::pipeline

// Tools from mesh files: what is read against known geometry, the tool frame against values computed by hand, and what
// is refused. A trial with such a tool: see trial_tool_test.cpp.
#include "gui/session/tool_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <tuple>

#include "engine/mesh/triangle_bvh.h"
#include "engine/tool/miller_blade.h"
#include "engine/tool/shapes.h"
#include "gui/session/placed_tool.h"
#include "gui/session/ply_file.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/tool_file.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;
using engine::Mat3;
using engine::TriangleMesh;
using engine::Vec3;

constexpr double kPi = 3.14159265358979323846;

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was refused";
}
#define EXPECT_REFUSED(work, naming) \
  EXPECT_NE(refusal([&] { work; }).find(naming), std::string::npos) << refusal([&] { work; })

TEST(ToolMesh, EveryFormatGivesBackVolumeAndExtents) {
  const Sandbox box;
  const Vec3 size(0.081, 0.012, 0.0023), centre(0.3, -0.2, 0.1);
  for (const char* name : {"tool.stl", "tool.obj", "tool.ply", "TOOL.STL"})
    for (const double unit : {1.0, 1e-3}) {
      write_tool_file(box / name, engine::box_surface(centre, size), unit);
      const ToolMesh tool = read_tool_mesh(box / name, unit, "--unit");
      EXPECT_TRUE(tool.notices.empty());
      EXPECT_EQ(tool.surface.points.size(), 8u) << name << ": corners are shared";
      EXPECT_EQ(tool.surface.triangles.size(), 12u);
      EXPECT_EQ(engine::count_open_edges(tool.surface), 0);
      // Single precision in the files: 0.3 m to 3e-8.
      EXPECT_NEAR(enclosed_volume(tool.surface) / size.prod(), 1.0, 5e-5) << name;
      const Extent extent = extent_of(tool.surface);
      EXPECT_LT((extent.high - extent.low - size).norm(), 1e-7) << name;
      EXPECT_LT((extent.high + extent.low - 2 * centre).norm(), 1e-7) << name;
    }
}

TEST(ToolMesh, ASurfaceThatFacesInwardsIsTurnedAndSaysSo) {
  const Sandbox box;
  TriangleMesh mesh = engine::box_surface(Vec3::Zero(), Vec3(0.08, 0.01, 0.002));
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  write_tool_file(box / "inward.obj", mesh, 1.0);
  const ToolMesh tool = read_tool_mesh(box / "inward.obj", 1.0, "--unit");
  ASSERT_EQ(tool.notices.size(), 1u);
  EXPECT_NE(tool.notices[0].find("inward.obj: its surface faced inwards"), std::string::npos) << tool.notices[0];
  EXPECT_LT(engine::TriangleBvh(tool.surface).signed_distance(Vec3::Zero(), 1.0), 0);

  // Two parts, one of them inside out; and a hollow, whose inner wall faces inwards by right.
  TriangleMesh two = engine::box_surface(Vec3::Zero(), Vec3(0.08, 0.01, 0.002));
  TriangleMesh other = engine::box_surface(Vec3(0.09, 0, 0), Vec3::Constant(0.01));
  for (auto& t : other.triangles) std::swap(t[0], t[1]);
  join(two, other);
  write_tool_file(box / "two.obj", two, 1.0);
  const ToolMesh mended = read_tool_mesh(box / "two.obj", 1.0, "--unit");
  EXPECT_EQ(mended.notices.size(), 1u);
  EXPECT_NEAR(enclosed_volume(mended.surface), 0.08 * 0.01 * 0.002 + 1e-6, 1e-10);

  TriangleMesh hollow = engine::box_surface(Vec3::Zero(), Vec3::Constant(0.04));
  TriangleMesh wall = engine::box_surface(Vec3::Zero(), Vec3::Constant(0.02));
  for (auto& t : wall.triangles) std::swap(t[0], t[1]);
  join(hollow, wall);
  write_tool_file(box / "hollow.obj", hollow, 1.0);
  const ToolMesh kept = read_tool_mesh(box / "hollow.obj", 1.0, "--unit");
  EXPECT_TRUE(kept.notices.empty());
  EXPECT_NEAR(enclosed_volume(kept.surface), 64e-6 - 8e-6, 1e-10);
}

TEST(ToolMesh, WhatIsNoToolIsRefusedByName) {
  const Sandbox box;
  const auto refused = [&](const std::string& name, const std::string& text, const std::string& naming) {
    write_text(box / name, text);
    const std::string said = refusal([&] { read_tool_mesh(box / name, 1.0, "--unit"); });
    EXPECT_NE(said.find(name), std::string::npos) << said;
    EXPECT_NE(said.find(naming), std::string::npos) << said;
  };
  const std::string corners = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\n";
  refused("open.obj", corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\n", "not closed (3 edges");
  refused("unlike.obj", corners + "f 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "not turned alike (at 3 edges");
  refused("empty.obj", "", "holds no triangles");
  refused("points.obj", corners, "holds no triangles");
  refused("text.ply", "no mesh at all\n", "is no PLY file");
  refused("text.stl", "no mesh at all\n", "holds no triangles");
  refused("flat.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 2\n", "encloses no volume");
  refused("far.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "--unit");
  refused("nan.obj", "v nan 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "nan.obj");
  refused(
      "beyond.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n0.1 0 0\n0 0.1 0\n3 0 1 900000\n",
      "names a point that does not exist");
  refused("beyond.obj", corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 900000\n", "beyond.obj");
  refused("tool.step", "solid", "no kind");
  EXPECT_REFUSED(read_tool_mesh(box / "none.stl", 1.0, "--unit"), "none.stl: cannot be read");
  EXPECT_REFUSED(read_tool_mesh(box.folder(), 1.0, "--unit"), "cannot be read");
}

TEST(ToolMesh, AScanIsReducedWithinWhatItSays) {
  ToolMesh tool;
  tool.surface = engine::sphere_surface(0.02, 6);  // 32,768 triangles
  reduce_tool_mesh(tool, "ball.stl", 8000);
  ASSERT_EQ(tool.notices.size(), 1u);
  EXPECT_LE(tool.surface.triangles.size(), 8100u) << tool.notices[0];
  EXPECT_EQ(engine::count_open_edges(tool.surface), 0);
  EXPECT_NEAR(enclosed_volume(tool.surface) / (4.0 / 3.0 * kPi * 8e-6), 1.0, 0.01);
  const double said = 1e-3 * std::stod(tool.notices[0].substr(tool.notices[0].find("more than ") + 10));
  const engine::TriangleBvh now(tool.surface);
  std::vector<Vec3> points = engine::sphere_surface(0.02, 6).points;
  for (const Vec3& p : points) ASSERT_LE(std::abs(now.signed_distance(p, 0.01)), said + 5.1e-7);
  EXPECT_LT(said, 0.0002);

  // Noise as large as the triangles folds the surface: it is reduced less or not at all, and that is said.
  ToolMesh rough;
  rough.surface = engine::sphere_surface(0.02, 6);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.0003);
  for (Vec3& p : rough.surface.points) p += Vec3(noise(random), noise(random), noise(random));
  reduce_tool_mesh(rough, "ball.stl", 4000);
  ASSERT_EQ(rough.notices.size(), 1u);
  EXPECT_NE(rough.notices[0].find("it is rough: smooth it"), std::string::npos) << rough.notices[0];
  EXPECT_GT(rough.surface.triangles.size(), 4100u);

  ToolMesh small;
  small.surface = engine::sphere_surface(0.02, 3);
  reduce_tool_mesh(small, "ball.stl");
  EXPECT_EQ(small.surface.triangles.size(), 512u);
  EXPECT_TRUE(small.notices.empty());
}

TEST(ToolMesh, PlyIsReadInAllItsFormsAndNeverBeyondItsEnd) {
  // A tetrahedron and what else scanners write: normals, colours, a second list, an element of their own; big-endian.
  const std::string head =
      "element vertex 4\nproperty uchar red\nproperty float x\nproperty double y\nproperty short z\n"
      "element camera 1\nproperty list uchar uint tags\nelement face 2\nproperty list ushort int vertex_index\n"
      "property float quality\nend_header\n";
  const std::string text = "ply\nformat ascii 1.0\n" + head +
                           "9 0 0 0\n9 1.5 0 0\n9 0 0.1 0\n9 0 0 -3\n2 7 8\n3 0 2 1 0.5\n4 0 1 3 2 1e-2\n";
  std::string big = "ply\r\nformat binary_big_endian 1.0\r\n" + head;
  const auto put = [&big](auto value) {
    const char* bytes = reinterpret_cast<const char*>(&value);
    for (std::size_t i = sizeof value; i-- > 0;) big.push_back(bytes[i]);
  };
  for (const auto& [x, y, z] : {std::tuple{0.0f, 0.0, 0}, {1.5f, 0.0, 0}, {0.0f, 0.1, 0}, {0.0f, 0.0, -3}}) {
    put(std::uint8_t{9});
    put(x);
    put(y);
    put(static_cast<std::int16_t>(z));
  }
  put(std::uint8_t{2});
  for (const std::uint32_t tag : {7u, 8u}) put(tag);
  put(std::uint16_t{3});
  for (const std::int32_t v : {0, 2, 1}) put(v);
  put(0.5f);
  put(std::uint16_t{4});
  for (const std::int32_t v : {0, 1, 3, 2}) put(v);
  put(0.01f);
  for (const std::string& bytes : {text, big}) {
    const TriangleMesh mesh = mesh_from_ply(bytes);
    ASSERT_EQ(mesh.points.size(), 4u);
    EXPECT_EQ(mesh.points[1], Vec3(1.5, 0, 0));
    EXPECT_EQ(mesh.points[2], Vec3(0, 0.1, 0)) << "doubles keep every bit";
    EXPECT_EQ(mesh.points[3], Vec3(0, 0, -3));
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<int, 3>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}));
  }
  for (std::size_t length = 0; length < big.size(); ++length)
    ASSERT_THROW(mesh_from_ply(big.substr(0, length)), std::runtime_error) << length;
  for (const char* wrong : {"ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n0\n",
                            "ply\nformat ascii 1.0\nelement vertex\nend_header\n", "ply\nformat odd\nend_header\n"})
    EXPECT_THROW(mesh_from_ply(wrong), std::runtime_error) << wrong;
}

TEST(PlacedTool, TheFrameIsTheOneComputedByHand) {
  // In the file (m): the blade from (0.5, 0.2, 0.1) towards -y, 100 mm; its handle stands out to +x.
  const TriangleMesh read = moved(laryngoscope(0.1, 0.11), axes(-Vec3::UnitY(), Vec3::UnitX()), Vec3(0.5, 0.2, 0.1));
  const ToolPlacement placement{Vec3(0.5, 0.2, 0.1), Vec3(0.5, 0.1, 0.1), {}};
  const PlacedTool tool = place_tool(read, placement, "tool.stl", "m");
  EXPECT_TRUE(tool.notices.empty());
  EXPECT_NEAR(tool.blade_m, 0.1, 1e-12);
  EXPECT_NEAR(tool.handle_m, std::hypot(0.11, 0.005), 1e-12) << "the far edge of the handle";
  const TriangleMesh expected = laryngoscope(0.1, 0.11);
  ASSERT_EQ(tool.surface.points.size(), expected.points.size());
  for (std::size_t i = 0; i < expected.points.size(); ++i)
    ASSERT_LT((tool.surface.points[i] - expected.points[i]).norm(), 1e-12) << i;
  EXPECT_GT(enclosed_volume(tool.surface), 0) << "turned, not mirrored";

  // The same face said outright, not square to the blade: made square.
  ToolPlacement said = placement;
  said.face = Vec3(2, 1, 0);
  const PlacedTool same = place_tool(read, said, "tool.stl", "m");
  for (std::size_t i = 0; i < expected.points.size(); ++i)
    ASSERT_LT((same.surface.points[i] - expected.points[i]).norm(), 1e-12) << i;
  // Turned a quarter about the blade: what was +z becomes -y of (z x x = y).
  said.face = Vec3(0, 0, 1);
  const PlacedTool quarter = place_tool(read, said, "tool.stl", "m");
  for (std::size_t i = 0; i < expected.points.size(); ++i) {
    const Vec3 &p = expected.points[i], &q = quarter.surface.points[i];
    const Vec3 in_file = Vec3(0.5, 0.2, 0.1) + Vec3(p.z(), -p.x(), 0) + p.y() * Vec3::UnitX().cross(-Vec3::UnitY());
    ASSERT_NEAR(q.x(), 0.2 - in_file.y(), 1e-12);
    ASSERT_NEAR(q.z(), in_file.z() - 0.1, 1e-12);
    ASSERT_NEAR(q.y(), Vec3(Vec3::UnitZ().cross(-Vec3::UnitY())).dot(in_file - Vec3(0.5, 0.2, 0.1)), 1e-12);
  }
  // The wrong way round is done as told, and remarked.
  said.face = Vec3(-1, 0, 0);
  const PlacedTool back = place_tool(read, said, "tool.stl", "m");
  ASSERT_EQ(back.notices.size(), 1u);
  EXPECT_NE(back.notices[0].find("--tool-face points away from the handle"), std::string::npos);
  EXPECT_LT(extent_of(back.surface).low.z(), -0.1);
}

TEST(PlacedTool, WhatCannotBePlacedIsRefused) {
  const TriangleMesh tool = laryngoscope(0.1, 0.11);
  const auto refused = [&](const TriangleMesh& mesh, const ToolPlacement& p, const std::string& unit,
                           const std::string& naming) {
    const std::string said = refusal([&] { place_tool(mesh, p, "tool.stl", unit); });
    EXPECT_NE(said.find(naming), std::string::npos) << said;
  };
  const ToolPlacement good{Vec3::Zero(), Vec3(0.1, 0, 0), {}};
  EXPECT_EQ(place_tool(tool, good, "tool.stl", "mm").surface.triangles.size(), tool.triangles.size());
  TriangleMesh large = tool, small = tool;
  for (Vec3& p : large.points) p *= 5;
  for (Vec3& p : small.points) p *= 1e-3;
  refused(large, good, "m", "540.0 mm x 50.0 mm x 556.0 mm");
  refused(small, good, "mm", "give --tool-unit m");
  refused(tool, {Vec3::Zero(), Vec3::Zero(), {}}, "m", "are the same point");
  refused(tool, {Vec3(0, 0, 0.02), Vec3(0.1, 0, 0), {}}, "m", "--tool-tip lies 19.0 mm off");
  refused(tool, {Vec3(1, 0, 0), Vec3(0.1, 0, 0), {}}, "mm", "its unit (mm)");
  refused(tool, {Vec3::Zero(), Vec3(0.1, 0.05, 0), {}}, "m", "--tool-handle lies");
  refused(tool, {Vec3::Zero(), Vec3(0.01, 0, 0), {}}, "m", "10.0 mm apart");
  refused(tool, {Vec3::Zero(), Vec3(0.1, 0, 0.11), {}}, "m", "not the handle's end");
  refused(tool, {Vec3(0.1, 0, -0.001), Vec3(0, 0, 0), {}}, "m", "are tip and handle exchanged?");
  refused(tool, {Vec3::Zero(), Vec3(0.1, 0, 0), Vec3(1, 0.1, 0)}, "m", "points along the blade");
  const TriangleMesh blade = engine::blade_surface(engine::miller_blade("miller-1"));
  TriangleMesh two_handles = tool;
  join(two_handles, moved(laryngoscope(0.1, 0.11), axes(Vec3::UnitX(), -Vec3::UnitZ()), Vec3::Zero()));
  refused(two_handles, good, "m", "say with --tool-face");
  refused(blade, {Vec3::Zero(), Vec3(0.102, 0, -0.0015), {}}, "m", "say with --tool-face");
}

TEST(PlacedTool, ItsFileGivesBackEveryBitAndOpensElsewhere) {
  const Sandbox box;
  TriangleMesh tool =
      moved(laryngoscope(0.1, 0.11), axes(Vec3(1, 2, 3).normalized(), Vec3::UnitZ()), Vec3(1e-9, 1. / 3, -0.1));
  const std::string bytes = tool_to_ply(tool);
  const TriangleMesh back = mesh_from_ply(bytes);
  ASSERT_EQ(back.points.size(), tool.points.size());
  for (std::size_t i = 0; i < tool.points.size(); ++i) ASSERT_TRUE(back.points[i] == tool.points[i]);
  ASSERT_TRUE(back.triangles == tool.triangles);
  write_text(box / "tool.ply", bytes);
  const ToolMesh elsewhere = read_tool_mesh(box / "tool.ply", 1.0, "--unit");
  EXPECT_EQ(elsewhere.surface.triangles.size(), tool.triangles.size());
  EXPECT_NEAR(enclosed_volume(elsewhere.surface) / enclosed_volume(tool), 1.0, 1e-4);
  for (const std::string& damaged : {bytes.substr(0, bytes.size() - 1), bytes.substr(1), std::string()})
    EXPECT_THROW(mesh_from_ply(damaged), std::runtime_error);
}

}  // namespace
}  // namespace vallecula::gui::test

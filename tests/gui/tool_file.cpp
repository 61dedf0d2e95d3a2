#include "tests/gui/tool_file.h"

#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include "engine/tool/shapes.h"

namespace vallecula::gui::test {

using engine::Mat3;
using engine::TriangleMesh;
using engine::Vec3;

TriangleMesh laryngoscope(double blade, double height) {
  TriangleMesh mesh = engine::box_surface(Vec3(blade / 2, 0, 0), Vec3(blade, 0.010, 0.002));
  join(mesh, engine::box_surface(Vec3(blade, 0, (height - 0.0012) / 2), Vec3(0.016, 0.010, height + 0.0012)));
  return mesh;
}

Mat3 axes(const Vec3& x, const Vec3& z) {
  Mat3 m;
  const Vec3 square = (z - z.dot(x) * x).normalized();
  m << x, square.cross(x), square;
  return m;
}

TriangleMesh moved(TriangleMesh mesh, const Mat3& axes, const Vec3& origin) {
  for (Vec3& p : mesh.points) p = origin + axes * p;
  return mesh;
}

void join(TriangleMesh& mesh, const TriangleMesh& other) {
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

// Written here by hand: a reader must not be tested with its own library's writer.
void write_tool_file(const std::filesystem::path& file, const TriangleMesh& mesh, double unit_m) {
  std::string kind = file.extension().string();
  for (char& c : kind) c = static_cast<char>(std::tolower(c));
  std::ofstream out(file, std::ios::binary);
  out.precision(9);
  if (kind == ".stl") {
    const auto put = [&out](auto value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
    out << std::string(80, ' ');
    put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
      for (int k = 0; k < 3; ++k) put(0.0f);
      for (const int v : t)
        for (int axis = 0; axis < 3; ++axis) put(static_cast<float>(mesh.points[v][axis] / unit_m));
      put(std::uint16_t{0});
    }
    return;
  }
  const bool ply = kind == ".ply";
  if (ply)
    out << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
        << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.points)
    out << (ply ? "" : "v ") << p.x() / unit_m << " " << p.y() / unit_m << " " << p.z() / unit_m << "\n";
  for (const auto& t : mesh.triangles)
    out << (ply ? "3" : "f") << " " << t[0] + !ply << " " << t[1] + !ply << " " << t[2] + !ply << "\n";
}

}  // namespace vallecula::gui::test

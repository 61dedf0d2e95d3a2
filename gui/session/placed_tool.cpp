#include "gui/session/placed_tool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/mesh/triangle_bvh.h"
#include "gui/session/files.h"
#include "gui/session/ply_file.h"

namespace vallecula::gui {

namespace fs = std::filesystem;
using engine::Mat3;
using engine::TriangleMesh;
using engine::Vec3;

namespace {

constexpr double kShortest = 0.030, kLongest = 0.250;  // m, a laryngoscope's longest side
constexpr double kLeastBlade = 0.020;                  // m, tip to handle
constexpr double kTipOff = 0.003, kHandleOff = 0.015;  // m, off the surface (the handle point may be inside or between)
constexpr double kAheadOfTip = 0.005;                  // m: a blade may bend a little past its tip
constexpr double kBow = 0.2;             // of the blade's length: more than any blade is curved away from its chord
constexpr double kOneSided = 0.5;        // a handle on one side: nearly 1; a ring or two handles: nearly 0
constexpr double kLeastAcross = 0.34;    // sine of 20 degrees: nearer to the blade's axis a direction says no side

std::string mm(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", 1e3 * metres);
  return text;
}

void check_size(const TriangleMesh& mesh, const std::string& name, const std::string& unit) {
  const Extent extent = extent_of(mesh);
  const Vec3 size = extent.high - extent.low;
  const double longest = size.maxCoeff();
  if (longest >= kShortest && longest <= kLongest) return;
  std::string mend = "; is it a laryngoscope?";
  const auto fits = [](double length) { return length >= kShortest && length <= kLongest; };
  if (unit == "m" && fits(1e-3 * longest)) mend = "; its numbers look like millimetres: give --tool-unit mm";
  if (unit == "mm" && fits(1e3 * longest)) mend = "; its numbers look like metres: give --tool-unit m";
  throw std::runtime_error(name + ": is " + mm(size.x()) + " x " + mm(size.y()) + " x " + mm(size.z()) + " read in " +
                           unit + ", a laryngoscope is 30 to 250 mm long" + mend);
}

void check_points(const engine::TriangleBvh& surface, const ToolPlacement& placement, const std::string& unit) {
  const auto off = [&](const Vec3& p) { return std::max(0.0, surface.signed_distance(p, 10.0)); };
  const double blade = (placement.handle - placement.tip).norm();
  if (blade == 0.0) throw std::runtime_error("--tool-tip and --tool-handle are the same point");
  const std::string whose = "; coordinates are the mesh file's, in its unit (" + unit + ")";
  // The tip is a point of the surface, from within too; the handle point may lie in the middle of a solid.
  if (const double d = std::abs(surface.signed_distance(placement.tip, 10.0)); d > kTipOff)
    throw std::runtime_error("--tool-tip lies " + mm(d) + " off the tool's surface, at most " + mm(kTipOff) + whose);
  if (const double d = off(placement.handle); d > kHandleOff)
    throw std::runtime_error("--tool-handle lies " + mm(d) + " off the tool's surface, at most " + mm(kHandleOff) +
                             whose);
  if (blade < kLeastBlade)
    throw std::runtime_error("--tool-tip and --tool-handle are " + mm(blade) + " apart, a blade is longer than " +
                             mm(kLeastBlade) + whose);
  for (const double share : {0.25, 0.5, 0.75})
    if (const double d = off(placement.tip + share * (placement.handle - placement.tip)); d > kBow * blade)
      throw std::runtime_error("the line from --tool-tip to --tool-handle passes " + mm(d) +
                               " off the tool; give the point where the blade meets the handle, not the handle's end");
}

/// How the surface stands out of the axis through `tip` along `x`.
struct Outstanding {
  double farthest = 0.0;    ///< m
  Vec3 way = Vec3::Zero();  ///< mean of offset * distance^2 over the surface, m3; square to the axis
  double one_sided = 0.0;   ///< its length over the mean of distance^3: 1 where all of it lies on one side
};
Outstanding outstanding(const TriangleMesh& mesh, const Vec3& tip, const Vec3& x) {
  Outstanding out;
  const auto across = [&](const Vec3& p) -> Vec3 { return (p - tip) - (p - tip).dot(x) * x; };
  for (const Vec3& p : mesh.points) out.farthest = std::max(out.farthest, across(p).norm());
  double total = 0.0, cubes = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    total += area;
    // The rule of four points is exact for cubics: a handle of two triangles a side is seen as straight as it is.
    const auto add = [&](double weight, const Vec3& p) {
      const Vec3 r = across(p);
      out.way += area * weight * r.squaredNorm() * r;
      cubes += area * weight * r.squaredNorm() * r.norm();
    };
    add(-27.0 / 48, (a + b + c) / 3);
    for (const Vec3& corner : {a, b, c}) add(25.0 / 48, 0.2 * (a + b + c) + 0.4 * corner);
  }
  out.way /= total;
  out.one_sided = out.way.norm() * total / cubes;
  return out;
}

}  // namespace

bool has_handle(const TriangleMesh& tool) {
  return outstanding(tool, Vec3::Zero(), Vec3::UnitX()).farthest >= kHandleStands;
}

PlacedTool place_tool(const TriangleMesh& read, const ToolPlacement& placement, const std::string& name,
                      const std::string& unit) {
  check_size(read, name, unit);
  check_points(engine::TriangleBvh(read), placement, unit);
  PlacedTool tool;
  tool.blade_m = (placement.handle - placement.tip).norm();
  const Vec3 x = (placement.handle - placement.tip) / tool.blade_m;
  double ahead = 0.0;
  for (const Vec3& p : read.points) ahead = std::max(ahead, -(p - placement.tip).dot(x));
  if (ahead > kAheadOfTip)
    throw std::runtime_error(name + ": reaches " + mm(ahead) +
                             " beyond --tool-tip, away from the handle; are tip and handle exchanged?");

  const Outstanding handle = outstanding(read, placement.tip, x);
  tool.handle_m = handle.farthest;
  const bool handle_says = handle.farthest >= kHandleStands && handle.one_sided >= kOneSided;
  Vec3 side = handle.way;
  if (placement.face) {
    side = *placement.face - placement.face->dot(x) * x;
    if (!(side.norm() > kLeastAcross * placement.face->norm()))
      throw std::runtime_error(
          "--tool-face points along the blade; give a direction out of the side that lies on the "
          "tongue, for instance the way the handle stands");
    if (handle_says && side.dot(handle.way) < 0)
      tool.notices.push_back(
          "--tool-face points away from the handle; on a laryngoscope both are on the tongue's side");
  } else if (!handle_says) {
    throw std::runtime_error(name + ": no handle stands out of its blade to one side (its farthest point is " +
                             mm(handle.farthest) +
                             " off the line from tip to handle): say with --tool-face X,Y,Z which way the side that "
                             "lies on the tongue faces");
  }
  const Vec3 z = side.normalized();
  Mat3 axes;
  axes << x, z.cross(x), z;
  tool.surface.triangles = read.triangles;
  for (const Vec3& p : read.points) tool.surface.points.push_back(axes.transpose() * (p - placement.tip));
  return tool;
}

void use_own_tool(const TriangleMesh& tool, engine::SceneDescription& scene) {
  scene.tool.surface = tool;
  scene.tool.tissue_low = Vec3(-0.025, -0.025, -0.025);
  scene.tool.tissue_high = Vec3(0.120, 0.025, 0.020);
}

std::string tool_to_ply(const TriangleMesh& tool) {
  return mesh_to_ply(tool,
                     "Vallecula: a trial's tool in metres, origin at the blade tip, +x to the handle, +z out of the "
                     "tongue side");
}

fs::path own_tool_file(const fs::path& log_file) { return fs::path(log_file).replace_extension(".tool.ply"); }

fs::path tool_file_of_trial(const fs::path& log_file) {
  if (fs::is_directory(log_file)) return log_file / kToolFile;
  const fs::path own = own_tool_file(log_file);
  return fs::exists(own) ? own : log_file.parent_path() / kToolFile;
}

std::optional<TriangleMesh> tool_of_trial(const curricula::LogHeader& header, const fs::path& log_file) {
  if (header.tool_sha256.empty()) return std::nullopt;
  const fs::path file = tool_file_of_trial(log_file);
  if (!fs::exists(file))
    throw std::runtime_error(file.string() +
                             ": is missing: the tool of its own that this trial was done with; put it back beside the "
                             "log");
  const std::string bytes = read_file(file), hash = sha256_of_bytes(bytes);
  if (hash != header.tool_sha256)
    throw std::runtime_error(file.string() + ": is not the tool of this trial (sha256 " + hash.substr(0, 12) +
                             ", recorded " + header.tool_sha256.substr(0, 12) + "); put the right one back");
  return mesh_from_ply(bytes);
}

}  // namespace vallecula::gui

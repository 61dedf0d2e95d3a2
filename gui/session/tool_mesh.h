// A tool's surface from a mesh file (a scan, a CAD model), for trials and for the laboratory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/types.h"

namespace vallecula::gui {

struct ToolMesh {
  engine::TriangleMesh surface;      ///< m, in the file's own frame; closed, normals out of the solid
  std::vector<std::string> notices;  ///< what was mended (parts that were wound inside out), one sentence each
};

/// Reads .stl, .obj or .ply (any case); `unit_m`: metres per unit of the file, `unit_option`: the option that sets it,
/// for messages. Corners that coincide exactly become one. Throws std::runtime_error that names the file: of no known
/// kind, unreadable, no triangles, a point that is not finite or more than 1 m away, not closed, triangles that are not
/// turned alike, no volume.
ToolMesh read_tool_mesh(const std::filesystem::path& file, double unit_m, const std::string& unit_option);

/// A scan has more triangles than a tick has time for: each is looked at for the line of sight. Above `most` triangles
/// the surface is reduced to as few as that, or twice, four times as many, where it would open or move by 0.2 mm
/// otherwise; a notice says by how much it moved, or that it was left as it is.
constexpr std::size_t kMostToolTriangles = 20'000;
void reduce_tool_mesh(ToolMesh& tool, const std::filesystem::path& file, std::size_t most = kMostToolTriangles);

/// Volume of a closed surface, m3; negative when its triangles face inwards.
double enclosed_volume(const engine::TriangleMesh& mesh);

/// Corners of the axis-parallel box around the surface, m.
struct Extent {
  engine::Vec3 low, high;
};
Extent extent_of(const engine::TriangleMesh& mesh);

}  // namespace vallecula::gui

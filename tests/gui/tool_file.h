// Tools of known shape, and the files that a scanner or a CAD program would write of them.
#pragma once

#include <filesystem>

#include "engine/types.h"

namespace vallecula::gui::test {

/// In the tool frame, m: a blade of 10 x 2 mm from the tip at the origin along +x (its middle plane at z = 0), and a
/// handle of 16 x 10 mm on its heel up to z = `height`, two overlapping parts.
engine::TriangleMesh laryngoscope(double blade, double height);
/// Columns x, z cross x, z; z made square to x.
engine::Mat3 axes(const engine::Vec3& x, const engine::Vec3& z);
/// From the tool frame to one with these axes and origin.
engine::TriangleMesh moved(engine::TriangleMesh mesh, const engine::Mat3& axes, const engine::Vec3& origin);
void join(engine::TriangleMesh& mesh, const engine::TriangleMesh& other);
/// .stl (binary), .obj or .ply by the name's ending; coordinates in units of `unit_m`.
void write_tool_file(const std::filesystem::path& file, const engine::TriangleMesh& mesh, double unit_m);

}  // namespace vallecula::gui::test

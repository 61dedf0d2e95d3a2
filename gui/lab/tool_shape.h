// The laboratory's tools: boxes, paddles, spheres and any closed triangle mesh from a file.
#pragma once

#include <string>

#include "gui/session/tool_mesh.h"

namespace vallecula::gui {

/// `box:LxWxH` or `paddle:LxWxH` (along x, y, z), `sphere:R` (all in metres, centred at the pose), or a file .stl, .obj
/// or .ply whose origin is the pose; `unit_m`: metres per unit of a file. Throws std::invalid_argument on a malformed
/// word, std::runtime_error as read_tool_mesh() does.
ToolMesh tool_shape(const std::string& what, double unit_m);

}  // namespace vallecula::gui

// The laboratory's tools: boxes, spheres and any closed triangle mesh from a file.
#pragma once

#include <string>

#include "engine/types.h"

namespace vallecula::gui {

/// `box:LxWxH` (along x, y, z), `sphere:R` (both in metres, centred at the pose), or a file .stl, .obj or .ply whose
/// origin is the pose; `unit_m`: metres per unit of a file. Throws std::invalid_argument on a malformed word,
/// std::runtime_error naming the file: not readable, no triangles, not closed (how many edges are open).
engine::TriangleMesh tool_shape(const std::string& what, double unit_m);

}  // namespace vallecula::gui

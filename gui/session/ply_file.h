// PLY, the scanners' mesh format: text and binary of both byte orders. VTK's own reader ends the program on a file that
// is cut off or names points it does not have.
#pragma once

#include <string>

#include "engine/types.h"

namespace vallecula::gui {

/// The points (`x`, `y`, `z` of element `vertex`, every bit of doubles kept) and faces (`vertex_indices` or
/// `vertex_index` of element `face`, polygons fanned out from their first corner) of a PLY file's bytes; everything
/// else in it is passed over. In the file's unit. Throws std::runtime_error that says what is wrong, without the file's
/// name.
engine::TriangleMesh mesh_from_ply(const std::string& bytes);

/// Binary, little-endian, double precision; `comment` is one line.
std::string mesh_to_ply(const engine::TriangleMesh& mesh, const std::string& comment);

}  // namespace vallecula::gui

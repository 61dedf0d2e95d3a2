// Soft bodies of the laboratory from files: TetGen's .node and .ele, or a VTK .vtu of tetrahedra.
#pragma once

#include <filesystem>
#include <string>

#include "engine/scene.h"

namespace vallecula::gui {

/// Reads nodes and tetrahedra; one material (index 0) and one fixed body (index 0) to anchor nodes to, nothing anchored
/// yet. `unit_m`: metres per file unit. TetGen's numbering may begin at 0 or 1; either of the two files may be named.
/// Tetrahedra listed with the other handedness throughout (as some writers do) are turned; a mesh of both kinds holds
/// inverted ones and is refused. Throws std::runtime_error naming file, line or tetrahedron and what is wrong: a file
/// that cannot be read, numbers that are not finite, indices out of range, flat or inverted tetrahedra, parts that are
/// not joined.
struct SoftBodyFile {
  engine::SoftBodyDescription soft;
  int first_number = 0;  ///< the file's number of the first node
};
SoftBodyFile read_soft_body(const std::filesystem::path& file, double unit_m);

/// Anchors nodes by a rule 'x|y|z < or > VALUE' (m), for instance 'z<-0.003'. Throws std::invalid_argument on another
/// form, or when no node or every node is meant.
void fix_nodes_by_rule(engine::SoftBodyDescription& soft, const std::string& rule);

/// Anchors the nodes a file lists, one number a line (the file's numbering). Throws std::runtime_error naming the line.
void fix_nodes_by_file(SoftBodyFile& body, const std::filesystem::path& file);

/// Writes nodes (m) and tetrahedra as .vtu, whole or not at all.
void write_soft_body(const std::filesystem::path& file, const std::vector<engine::Vec3>& nodes,
                     const std::vector<std::array<int, 4>>& tets);

}  // namespace vallecula::gui

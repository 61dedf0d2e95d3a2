// Surfaces and tetrahedra of a package as VTK XML files (millimetres, LPS: both said in the files' field data).
#pragma once

#include <filesystem>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

void write_surface(const Surface& surface, const std::filesystem::path& file);
/// Arrays `tissue` (per cell), `anchor` and `contact` (per point), their values' names and the materials by tissue in the
/// field data.
void write_tet_mesh(const TetMesh& mesh, const std::map<std::string, Material>& materials,
                    const std::filesystem::path& file);

/// Both check what they read: finite points, indices in range, arrays of the right length, positively oriented
/// tetrahedra. Throw PackageError naming the file.
Surface read_surface(const std::filesystem::path& file);
TetMesh read_tet_mesh(const std::filesystem::path& file);

}  // namespace vallecula::pipeline

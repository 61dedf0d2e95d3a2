// Surfaces for other programs: binary STL, millimetres, LPS.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// The border of the tetrahedra, outwards.
Surface border_of(const TetMesh& mesh);

/// One file a surface of the package, and tongue.stl (with the epiglottis), each written aside and renamed. Returns the
/// files' names. The header says LPS as 3D Slicer does and nothing of the patient. Throws PackageError.
std::vector<std::string> write_stl_files(const PatientPackage& package, const std::filesystem::path& folder);

}  // namespace vallecula::pipeline

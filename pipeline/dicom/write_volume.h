// A volume as read, as one NRRD file: its own directions, its own HU.
#pragma once

#include <filesystem>

#include "pipeline/dicom/ct_volume.h"

namespace vallecula::pipeline {

/// int16, raw, LPS; written aside and renamed. Nothing but geometry and voxels goes into it. Throws std::runtime_error.
void write_volume(const CtVolume& volume, const std::filesystem::path& file);

}  // namespace vallecula::pipeline

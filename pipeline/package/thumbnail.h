// The small picture by which a package is recognised in a list: its label map, cut in the middle.
#pragma once

#include <filesystem>

#include "pipeline/volume.h"

namespace vallecula::pipeline {

/// A mid-sagittal cut in the labels' colours, face to the left, as PNG of 320 x 320 pixels. It is drawn from labels,
/// never from grey values or the rendered face, because a patient can be known by either. Throws std::runtime_error
/// when the file cannot be written.
void write_thumbnail(const Labels& labels, double mid_x_mm, const std::filesystem::path& file);

}  // namespace vallecula::pipeline

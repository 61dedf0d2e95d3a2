// What each triangle of the face is: skin, lip, gum, palate, mucosa or larynx.
#pragma once

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// One Tissue a triangle, by what lies before it (airway, outer air, tongue), by the bone behind it and by the place;
/// single triangles among others are taken along with their neighbours.
std::vector<std::uint8_t> face_tissue(const Surface& face, const Segmentation& s);

/// Moves the points on a border between two tissues along `reference` until the border runs smoothly (the red of the
/// lips has no teeth).
void smooth_tissue_borders(Surface& face, const Surface& reference, int rounds);

}  // namespace vallecula::pipeline

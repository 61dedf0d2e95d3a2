// Label maps made elsewhere, put together on the scan's grid structure by structure.
#pragma once

#include "gui/import/edit_history.h"
#include "pipeline/volume.h"

namespace vallecula::gui {

/// `before` with what `map` (on the scan's grid) says of these labels in the place of what was given earlier. Throws
/// std::runtime_error when the map has none of `wanted`; an empty `wanted` means all that are in it.
EditState with_given_labels(const EditState& before, const pipeline::Labels& map, const std::set<std::uint8_t>& wanted);

}  // namespace vallecula::gui

// Grey values and labels of the scan carried along by the sheets, onto a grid of the same voxels.
#pragma once

#include "pipeline/pose/sheets.h"

namespace vallecula::pipeline {

struct Carried {
  Hounsfield hu;
  Labels labels;          ///< of what was carried; what opened between the sheets is background
  Mask opened;            ///< air that was not in the scan: between tongue and palate, between the lips
  double overlap_mm3 = 0.0;  ///< tissue that two sheets brought to the same place (the lower sheet and the jaw have it)
};

/// The jaw is carried by its own turn, so that it stays rigid beside the skull; where it leaves its place there, soft
/// tissue is left.
Carried carry(const Segmentation& s, const Aim& aim, const Parts& parts, const Sheets& sheets);

}  // namespace vallecula::pipeline

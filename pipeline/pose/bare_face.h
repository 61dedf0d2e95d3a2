// Takes off what touches the face in front of closed lips and is none of it: the strips of a mask.
#pragma once

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Returns how much was taken off, mm3. Nothing is touched when the mouth is open.
double bare_face(Segmentation& s);

}  // namespace vallecula::pipeline

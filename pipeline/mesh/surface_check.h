// What a surface must be before it is shown, cut or filled with tetrahedra.
#pragma once

#include <string>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

struct SurfaceFacts {
  bool finite = true;
  bool closed = true;       ///< every edge has two triangles that run it in opposite senses
  bool manifold = true;     ///< and the triangles around every point are one fan
  int parts = 0;            ///< connected pieces
  double volume_mm3 = 0.0;  ///< signed: positive when the triangles look outwards
  double area_mm2 = 0.0;
  double smallest_angle_deg = 180.0;
  std::string fault;  ///< the first fault in words, empty when there is none
};

SurfaceFacts facts_of(const Surface& surface);

struct SurfaceSize {
  double volume_mm3 = 0.0;  ///< signed, as above
  double area_mm2 = 0.0;
};

/// These two alone, without looking at how the triangles hang together.
SurfaceSize size_of(const Surface& surface);

/// Throws std::runtime_error naming `what` and the fault, unless the surface is finite, closed, manifold, not flat and
/// looks outwards.
void require_solid(const Surface& surface, const std::string& what);

/// Only the piece with the largest volume.
Surface largest_part(const Surface& surface);

}  // namespace vallecula::pipeline

// What a Manikin holds: its shapes at term scale and how they are scaled.
#pragma once

#include "pipeline/manikin/body.h"
#include "pipeline/manikin/manikin.h"

namespace vallecula::pipeline {

struct Manikin::Data {
  Data(double weight_kg, const manikin::Variation& variation);
  /// From patient millimetres to the shapes' term scale.
  manikin::Vec inside(const Point& p) const { return {p[0] / scale, p[1] / scale, p[2] / scale}; }

  /// Where a point of the shapes comes to lie in the patient, mm.
  Point placed(const manikin::Vec& p) const {
    const manikin::Vec q = manikin::with_larynx(body.variation(), p);
    return {scale * q.x, scale * q.y, scale * q.z};
  }

  double scale = 1.0;
  manikin::Body body;
  manikin::Vec eye;  ///< the operator's, at term scale
};

}  // namespace vallecula::pipeline

// A patient whose airway is known everywhere: the block's, with a tube of ellipses along an arc for its airway. Small
// enough to be stepped and replayed within seconds.
#pragma once

#include <filesystem>

#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui::test {

/// An airway along an arc in the middle plane; its half axes are those of ANATOMY's larynx and trachea. mm, LPS; `s` mm
/// along its axis from the cords.
struct ArcAirway {
  static constexpr double kRadius = 150.0, kAbove = 4.0;
  engine::Vec3 at(double s) const;
  engine::Vec3 along(double s) const;
  engine::Vec3 front(double s) const;
  double half_left(double s) const;
  double half_front(double s) const;

  /// At term size; the airway's surface reaches down to `end`, its carina is at `carina`.
  pipeline::PatientPackage patient(double end = 51.0, double carina = 50.0) const;
};

/// Writes it as FOLDER/arc.patient and returns that path.
std::filesystem::path write_arc_patient(const std::filesystem::path& folder);

/// FOLDER/tube.yaml with one scenario, "tube": a 3.5 without stylet.
std::filesystem::path write_tube_curriculum(const std::filesystem::path& folder);

}  // namespace vallecula::gui::test

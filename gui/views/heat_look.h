// Where the blade pressed on tongue and epiglottis, and how hard, as colour over their surface.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "engine/snapshot.h"
#include "gui/session/soft_boundary.h"

namespace vallecula::gui {

/// Pale yellow through vermillion to dark violet, told apart by lightness alone as well; clear below a hundredth of the
/// scale. `share`: of the scale, 0..1.
std::array<unsigned char, 4> heat_colour(double share);
/// The scale's end, the same in every trial so that two of them can be compared; what is above has its colour. The
/// scripted expert presses with at most 8 kPa on the 1.2 kg manikin and 11 on the 3.2 kg one, the scripted novice with
/// 18 and 51.
constexpr double kHeatTopKpa = 20.0;

class HeatLook {
 public:
  explicit HeatLook(const SoftBoundary& boundary);
  const vtkSmartPointer<vtkActor>& actor() const { return actor_; }
  /// `kpa`: by boundary point.
  void show(const engine::Snapshot& snapshot, const std::vector<float>& kpa);

 private:
  const SoftBoundary boundary_;
  vtkSmartPointer<vtkPolyData> surface_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace vallecula::gui

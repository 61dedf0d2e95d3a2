// A fine surface of tongue and epiglottis that rides on the coarse tetrahedra: where it lies at rest is what was
// segmented, and every point goes along with the tetrahedron it lies in.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// Where a point lies in the tetrahedra: the four nodes of one and their shares, which sum to 1; of a point outside the
/// one it is least outside of, with shares below 0. Linear: any affine motion of the nodes moves it exactly so.
struct TetTie {
  std::array<int, 4> nodes{};
  std::array<float, 4> shares{};
};
std::vector<TetTie> tie_to_tets(const pipeline::TetMesh& mesh, const std::vector<pipeline::Point>& points_mm);

/// The segmented tongue and epiglottis, closed and outward, in the package's frame; nothing where the tetrahedra were
/// not made from where these labels lie (a mouth that was opened, a head that was bent after the scan, other labels):
/// the mean node of the mesh's border is then further than kFits from it.
std::optional<pipeline::Surface> segmented_tongue(const pipeline::PatientPackage& package,
                                                  const pipeline::Labels& labels);
constexpr double kFitsMm = 0.5;

}  // namespace vallecula::gui

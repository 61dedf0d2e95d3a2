// Fills a closed surface with tetrahedra: TetGen, in a helper process.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// What went wrong with the mesh generator or its input; the calling program is unharmed.
class TetrahedralizeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TetrahedralizeOptions {
  /// Wanted edge length inside, mm; inner points are laid accordingly. Empty: only the surface's points.
  std::function<double(const Point&)> edge_mm;
  int time_limit_s = 60;
  std::size_t memory_limit_bytes = std::size_t{2} << 30;
  std::filesystem::path helper;  ///< empty: see find_tetgen_helper
};

/// $VALLECULA_HELPERS, else beside the running program, else ../lib/vallecula beside it. Throws TetrahedralizeError
/// when it is in none.
std::filesystem::path find_tetgen_helper();

/// The surface's points stay where they are and come first in the result, in order; `tissue` is 0 and `anchor` free
/// throughout. Checks before (finite, closed, manifold, not flat) and after (tetrahedra there, positive, volume that of
/// the surface). The surface may still cross itself: then the helper says so. Throws TetrahedralizeError.
TetMesh tetrahedralized(const Surface& surface, const TetrahedralizeOptions& options);

}  // namespace vallecula::pipeline

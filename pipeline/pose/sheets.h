// The displacement of everything: smooth between what is rigid, in two sheets where tissue is parted.
#pragma once

#include "pipeline/pose/parts.h"

namespace vallecula::pipeline {

enum Sheet : int { kUpper = 0, kLower = 1 };

/// A lattice coarser than the scan. Each node has one displacement, or two (one a sheet) beside a cut. Between the nodes
/// each cell is six tetrahedra with linear displacement, so that the map is continuous and its Jacobian is exact.
/// The displacements are those of a net of springs (harmonic where the tissue is uniform).
class Sheets {
 public:
  Sheets(const Parts& parts, const Aim& aim, double scale);

  const Grid& lattice() const { return lattice_; }
  /// How much of a cell is tissue, or air, of the sheet, 0..1. Cells are counted by their lowest node.
  double content(Sheet sheet, std::size_t node) const { return content_[sheet][node] / 8.0; }
  bool slides(std::size_t node) const;  ///< the cell of this lowest node reaches from jaw to skull
  Vector3 displacement(Sheet sheet, std::size_t node) const;
  Vector3 moved(Sheet sheet, const Vector3& p) const;

  /// Of all tetrahedra that hold any of their sheet: smallest volume over volume at rest. Left out are the cells that
  /// reach from jaw to skull (joints, teeth, the gap beside the coronoid): there tissue slides, which no lattice shows.
  double smallest_jacobian() const;
  /// Of tissue in those tetrahedra that are turned inside out, mm3.
  double folded_mm3() const;
  /// What the tongue and lower lip's volume becomes over what it was.
  double lower_volume_ratio() const;

 private:
  struct Level;
  void keep_volume(Level& coarse, Level& fine);
  Grid lattice_;
  std::array<std::vector<std::uint8_t>, 2> content_;
  std::vector<std::uint8_t> split_;
  std::vector<std::uint8_t> tie_;
  std::array<std::array<std::vector<float>, 3>, 2> shift_;
};

/// The six tetrahedra of a cell: numbers of its corners (bit 0: x, bit 1: y, bit 2: z), positively oriented.
constexpr int kCellTets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

}  // namespace vallecula::pipeline

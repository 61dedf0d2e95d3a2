// A person's edits at work: on the cropped grid of the segmentation, asked by each structure in its turn.
#pragma once

#include <optional>

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

class Given {
 public:
  /// `edits` in the frame of `grid`, checked. Throws EditError.
  Given(const Edits& edits, const Grid& grid);

  bool any() const { return !edits_.replaced.empty(); }
  bool replaces(std::uint8_t label) const { return edits_.replaced.count(label) != 0; }
  /// The voxels of a replaced structure.
  Mask mask(std::uint8_t label) const;
  /// Those of every replaced structure but skin, which is what is left over.
  Mask claimed() const;
  std::optional<Vector3> seed(const char* name) const;
  std::optional<std::array<double, 2>> threshold(const char* name) const;
  std::optional<Vector3> landmark(const char* name) const;
  const Edits& edits() const { return edits_; }

  /// Tissue and air as the label map has them: a given airway is air, other given structures are tissue, whatever their
  /// grey values; a given skin bounds the head.
  void put_into(Head& head, const Hounsfield& hu, double air) const;
  void put_into(Bones& bones, const Hounsfield& hu, const Thresholds& usual) const;
  /// Of what was found: not what another given structure claims, and within the thresholds given (`hu` on the same
  /// grid; tissue is smoothed first, or noise would riddle it); of several pieces the one with the seed, else the
  /// largest.
  void trim(const char* name, const Hounsfield& hu, const Mask& claimed, double scale, Mask& found) const;
  /// Each given structure exactly as given; where one was found beyond it, what is left over.
  void put_into(Labels& labels, const Mask& inside) const;
  /// Says of each structure and landmark that was given what was.
  void name_origins(std::map<std::string, Finding>& findings) const;

 private:
  Edits edits_;
  Labels map_;  ///< of the label map what is replaced, on the grid; empty without one
};

/// The bone's threshold when structures have their own: the lowest of all.
double lowest_bone(const Edits& edits, double usual);
/// The thresholds with those given for air and skin.
Thresholds with_given(Thresholds thresholds, const Edits& edits);

/// The box of the label map's voxels in `grid`, for a given structure that reaches beyond what was found.
Box box_of_given(const Edits& edits, const Grid& grid);
Box united(const Box& a, const Box& b);

}  // namespace vallecula::pipeline

// The moments of a laryngoscopy, and of the intubation that follows, worth a picture: found in the snapshots as they pass
// by.
#pragma once

#include <string>
#include <vector>

#include "engine/snapshot.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

class KeyMoments {
 public:
  /// Landmarks of the package (mm, LPS); `sight_percent`: the glottis counts as in sight from here on.
  KeyMoments(const pipeline::PatientPackage& package, double sight_percent);
  /// Names of the moments that this snapshot is the (new, better) picture of; in order "1-lips", "2-sweep",
  /// "3-vallecula", "4-first-sight", "5-best-sight", "6-withdrawal". "5-best-sight" comes again whenever clearly more
  /// of the glottis is seen; the others come once. With an intubation "6-tip-at-cords", "7-between-cords" (again whenever
  /// the tube is clearly deeper, as long as the blade is in), "8-withdrawal" and "9-detector-yellow" follow.
  std::vector<std::string> at(const engine::Snapshot& snapshot);
  /// How far the tip is on the way from between the gums (0) to the glottis (1); below 0 it is outside.
  double depth(const engine::Snapshot& snapshot) const;

 private:
  engine::Vec3 mouth_, glottis_, vallecula_;  // m
  double sight_ = 0.25, best_ = 0.0, reach_m_ = 0.006, deepest_m_ = 0.0;
  bool lips_ = false, sweep_ = false, vallecula_reached_ = false, seen_ = false, out_ = false;
  bool tip_at_cords_ = false, yellow_ = false;
};

}  // namespace vallecula::gui

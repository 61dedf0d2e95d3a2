// What of the larynx and throat changes by itself in an intubation: the vocal cords, which open, close and lie close
// to what is between them, and the secretions' surface.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>

#include <array>

#include "engine/snapshot.h"
#include "engine/tube/intubation.h"

namespace vallecula::gui {

/// Where the cut across the airway that has this part is in a snapshot: at rest, plus its share of the larynx' way. m.
engine::Vec3 shift_of(const engine::AirwayCourse& course, const engine::AirwayRing& ring,
                      const engine::Snapshot& snapshot);

class CordsLook {
 public:
  explicit CordsLook(const engine::IntubationDescription& intubation);
  void update(const engine::Snapshot& snapshot);
  vtkActor* actor() const { return actor_; }
  /// Between the free edges, m, as drawn by the last update: [row from the front][0 left, 1 right] distance from the
  /// midline.
  static constexpr int kRows = 17;
  const std::array<std::array<double, 2>, kRows>& free_edges() const { return edges_; }

 private:
  engine::AirwayCourse course_;
  engine::AirwayRing ring_;
  engine::Glottis glottis_;
  double tube_radius_, catheter_radius_;
  std::array<std::array<double, 2>, kRows> edges_{};
  vtkSmartPointer<vtkPolyData> surface_;
  vtkSmartPointer<vtkActor> actor_;
};

class SecretionsLook {
 public:
  explicit SecretionsLook(const engine::Secretions& secretions);
  void update(const engine::Snapshot& snapshot);
  vtkActor* actor() const { return actor_; }

 private:
  engine::Secretions secretions_;
  vtkSmartPointer<vtkActor> actor_;
};

}  // namespace vallecula::gui

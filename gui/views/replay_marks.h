// What a debrief draws into a view beside the trial itself: forces where the blade touches, and the way of its tip.
// Always seen, whatever lies before them.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "engine/snapshot.h"
#include "gui/session/replay_trial.h"

namespace vallecula::gui {

constexpr double kArrowMmPerNewton = 5.0;

/// Colour of a tip's way by the tongue's force then: sky below half the target, yellow up to it, vermillion over it.
std::array<unsigned char, 3> path_colour(double tongue_n, double target_n);

class ReplayMarks {
 public:
  ReplayMarks();
  std::vector<vtkSmartPointer<vtkProp>> props() const;
  /// `target_n`: the tongue's training target, which the path's colours go by.
  void set_paths(const TipPath& trial, const TipPath& expert, double target_n);
  /// Arrows of the blade's push on the tissue, kArrowMmPerNewton, from the contact on; the path up to the snapshot's
  /// time.
  void show(const engine::Snapshot& snapshot);
  void show_arrows(bool on);
  void show_path(bool on);
  void show_expert(bool on);
  int arrows_shown() const;
  std::size_t path_points_shown() const { return path_->GetVisibility() != 0 ? path_points_ : 0; }

 private:
  void place_arrows();
  void show_path_until(double time_s);

  std::array<vtkSmartPointer<vtkActor>, engine::kLoadedStructures> arrows_;
  std::array<engine::StructureLoad, engine::kLoadedStructures> loads_{};
  std::vector<double> path_time_s_;
  vtkSmartPointer<vtkPolyData> path_data_, expert_data_;
  vtkSmartPointer<vtkActor> path_, expert_;
  std::size_t path_points_ = 0;
  double now_s_ = 0.0;
  bool with_arrows_ = true;
};

}  // namespace vallecula::gui

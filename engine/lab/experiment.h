// The laboratory's run: one soft body and one tool along one trajectory, without hand, rigid anatomy or gravity. What a
// run gives are figures; files, options and plots are the application's.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "engine/scene.h"
#include "engine/stage_clock.h"

namespace vallecula::engine {

struct ExperimentSettings {
  double duration_s = 0.0;
  double force_limit_n = std::numeric_limits<double>::infinity();  ///< the device's; infinity: none
  double limit_time_s = 0.5;      ///< held for longer than this the device counts as lost
  double force_rate_n_s = 400.0;  ///< bound on the displayed force's change at transitions
  bool realtime = false;          ///< a step each `step_s` by the clock; else as fast as it goes
  bool measure_tissue = true;     ///< penetration, volume and inversion after every step (not part of its time)
};

/// One step. Lengths m, forces N, torques N m about the tool's origin, world axes.
struct ExperimentStep {
  double time_s = 0.0;
  double step_s = 0.0;         ///< work of the whole tick, pose in, force out: processor time of its thread
  double elapsed_s = 0.0;      ///< the same by the clock, as the stages' times are
  double late_s = 0.0;         ///< real time: force out after it was due, beyond one period
  StageTimes stages;
  int contacts = 0;            ///< that carry force
  double area_m2 = 0.0;        ///< of the tissue's surface that they stand for (contact/contact_area.h)
  int solver_iterations = 0;
  Vec3 force_n = Vec3::Zero();     ///< displayed: on the tool by the tissue
  Vec3 torque_nm = Vec3::Zero();   ///< of the model: devices of three forces display none
  Vec3 model_force_n = Vec3::Zero();
  HapticState state = HapticState::tracking;
  Vec3 proxy_m = Vec3::Zero();
  Quat proxy_rotation = Quat::Identity();
  double stiffness_n_m = 0.0;  ///< of the contact, as felt over the last steps
  double volume_change = 0.0;  ///< of the whole body, relative, signed
  int inverted = 0;            ///< tetrahedra of negative volume
  double penetration_m = 0.0;  ///< of the deepest surface point inside the tool
  double vertex_penetration_m = 0.0;  ///< of the deepest vertex of the surface
  bool finite = true;
};

struct ExperimentResult {
  std::vector<ExperimentStep> steps;
  std::vector<Vec3> final_nodes;   ///< m
  double residual_m = 0.0;         ///< largest node displacement from rest after the last step
  bool finite = true;              ///< false: the run diverged and was ended there
  double time_limited_s = 0.0, time_lost_s = 0.0;
  bool limit_entered = false;
  double achieved_hz = 0.0;        ///< real time
  std::int64_t deadline_misses = 0;  ///< steps whose force was written more than 1 ms after it was due
};

/// Runs `scene` with the tool at pose(t) for t = 0, h, 2h, ... to the duration. `each` (may be empty) is called after
/// every step with the node positions, outside of the measured time.
ExperimentResult run_experiment(const Scene& scene, const std::function<Pose(double)>& pose,
                                const ExperimentSettings& settings,
                                const std::function<void(const ExperimentStep&, const std::vector<Vec3>&)>& each = {});

}  // namespace vallecula::engine

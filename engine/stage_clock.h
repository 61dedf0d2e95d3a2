// Where a tick's time goes. Reading this clock costs some 20 ns (a thread's own some 2 us); the figures are measurements, never
// part of a state.
#pragma once

#include <ctime>

namespace vallecula::engine {

/// Seconds spent in the stages of one step.
struct StageTimes {
  double collision_s = 0.0;   ///< finding the contacts
  double response_s = 0.0;    ///< choosing the active ones, corrections, forces
  double elasticity_s = 0.0;  ///< elastic forces and the stiffness
  double solve_s = 0.0;       ///< the linear solver
};

inline double monotonic_seconds() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// What this thread has worked, without what others took from it: on a shared machine the only time that is its own.
inline double thread_seconds() noexcept {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Adds the time since the last call to one stage after another.
class StageClock {
 public:
  StageClock() noexcept : last_(monotonic_seconds()) {}
  void add_to(double& stage) noexcept {
    const double now = monotonic_seconds();
    stage += now - last_;
    last_ = now;
  }

 private:
  double last_;
};

}  // namespace vallecula::engine

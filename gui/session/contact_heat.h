// How hard the blade pressed on which part of tongue and epiglottis, moment by moment of a replay: a contact's force over
// the surface that lies against the blade then.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "engine/contact/signed_distance_grid.h"
#include "engine/snapshot.h"
#include "gui/session/replay_film.h"
#include "gui/session/soft_boundary.h"

namespace vallecula::gui {

/// The tissue's surface and the tool it may touch. A simplification: the log has one force for each structure, so each
/// point that touches bears the same pressure; and a point touches that is nearer than kTouch_m, for the engine's own
/// contact stands off a little.
class ContactPressure {
 public:
  static constexpr double kTouch_m = 0.0006;

  struct At {
    int point;  ///< of the boundary
    float kpa;
  };

  /// `tool` in its own frame, m, closed. Throws std::invalid_argument where it is not.
  ContactPressure(const pipeline::TetMesh& mesh, const engine::ToolDescription& tool);
  const SoftBoundary& boundary() const { return boundary_; }
  /// Where the blade presses in this snapshot, and how hard. Where a force is told but nothing lies against the blade,
  /// the point that is nearest to the force's place bears it.
  std::vector<At> in(const engine::Snapshot& snapshot) const;
  /// Surface at rest that a boundary point stands for, m2.
  double area_m2(int point) const { return area_m2_[static_cast<std::size_t>(point)]; }

 private:
  SoftBoundary boundary_;
  std::vector<double> area_m2_;
  std::vector<char> epiglottis_;  ///< by boundary point
  engine::SignedDistanceGrid blade_;
};

/// The same for all frames of a film, found on a thread of its own as they are computed.
class ContactHeat {
 public:
  /// `film` outlives it.
  ContactHeat(const ReplayFilm& film, const pipeline::TetMesh& mesh, const engine::ToolDescription& tool);
  ~ContactHeat();
  ContactHeat(const ContactHeat&) = delete;
  ContactHeat& operator=(const ContactHeat&) = delete;

  const SoftBoundary& boundary() const { return pressure_.boundary(); }
  std::size_t computed() const { return computed_.load(std::memory_order_acquire); }  ///< frames
  /// Largest pressure (kPa) on each boundary point from the trial's beginning up to this frame, as far as it is computed.
  /// One thread only.
  const std::vector<float>& peaks_until(std::size_t frame);
  /// Of all that is computed so far, kPa.
  float highest_kpa() const { return highest_.load(std::memory_order_relaxed); }

 private:
  void compute();

  const ReplayFilm& film_;
  ContactPressure pressure_;
  std::vector<std::vector<ContactPressure::At>> frames_;
  std::vector<float> peaks_;
  std::size_t peaks_of_ = 0;  ///< frames that are in peaks_
  std::atomic<std::size_t> computed_{0};
  std::atomic<float> highest_{0.0f};
  std::atomic<bool> stop_{false};
  std::thread worker_;
};

}  // namespace vallecula::gui

// A recorded trial opened for the window: its log, score, events, patient and film.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "curricula/score/points.h"
#include "engine/scene.h"
#include "gui/session/contact_heat.h"
#include "gui/session/peaks_so_far.h"
#include "gui/session/replay_events.h"
#include "gui/views/patient_look.h"

namespace vallecula::gui {

/// The way of a blade's tip.
struct TipPath {
  std::vector<double> time_s;
  std::vector<std::array<float, 3>> tip_mm;  ///< patient LPS
  std::vector<float> tongue_n;               ///< model force on the tongue; empty: nobody knows it
};

constexpr std::size_t kPeaksEvery = 10;

struct ReplayTrial {
  std::filesystem::path log_file;
  std::shared_ptr<const curricula::TrialLog> log;
  curricula::Scenario scenario;
  curricula::Score score;
  std::vector<curricula::MarkPoints> points;
  std::vector<ReplayEvent> events;
  engine::SceneDescription scene;
  std::vector<std::string> notices;  ///< another build, other kernels
  std::shared_ptr<PatientLook> look;
  TipPath path, expert_path;          ///< the scripted expert's on this patient; empty: it has no plan for it
  std::vector<PeaksSoFar> peaks;      ///< at the end of each kPeaksEvery ticks
  std::unique_ptr<ReplayFilm> film;   ///< computing since it was opened
  std::unique_ptr<ContactHeat> heat;  ///< of the film, likewise

  double end_s() const { return log->ticks.back().time_s; }
  const curricula::LogTick& tick_at(double time_s) const;
};

/// Why this trial is not replayed in the window, for a person (an instructor may see any); empty: it is.
std::string replay_refusal(const curricula::Scenario& scenario, bool instructor = false);

/// Everything a replay needs, and the film begun. `patient`: where the package is now, if it was moved. `progress` may
/// throw to leave. Throws std::runtime_error with one message: the package is missing or another, the log is damaged.
std::shared_ptr<ReplayTrial> open_replay(const std::filesystem::path& trial, const std::filesystem::path& patient,
                                         const std::function<void(const std::string&, double)>& progress,
                                         bool instructor = false);

}  // namespace vallecula::gui

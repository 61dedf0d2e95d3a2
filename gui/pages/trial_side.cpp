#include "gui/pages/trial_side.h"

#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>
#include <array>
#include <map>
#include <string>

#include "gui/views/force_bars.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/trial_readings.h"

namespace vallecula::gui {
namespace {

constexpr int kSagittalMs = 140, kRestMs = 500;

double load(const engine::Snapshot& snapshot, engine::Structure structure) {
  return snapshot.loads[static_cast<std::size_t>(structure)].force_n.norm();
}

}  // namespace

TrialSide::TrialSide(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* caption = new QLabel("Mid-sagittal cut", this);
  caption->setObjectName("heading");
  sagittal_view_ = new SagittalView(this);
  sagittal_view_->setMinimumSize(320, 280);
  bars_ = new ForceBars(this);
  auto* bars_panel = new QFrame(this);
  bars_panel->setObjectName("panel");
  (new QVBoxLayout(bars_panel))->addWidget(bars_);
  auto* readings_panel = new QFrame(this);
  readings_panel->setObjectName("panel");
  readings_ = new TrialReadings(readings_panel);
  auto* inside = new QVBoxLayout(readings_panel);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addWidget(readings_);
  column->addWidget(caption);
  column->addWidget(sagittal_view_, 1);
  column->addWidget(bars_panel);
  column->addWidget(readings_panel);
}

void TrialSide::open(const TrialSession& session, const std::shared_ptr<PatientLook>& look) {
  const auto& scenario = session.scenario();
  const auto& scene = session.scene();
  sagittal_view_->show_patient(look, scene.tool.surface, scene.intubation ? &*scene.intubation : nullptr);
  bars_->set_marks({scenario.targets.tongue_force_n, scenario.targets.gum_force_n, scene.haptics.device_limit_n});
  std::map<std::string, std::array<double, 3>> landmarks_m;
  for (const auto& [name, point] : look->package.landmarks)
    landmarks_m[name] = {1e-3 * point[0], 1e-3 * point[1], 1e-3 * point[2]};
  readings_->set_scenario(scenario, curricula::mouth_from_landmarks(landmarks_m));
  readings_->show_tube(scene.intubation.has_value());
}

bool TrialSide::due(int every_ms) {
  if (since_sagittal_.isValid() && since_sagittal_.elapsed() < every_ms) return false;
  since_sagittal_.restart();
  return true;
}

void TrialSide::draw_at_rest() {
  if (due(kRestMs)) sagittal_view_->draw();
}

void TrialSide::show_snapshot(const engine::Snapshot& snapshot, double sight_percent, double paused_s) {
  if (due(kSagittalMs)) {
    sagittal_view_->update_from(snapshot, sight_percent);
    sagittal_view_->draw();
  }
  readings_->show_snapshot(snapshot, paused_s);
  bars_->show_forces(load(snapshot, engine::Structure::tongue), load(snapshot, engine::Structure::gum));
}

void TrialSide::clear() {
  bars_->clear();
  readings_->clear();
}

}  // namespace vallecula::gui

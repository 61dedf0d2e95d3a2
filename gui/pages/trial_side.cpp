#include "gui/pages/trial_side.h"

#include <QFrame>
#include <QLabel>
#include <QVBoxLayout>
#include <array>
#include <map>
#include <string>

#include "gui/pages/distraction_panel.h"
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
  distractions_ = new DistractionPanel(this);
  caption_ = new QLabel("Mid-sagittal cut", this);
  caption_->setObjectName("heading");
  sagittal_view_ = new SagittalView(this);
  sagittal_view_->setMinimumSize(320, 280);
  bars_ = new ForceBars(this);
  bars_panel_ = new QFrame(this);
  bars_panel_->setObjectName("panel");
  (new QVBoxLayout(bars_panel_))->addWidget(bars_);
  auto* readings_panel = new QFrame(this);
  readings_panel->setObjectName("panel");
  readings_ = new TrialReadings(readings_panel);
  auto* inside = new QVBoxLayout(readings_panel);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addWidget(readings_);
  filler_ = new QWidget(this);  // in the cut's place
  column->addWidget(distractions_);
  column->addWidget(caption_);
  column->addWidget(sagittal_view_, 1);
  column->addWidget(filler_, 1);
  column->addWidget(bars_panel_);
  column->addWidget(readings_panel);
}

void TrialSide::open(TrialSession& session, const std::shared_ptr<PatientLook>& look) {
  const auto& scenario = session.scenario();
  const auto& scene = session.scene();
  sagittal_view_->show_patient(look, scene.tool.surface, scene.intubation ? &*scene.intubation : nullptr);
  for (QWidget* of_cut : {caption_, static_cast<QWidget*>(sagittal_view_)})
    of_cut->setVisible(scenario.assistance.cut_view);
  filler_->setVisible(!scenario.assistance.cut_view);
  bars_panel_->setVisible(scenario.assistance.force_bar);
  readings_->show_force(scenario.assistance.force_bar);
  distractions_->serve(&session.dual_task(), session.by_person());
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
  distractions_->refresh();
  readings_->show_snapshot(snapshot, paused_s);
  bars_->show_forces(load(snapshot, engine::Structure::tongue), load(snapshot, engine::Structure::gum));
}

void TrialSide::clear() {
  bars_->clear();
  readings_->clear();
}

}  // namespace vallecula::gui

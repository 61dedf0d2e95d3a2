// Beside the operator's view: the mid-sagittal cut, the force bars, the figures.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>

#include "gui/session/trial_session.h"
#include "gui/views/patient_look.h"

namespace vallecula::gui {

class DistractionPanel;
class ForceBars;
class SagittalView;
class TrialReadings;

class TrialSide : public QWidget {
 public:
  explicit TrialSide(QWidget* parent = nullptr);
  /// Shows what the scenario's assistance allows, and its distractions.
  void open(TrialSession& session, const std::shared_ptr<PatientLook>& look);
  /// Before the start: draws the patient at rest now and then.
  void draw_at_rest();
  /// To be called for every frame; the cut is drawn at a lower rate.
  void show_snapshot(const engine::Snapshot& snapshot, double sight_percent, double paused_s);
  void clear();
  SagittalView& sagittal_view() { return *sagittal_view_; }
  DistractionPanel& distractions() { return *distractions_; }

 private:
  bool due(int every_ms);
  DistractionPanel* distractions_;
  QWidget *caption_, *bars_panel_, *filler_;
  SagittalView* sagittal_view_;
  ForceBars* bars_;
  TrialReadings* readings_;
  QElapsedTimer since_sagittal_;
};

}  // namespace vallecula::gui

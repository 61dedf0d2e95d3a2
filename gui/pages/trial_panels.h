// The operator's view in the middle and around it what can be switched on and off, moved and taken out of the window:
// Qt's docks. What a scenario does not allow cannot be switched on in its trial; what a person arranged is remembered.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QPoint>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gui/pages/key_list.h"
#include "gui/session/peaks_so_far.h"
#include "gui/session/trial_session.h"
#include "gui/views/patient_look.h"

class QDockWidget;
class QMenu;

namespace vallecula::gui {

class DistractionPanel;
class ForceBars;
class MonitorPanel;
class SagittalView;
class TrialReadings;
class VideoView;

class TrialPanels : public QMainWindow {
  Q_OBJECT
 public:
  /// In the order of their keys, Alt+1 and on.
  enum Panel { monitor, cut, video, force, readings, team, kPanels };

  TrialPanels(QWidget* centre, QWidget* parent);
  ~TrialPanels() override;
  /// Shows what the scenario's assistance allows, of what is switched on.
  void open(TrialSession& session, const std::shared_ptr<PatientLook>& look);
  /// Draws cut and video where they can be seen; where the machine draws with the least it can, they take turns.
  void show_pictures(const engine::Snapshot& snapshot, double sight_percent);
  /// To be called for every frame: pictures and figures.
  void show_snapshot(const engine::Snapshot& snapshot, double sight_percent, double paused_s, const PeaksSoFar& peaks);
  /// Pictures, forces and readings of an expert's hands; what is the trial's own beside them - its clock, its infant on
  /// the monitor - is greyed out and named, and its peaks are kept.
  void show_expert(const engine::Snapshot& snapshot, double sight_percent);
  void clear();
  /// An instructor's sentence: the team's panel opens for it, whatever else is there.
  void say(const QString& line);
  /// The trial is over: the arrangement is kept, and nobody is asked anything. What was taken out of the window is
  /// hidden until the next trial opens.
  void close_trial();

  /// The panels' switches, and "Panels as at first".
  QMenu* menu() { return menu_; }
  void restore_first();
  std::vector<KeyRow> keys() const;
  QDockWidget* dock(Panel panel) { return docks_[panel]; }
  SagittalView& sagittal_view() { return *sagittal_view_; }
  DistractionPanel& distractions() { return *distractions_; }
  TrialReadings& readings_panel() { return *readings_; }
  const TrialReadings& readings_panel() const { return *readings_; }
  const ForceBars& bars() const { return *bars_; }
  const MonitorPanel& monitor_panel() const { return *monitor_; }

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void add(Panel panel, const QString& title, QWidget* content);
  void arrange();
  void switch_as_at_first();
  void fit();
  void widen();
  void fit_team(int left);  ///< px in height left for the views
  bool in_front(Panel panel) const;
  bool team_shares_place() const;
  void raise_team();
  void hide_floating();
  void find_place(Panel panel);  ///< of one that has left the window
  void put_back();               ///< the view the team was raised before
  void fit_later();
  void keep() const;
  /// Why this panel cannot be switched now, for a person; empty: it can.
  QString refusal(Panel panel) const;
  bool held_open(Panel panel) const;
  void show_what_is_wanted();

  MonitorPanel* monitor_;
  SagittalView* sagittal_view_;
  VideoView* video_view_;
  ForceBars* bars_;
  TrialReadings* readings_;
  DistractionPanel* distractions_;
  std::array<QDockWidget*, kPanels> docks_{};
  std::array<bool, kPanels> wanted_{};
  QMenu* menu_;
  QDockWidget* behind_team_ = nullptr;  ///< the view that was in front when the team was raised before it
  curricula::Assistance allowed_;
  bool has_infant_ = false, asks_ = false, said_ = false, arranging_ = false, as_at_first_ = true;
  bool line_open_ = false;  ///< what an instructor said opened the team's panel, and nobody has closed it since
  bool open_ = false;       ///< a trial is
  bool cut_next_ = false;
  std::array<bool, kPanels> placed_{};                   ///< out of the window, and where it is to be
  std::array<std::optional<QPoint>, kPanels> places_{};  ///< where it was last, out of the window
  bool double_clicked_ = false;
};

}  // namespace vallecula::gui

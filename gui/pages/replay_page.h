// A trial looked at again: the operator's view and the cut at any second, a timeline with what happened, charts, the
// score's reasons and notes that lead to their second.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "curricula/records/people.h"
#include "gui/session/replay_trial.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTabWidget;

namespace vallecula::gui {

class ElidedLabel;
class ForceBars;
class HeatLook;
class LinkedChart;
class MonitorPanel;
class NotesPanel;
class OperatorView;
class ReplayMarks;
class SagittalView;
class TimedList;
class Timeline;

constexpr double kBeforeReason_s = 2.0;  ///< a reason is looked at from this long before its second

class ReplayPage : public QWidget {
  Q_OBJECT
 public:
  explicit ReplayPage(QWidget* parent = nullptr);
  ~ReplayPage() override;

  /// Shows the trial from `before_s` before a second, which is marked; of a negative one from its beginning.
  void open(std::shared_ptr<ReplayTrial> trial, double at_s, double before_s);
  void close_replay();
  bool is_open() const { return trial_ != nullptr; }
  /// Who writes notes.
  void set_who(const curricula::Who& who);

  void play(bool on);
  bool playing() const { return playing_; }
  void set_rate(double rate);  ///< one of 0.25, 0.5, 1, 2, 4
  double rate() const;
  void seek(double at_s);
  /// From shortly before that second, which is marked.
  void look_at(double at_s);
  void step(int frames);
  void to_next_event();
  void to_previous_event();
  double time_s() const { return at_s_; }
  /// The frame on the screen; -1: none yet.
  long long shown_frame() const { return shown_; }
  const ReplayFilm& film() const { return *trial_->film; }
  ContactHeat& heat() { return *trial_->heat; }
  OperatorView& operator_view() { return *operator_view_; }
  ReplayMarks& operator_marks() { return *marks_; }
  /// Both views with the time and the figures below.
  QImage picture();
  /// The same of another second, which is gone to; until computed_s() they are there.
  QImage picture_of(double at_s);
  double computed_s() const;
  /// Throws std::runtime_error naming the file.
  void save_picture(const QString& png);

 signals:
  void left();
  void failed(const QString& message);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* make_head();
  QWidget* make_pictures();
  QWidget* make_side();
  QLayout* make_now();
  QWidget* make_foot();
  void show_lists();
  void show_charts();
  void frame();
  void show_film_progress();
  /// Everything of this second; `jumped`: not by playing on.
  void show_now(bool jumped);
  void show_figures();
  void show_monitor(bool jumped);
  void draw_views(bool all);
  void set_marked(double at_s);
  void open_marks();
  void show_heat();    ///< of the frame on the screen
  void follow_heat();  ///< once more, when its pressures are there
  void show_legend();
  void show_large_chart(bool large);  ///< in the place of the operator's view and the monitor
  void ask_for_picture();
  void ask_for_clip();
  void tell_saved(const QString& file);

  std::shared_ptr<ReplayTrial> trial_;
  OperatorView* operator_view_;
  SagittalView* sagittal_view_;
  MonitorPanel* monitor_;
  ForceBars* bars_;
  std::unique_ptr<ReplayMarks> marks_, cut_marks_;
  std::unique_ptr<HeatLook> heat_look_;
  std::size_t heat_of_ = 0;  ///< frames whose pressures are drawn
  Timeline* timeline_;
  LinkedChart *force_chart_, *monitor_chart_;
  QTabWidget *charts_, *lists_;
  TimedList *reasons_, *events_;
  NotesPanel* notes_;
  ElidedLabel *title_, *told_;
  QLabel *change_, *clock_, *figures_, *legend_, *notice_;
  QWidget* views_;  ///< the operator's view and the monitor
  QProgressBar* progress_;
  QPushButton *stop_, *play_;
  QComboBox* rate_;
  QCheckBox *arrows_, *path_, *expert_, *heat_, *free_, *half_;
  QTimer timer_;
  QElapsedTimer since_frame_, since_cut_;
  double at_s_ = 0.0;
  QString saved_;  ///< what was saved last and where, until the trial is moved in; empty: nothing
  long long shown_ = -1;
  bool playing_ = false, waiting_ = false, dirty_ = false;
};

}  // namespace vallecula::gui

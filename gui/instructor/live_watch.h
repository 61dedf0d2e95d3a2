// Follows the trial page's trials from their first picture on, so that an instructor's window that is opened in the
// middle of one has all of it.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "engine/snapshot.h"
#include "gui/instructor/live_events.h"

namespace vallecula::gui {

class TrialPage;
class TrialSession;

class LiveWatch : public QObject {
  Q_OBJECT
 public:
  /// The page must outlive it.
  explicit LiveWatch(TrialPage& trial);
  /// Of the trial that was opened last, the newest last; of very many the newest 500.
  const std::vector<LiveEvent>& events() const { return events_; }
  /// The trial's clock as the result and the replay have it; in a pause when that began, s.
  double now_s() const { return events_of_.now_s(); }
  /// What was done at another window, told with the others.
  void add(const QString& text);
  /// That trial is an assessment, over or not: what it keeps from its trainee is for instructors.
  bool assessed() const { return assessed_; }
  /// The next trainee sits down: what was told of the trial before goes with it.
  void forget();

 signals:
  void told(const std::vector<vallecula::gui::LiveEvent>& events);  ///< since the last time
  void begun_anew();                                                ///< by a reset; told() follows
  void forgotten();

 private:
  void take_session();
  void frame(const engine::Snapshot& snapshot);
  void follow(const engine::Snapshot& snapshot);
  void keep(const std::vector<LiveEvent>& events);

  TrialPage& trial_;
  std::shared_ptr<TrialSession> session_;
  LiveEvents events_of_;
  std::vector<LiveEvent> events_;
  double last_time_s_ = 0.0;
  bool assessed_ = false;
};

}  // namespace vallecula::gui

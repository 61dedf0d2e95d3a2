#include "gui/instructor/live_watch.h"

#include "gui/pages/trial_page.h"
#include "gui/session/package_parts.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

constexpr std::size_t kMostKept = 500;

/// The session tells whoever is at the blade; who watches is told of them.
QString pause_told(const TrialSession& session) {
  const std::string why = session.pause();
  if (why.empty() || session.frozen_by(Holder::instructor)) return in_words(why);
  if (session.frozen_by(Holder::expert)) return LiveWatch::tr("the trainee looks at the expert");
  if (session.frozen_by(Holder::reader)) return LiveWatch::tr("the trainee reads the list of keys");
  return in_words(why);
}

}  // namespace

LiveWatch::LiveWatch(TrialPage& trial) : trial_(trial) {
  connect(&trial_, &TrialPage::opened, this, &LiveWatch::take_session);
  connect(&trial_, &TrialPage::frame, this, &LiveWatch::frame);
  connect(&trial_, &TrialPage::waited, this, [this] {
    if (session_) follow(session_->latest());
  });
  connect(&trial_, &TrialPage::closed, this, [this] { session_.reset(); });
  take_session();
}

void LiveWatch::take_session() {
  session_ = trial_.session();
  events_.clear();
  last_time_s_ = 0.0;
  assessed_ = session_ && session_->scenario().attempt.mode == curricula::Mode::assessment;
  if (session_) events_of_.begin(session_->scenario(), mouth_of(session_->package()));
}

void LiveWatch::frame(const engine::Snapshot& snapshot) {
  if (!session_) return;
  if (snapshot.time_s < last_time_s_) {
    events_of_.begin(session_->scenario(), mouth_of(session_->package()));
    emit begun_anew();
    keep({{0.0, tr("Begun anew")}});
  }
  last_time_s_ = snapshot.time_s;
  follow(snapshot);
}

void LiveWatch::follow(const engine::Snapshot& snapshot) {
  keep(events_of_.watch(snapshot, pause_told(*session_), session_->paused_s(), &session_->dual_task()));
}

void LiveWatch::forget() {
  events_.clear();
  emit forgotten();
}

void LiveWatch::add(const QString& text) { keep({{events_of_.log_s(), text}}); }

void LiveWatch::keep(const std::vector<LiveEvent>& events) {
  if (events.empty()) return;
  events_.insert(events_.end(), events.begin(), events.end());
  if (events_.size() > kMostKept) events_.erase(events_.begin(), events_.end() - kMostKept);
  emit told(events);
}

}  // namespace vallecula::gui

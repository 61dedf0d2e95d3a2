#include "gui/pages/replay_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <algorithm>

#include "gui/pages/linked_chart.h"
#include "gui/pages/notes_panel.h"
#include "gui/pages/timed_list.h"
#include "gui/pages/timeline.h"
#include "gui/report/advice.h"
#include "gui/report/force_chart.h"
#include "gui/report/monitor_chart.h"
#include "gui/session/log_conversion.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"
#include "gui/views/elided_label.h"
#include "gui/views/force_bars.h"
#include "gui/views/heat_look.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/replay_marks.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"

namespace vallecula::gui {

namespace {

constexpr int kCutMs = 140, kWaitingMs = 500;
constexpr double kTrend_s = 60.0, kTrendStep_s = 0.25;  // what the monitor shows of the past

/// The monitor's own part of a snapshot, of a tick of the log.
engine::Snapshot monitor_snapshot(const curricula::LogTick& tick) {
  engine::Snapshot snapshot;
  snapshot.step = 0;
  snapshot.time_s = tick.time_s;
  snapshot.has_intubation = tick.has_intubation;
  if (curricula::paused(tick)) snapshot.faults = engine::kFaultDeviceInvalid;
  snapshot.intubation = from_log(tick).intubation;
  return snapshot;
}

/// Of the score's pauses what lies between two seconds, s.
double paused_between(const curricula::Score& score, double from_s, double to_s) {
  double sum_s = 0.0;
  for (const curricula::Pause& pause : score.pauses)
    sum_s += std::max(0.0, std::min(to_s, pause.at_s + pause.for_s) - std::max(from_s, pause.at_s));
  return sum_s;
}

}  // namespace

void ReplayPage::open(std::shared_ptr<ReplayTrial> trial, double at_s, double before_s) {
  close_replay();
  trial_ = std::move(trial);
  const engine::SceneDescription& scene = trial_->scene;
  const auto* intubation = scene.intubation ? &*scene.intubation : nullptr;
  const QString title = course_words(trial_->scenario.title);
  title_->say({tr("Replay: %1").arg(title), title});
  show_large_chart(false);
  QStringList warned;
  for (const std::string& notice : trial_->notices) warned << capitalised(in_words(notice));
  warned.removeDuplicates();
  notice_->setText(warned.join("\n"));
  notice_->setVisible(!warned.isEmpty());
  change_->setText(in_words(what_to_change(trial_->score, trial_->scenario)));
  operator_view_->show_patient(trial_->look, scene.tool.surface, intubation);
  sagittal_view_->show_patient(trial_->look, scene.tool.surface, intubation);
  sagittal_view_->add_marks(cut_marks_->props());
  open_marks();
  const bool planned = !trial_->expert_path.tip_mm.empty();
  expert_->setEnabled(planned);
  expert_->setToolTip(planned ? tr("X: the way a scripted expert's tip takes in this patient, in white")
                              : tr("The scripted expert has no plan for this patient"));
  free_->setChecked(false);
  bars_->set_marks(force_marks(trial_->scenario, trial_->log->header.device_limit_n));
  clock_->setToolTip(
      trial_->score.pauses.empty()
          ? QString()
          : tr("The film and its seconds go on in pauses, %1 s in all; the attempt's time stands in them, "
               "as in the result.")
                .arg(trial_->score.paused_s, 0, 'f', 1));
  monitor_->clear();
  monitor_->set_breathes(intubation != nullptr && intubation->breathes);
  monitor_->setVisible(intubation != nullptr);
  timeline_->show_trial(trial_->events, trial_->end_s());
  show_lists();
  show_charts();
  notes_->open(trial_->log_file);
  stop_->setVisible(true);
  progress_->setVisible(true);
  shown_ = -1;
  dirty_ = true;
  since_frame_.start();
  since_cut_.start();
  if (at_s >= 0.0) set_marked(at_s);
  seek(at_s - before_s);
  timer_.start();
  setFocus();
}

void ReplayPage::close_replay() {
  play(false);
  timer_.stop();
  heat_look_.reset();
  trial_.reset();
}

void ReplayPage::set_who(const curricula::Who& who) { notes_->set_who(who); }

void ReplayPage::show_lists() {
  reasons_->clear();
  for (const curricula::Criterion& criterion : trial_->score.criteria) {
    const auto points = std::find_if(trial_->points.begin(), trial_->points.end(),
                                     [&](const auto& p) { return p.mark == criterion.name; });
    QString text =
        (criterion.met ? QString::fromUtf8("\u2713 ") : QString::fromUtf8("\u2717 ")) + in_words(criterion.sentence);
    QString source;
    if (points != trial_->points.end()) {
      text += tr(" (%1 of %2 points)").arg(points->earned, 0, 'f', 0).arg(points->of, 0, 'f', 0);
      source = tr("Pass mark: %1").arg(in_words(points->source));
    }
    reasons_->add(criterion.at_s, text, criterion.met ? theme::text() : theme::over(), source);
  }
  events_->clear();
  for (const ReplayEvent& event : trial_->events)
    if (!minor(event)) events_->add(event.at_s, in_words(event.text), event_colour(event.kind));
}

void ReplayPage::show_charts() {
  const auto log = trial_->log;
  const auto scenario = std::make_shared<const curricula::Scenario>(trial_->scenario);
  const auto score = std::make_shared<const curricula::Score>(trial_->score);
  force_chart_->show_trial(
      [log, scenario, score](const ChartForm& form) { return make_force_chart(form, *log, *scenario, *score); },
      trial_->end_s());
  const bool monitored = score->intubation.has_value();
  charts_->setTabEnabled(1, monitored);
  if (!monitored) charts_->setCurrentIndex(0);
  if (monitored)
    monitor_chart_->show_trial(
        [log, scenario, score](const ChartForm& form) { return make_monitor_chart(form, *log, *scenario, *score); },
        trial_->end_s());
}

void ReplayPage::play(bool on) {
  if (on && !trial_) return;
  if (on && at_s_ >= trial_->end_s() - 1e-6) seek(0.0);  // from its end, anew
  playing_ = on;
  if (on) saved_.clear();
  since_frame_.restart();
  play_->setText(on ? tr("Pause") : tr("Play"));
  if (!on && trial_) {
    operator_view_->settle();
    dirty_ = true;
  }
}

double ReplayPage::rate() const { return rate_->currentData().toDouble(); }

void ReplayPage::set_rate(double rate) {
  const int index = rate_->findData(rate);
  if (index >= 0) rate_->setCurrentIndex(index);
}

void ReplayPage::seek(double at_s) {
  if (!trial_) return;
  at_s_ = std::clamp(at_s, 0.0, trial_->end_s());
  saved_.clear();
  since_frame_.restart();
  show_now(true);
}

void ReplayPage::look_at(double at_s) {
  if (!trial_) return;
  set_marked(at_s);
  seek(at_s - kBeforeReason_s);
}

void ReplayPage::step(int frames) {
  if (!trial_) return;
  play(false);
  const auto now = static_cast<long long>(trial_->film->frame_at(at_s_));
  const long long last = static_cast<long long>(trial_->film->plan().frames) - 1;
  seek(trial_->film->time_s(static_cast<std::size_t>(std::clamp(now + frames, 0LL, last))));
}

void ReplayPage::to_next_event() {
  if (!trial_) return;
  if (const ReplayEvent* event = next_event(trial_->events, at_s_)) {
    set_marked(event->at_s);
    seek(event->at_s);
  }
}

void ReplayPage::to_previous_event() {
  if (!trial_) return;
  const ReplayEvent* event = previous_event(trial_->events, at_s_);
  if (event != nullptr) set_marked(event->at_s);
  seek(event != nullptr ? event->at_s : 0.0);
}

void ReplayPage::set_marked(double at_s) {
  timeline_->mark(at_s);
  force_chart_->mark(at_s);
  monitor_chart_->mark(at_s);
}

void ReplayPage::frame() {
  if (!trial_) return;
  try {
    const double passed = 1e-3 * static_cast<double>(since_frame_.restart());
    show_film_progress();
    if (playing_) {
      const ReplayFilm& film = *trial_->film;
      const double ready = film.computed() == film.plan().frames ? trial_->end_s()
                           : film.computed() > 0                 ? film.time_s(film.computed() - 1)
                                                                 : 0.0;
      // What is not computed yet is waited for, and nothing is left out.
      at_s_ = std::max(at_s_, std::min(at_s_ + passed * rate(), ready));
      show_now(false);
      if (at_s_ >= trial_->end_s() || (film.finished() && at_s_ >= ready)) play(false);
    } else if (waiting_ && (trial_->film->frame(trial_->film->frame_at(at_s_)) != nullptr ||
                            (!trial_->film->finished() && since_cut_.elapsed() >= kWaitingMs))) {
      show_now(true);  // what was waited for, and on the way there how far it is
    }
    follow_heat();
    draw_views(!playing_);
  } catch (const std::exception& error) {
    const QString message = QString::fromUtf8(error.what());
    close_replay();
    emit failed(message);
  }
}

void ReplayPage::show_film_progress() {
  const ReplayFilm& film = *trial_->film;
  const bool done = film.finished();
  timeline_->set_ready(film.computed() > 0 ? film.time_s(film.computed() - 1) : 0.0);
  const std::size_t all = std::max<std::size_t>(1, film.plan().frames);
  progress_->setValue(static_cast<int>(1000 * film.computed() / all));
  progress_->setVisible(!done);
  stop_->setVisible(!done);
  QStringList said;
  QString shortly;
  if (!saved_.isEmpty()) said << saved_;
  const int percent = static_cast<int>(100 * film.computed() / all);
  if (waiting_ && !done)
    said << tr("Simulating the trial again up to %1 ... %2 % (Stop ends it)").arg(clock_text(at_s_)).arg(percent);
  if (!waiting_ && !done) said << tr("Simulating the trial again ... %1 % (Stop ends it)").arg(percent);
  if (!done) shortly = tr("Simulating ... %1 %").arg(percent);
  if (waiting_ && done) said << tr("The replay was stopped before this second.");
  if (done && !film.remark().empty() && !waiting_) said << in_words(film.remark());
  const QString text = said.join(". ");
  if (told_->toolTip() == text) return;
  if (!saved_.isEmpty()) return told_->say({saved_}, text, Qt::ElideMiddle);  // a path keeps its beginning and its name
  told_->say(shortly.isEmpty() ? QStringList{said.value(0)} : QStringList{said.value(0), shortly}, text);
}

void ReplayPage::show_now(bool jumped) {
  const ReplayFilm& film = *trial_->film;
  std::size_t index = film.frame_at(at_s_);
  const std::size_t computed = film.computed();
  waiting_ = index >= computed;
  if (waiting_ && computed > 0) index = computed - 1;  // the nearest there is
  if (computed > 0 && static_cast<long long>(index) != shown_) {
    const engine::Snapshot& snapshot = *film.frame(index);
    shown_ = static_cast<long long>(index);
    operator_view_->update_from(snapshot);
    sagittal_view_->update_from(snapshot, trial_->scenario.sight_percent);
    marks_->show(snapshot);
    cut_marks_->show(snapshot);
    if (jumped) operator_view_->settle();
    show_heat();
    dirty_ = true;
  }
  show_figures();
  show_monitor(jumped);
  timeline_->show_time(at_s_);
  force_chart_->show_time(at_s_);
  monitor_chart_->show_time(at_s_);
  notes_->show_time(at_s_);
  events_->follow(at_s_);
}

void ReplayPage::show_figures() {
  const curricula::LogTick& tick = trial_->tick_at(at_s_);
  const std::size_t index =
      std::min(static_cast<std::size_t>(&tick - trial_->log->ticks.data()) / kPeaksEvery, trial_->peaks.size() - 1);
  bars_->clear();
  const engine::TickRecord record = from_log(tick);
  bars_->show_forces(blade_forces(record.loads, record.proxy_pose), trial_->peaks[index]);
  clock_->setText(clock_text(at_s_) + " / " + clock_text(trial_->end_s()) +
                  (trial_->score.pauses.empty() ? QString() : tr(" (with pauses)")));
  QStringList figures;
  for (const auto& [from_s, to_s] : attempt_spans(trial_->score))
    if (at_s_ >= from_s && at_s_ <= to_s)
      figures << tr("attempt %1 s").arg(decimal(at_s_ - from_s - paused_between(trial_->score, from_s, at_s_), 1));
  if (figures.isEmpty()) {
    const auto spans = attempt_spans(trial_->score);
    figures << (spans.empty()                 ? tr("no attempt")
                : at_s_ < spans.front().first ? tr("before the attempt")
                : at_s_ > spans.back().second ? tr("after the attempt")
                                              : tr("between attempts"));
  }
  if (shown_ >= 0 && !waiting_)  // else the picture is of another moment than the figures
    figures << tr("glottis seen %1 %")
                   .arg(100.0 * trial_->film->frame(static_cast<std::size_t>(shown_))->glottis_visible, 0, 'f', 0);
  if (tick.has_intubation && tick.intubation.at_mouth_m > 0.0)
    figures << tr("tube %1 cm at the lips").arg(decimal(100.0 * tick.intubation.at_mouth_m, 1));
  const StateWords words = words_for(static_cast<engine::HapticState>(tick.state), curricula::paused(tick));
  if (tick.state != curricula::LoggedState::tracking || curricula::paused(tick))
    figures << tr("device %1").arg(words.name);
  figures_->setText(figures.join(QString::fromUtf8("  \u00b7  ")));
}

void ReplayPage::show_monitor(bool jumped) {
  if (!trial_->scene.intubation) return;
  const curricula::LogTick& now = trial_->tick_at(at_s_);
  if (jumped) {  // its last minute, and the breath before that
    monitor_->clear();
    const double from_s = std::max(0.0, at_s_ - kTrend_s);
    double breath_s = -1.0;
    for (const ReplayEvent& event : trial_->events)
      if (event.kind == ReplayEvent::Kind::breath && event.at_s <= from_s) breath_s = event.at_s;
    if (breath_s >= 0.0) monitor_->show_snapshot(monitor_snapshot(trial_->tick_at(breath_s)));
    // Each breath of the minute as well, so that the time since the last is right to the tick.
    std::vector<double> moments;
    for (double s = from_s; s < at_s_; s += kTrendStep_s) moments.push_back(s);
    for (const ReplayEvent& event : trial_->events)
      if (event.kind == ReplayEvent::Kind::breath && event.at_s > from_s && event.at_s < at_s_)
        moments.push_back(event.at_s);
    std::sort(moments.begin(), moments.end());
    for (const double s : moments) monitor_->show_snapshot(monitor_snapshot(trial_->tick_at(s)));
  }
  monitor_->show_snapshot(monitor_snapshot(now));
}

void ReplayPage::draw_views(bool all) {
  if (!dirty_) return;
  operator_view_->draw();
  // While it plays the cut is drawn at a lower rate; then once more when it stands.
  if (all || since_cut_.elapsed() >= kCutMs) {
    sagittal_view_->draw();
    since_cut_.restart();
  }
  dirty_ = false;
}

}  // namespace vallecula::gui

#include "gui/instructor/instructor_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "gui/instructor/instructor_controls.h"
#include "gui/instructor/run_checklist.h"
#include "gui/instructor/sign_in_dialog.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/records_pages/keep_ratings.h"
#include "gui/records_pages/person_words.h"
#include "gui/report/markdown.h"
#include "gui/session/package_parts.h"
#include "gui/session/words_from_below.h"
#include "gui/views/force_bars.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"

namespace vallecula::gui {
namespace {

/// Ten pictures a second are enough to watch by; where drawing is slow, it takes no more than a fifth of a core.
constexpr int kLeastPictureMs = 100;
constexpr double kShareOfACore = 0.2;
constexpr int kMostEvents = 500;

QString clock_words(double seconds) {
  const int whole = static_cast<int>(seconds);
  return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
}

QFrame* panel_with(QWidget* inside, QWidget* parent) {
  auto* panel = new QFrame(parent);
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(8, 6, 8, 6);
  column->addWidget(inside);
  return panel;
}

}  // namespace

InstructorWindow::InstructorWindow(TrialPage& trial, LiveWatch& watch, RecordsDesk& trainee)
    : trial_(trial), live_(watch), trainee_(trainee) {
  setWindowTitle(tr("Instructor - Vallecula"));
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(12, 10, 12, 10);
  columns->setSpacing(12);
  columns->addWidget(make_left(), 3);
  columns->addWidget(make_right(), 2);
  connect(&trial_, &TrialPage::opened, this, &InstructorWindow::take_session);
  connect(&trial_, &TrialPage::started, this, &InstructorWindow::show_state);
  connect(&trial_, &TrialPage::frame, this, &InstructorWindow::frame);
  connect(&trial_, &TrialPage::waited, this, &InstructorWindow::wait);
  connect(&trial_, &TrialPage::closed, this, &InstructorWindow::let_go);
  connect(&trial_, &TrialPage::finished, this, &InstructorWindow::recorded);
  connect(&live_, &LiveWatch::told, this, &InstructorWindow::add_events);
  connect(&live_, &LiveWatch::begun_anew, this, &InstructorWindow::begin_anew);
  connect(&live_, &LiveWatch::forgotten, events_, &QListWidget::clear);
  connect(&trainee_, &RecordsDesk::changed, this, &InstructorWindow::show_state);
  connect(&desk_, &RecordsDesk::changed, this, &InstructorWindow::show_state);
  connect(controls_, &InstructorControls::freeze_wanted, this, &InstructorWindow::freeze);
  connect(controls_, &InstructorControls::vital_sign, this, &InstructorWindow::drive);
  connect(controls_, &InstructorControls::say_wanted, this, &InstructorWindow::say);
  connect(checklist_, &RunChecklist::keep_wanted, this, &InstructorWindow::keep_ratings_given);
  add_keys();
  resize(1280, 800);
  take_session();
}

/// Esc means this window here: it is no key of the trial's while this has the focus.
void InstructorWindow::add_keys() {
  connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, [this] {
    if (controls_->leave_line()) return;
    if (session_ && session_->frozen_by(Holder::instructor))
      return controls_->tell(tr("The trial is frozen: continue it first (F5); Close lets it go as well."));
    close();
  });
}

QWidget* InstructorWindow::make_left() {
  auto* left = new QWidget(this);
  title_ = new QLabel(left);
  title_->setObjectName("title");
  title_->setWordWrap(true);
  state_ = new QLabel(left);
  state_->setObjectName("instructor_state");
  who_ = new QLabel(left);
  who_->setObjectName("faint");
  who_->setWordWrap(true);
  sign_in_ = new QPushButton(tr("&Sign in ..."), left);
  sign_in_->setObjectName("sign_in_here");
  sign_in_->setToolTip(tr("An instructor signs in at this window; whoever is at the blade stays signed in there"));
  connect(sign_in_, &QPushButton::clicked, this, &InstructorWindow::sign_in);
  next_ = new QPushButton(tr("&Next trainee ..."), left);
  next_->setToolTip(tr("The present trainee is signed out, the next one signs in (Ctrl+T); not while a trial runs"));
  connect(next_, &QPushButton::clicked, this, &InstructorWindow::next_trainee_wanted);
  auto* close = new QPushButton(tr("C&lose"), left);
  close->setObjectName("close_instructor");
  close->setToolTip(
      tr("Closes this window and lets the trial go on (Esc, Ctrl+I); whoever signed in here is signed out"));
  connect(close, &QPushButton::clicked, this, &QWidget::close);
  view_ = new OperatorView(left);
  view_->setMinimumSize(360, 240);
  view_->setAccessibleName(tr("The operator's view, live"));
  monitor_ = new MonitorPanel(left);
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(next_, 0, Qt::AlignTop);
  head->addWidget(close, 0, Qt::AlignTop);
  auto* line = new QHBoxLayout;
  line->addWidget(state_);
  line->addSpacing(14);
  line->addWidget(who_, 1);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addLayout(head);
  column->addLayout(line);
  column->addWidget(sign_in_, 0, Qt::AlignLeft);
  events_ = new QListWidget(left);
  events_->setObjectName("events");
  events_->setAccessibleName(tr("Events"));
  events_->setToolTip(tr("What happens, by the trial's clock (min:s)"));
  events_->setWordWrap(true);
  events_->setSelectionMode(QAbstractItemView::NoSelection);
  events_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  theme::keep_high(*events_, 100);
  events_->setStyleSheet("QListWidget::item { padding: 1px 4px; }");
  column->addWidget(view_, 1);
  column->addWidget(monitor_);
  column->addWidget(events_);
  return left;
}

QWidget* InstructorWindow::make_right() {
  auto* right = new QWidget(this);
  bars_ = new ForceBars(right);
  readings_ = new TrialReadings(right);
  controls_ = new InstructorControls(right);
  checklist_ = new RunChecklist(right);
  tabs_ = new QTabWidget(right);
  tabs_->addTab(checklist_, tr("Checklist"));
  tabs_->addTab(readings_, tr("Figures"));
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  forces_ = panel_with(bars_, right);
  column->addWidget(forces_);
  column->addWidget(panel_with(controls_, right));
  column->addWidget(tabs_, 1);
  return right;
}

void InstructorWindow::show_beside(QWidget* first) {
  const QList<QScreen*> screens = QApplication::screens();
  for (QScreen* screen : screens)
    if (screen != first->screen()) {
      move(screen->availableGeometry().topLeft());
      showMaximized();
      return;
    }
  show();
  raise();
}

/// As where this window is opened; without an instructor in the records the dialog says how there comes to be one.
void InstructorWindow::sign_in() {
  auto* dialog =
      new SignInDialog(desk_, SignInDialog::Whom::instructors, tr("Instructor's window"),
                       tr("An instructor signs in here; whoever is at the blade stays signed in there."), 0, this);
  dialog->open();
}

void InstructorWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  catch_up();
  if (session_) view_->draw();
}

void InstructorWindow::closeEvent(QCloseEvent* event) {
  controls_->release_all();
  if (session_) session_->freeze(Holder::instructor, false);  // nobody could let it go any more
  desk_.sign_out();                                           // who opens it next may be somebody else
  event->accept();
}

void InstructorWindow::take_session() {
  let_go();
  session_ = trial_.session();
  if (!session_) return;
  const auto& scenario = session_->scenario();
  const auto& scene = session_->scene();
  const auto mouth = mouth_of(session_->package());
  view_->show_patient(trial_.look(), scene.tool.surface, scene.intubation ? &*scene.intubation : nullptr);
  bars_->set_marks(force_marks(scenario, scene.haptics.device_limit_n));
  readings_->set_scenario(scenario, mouth);
  readings_->show_tube(scene.intubation.has_value());
  checklist_->begin(scenario);
  events_->clear();
  bars_->clear();
  monitor_->clear();
  monitor_->set_breathes(scene.intubation && scene.intubation->breathes);
  record_ = 0;
  drawn_ = 0;
  if (!trial_.running()) {  // as at the blade: tools, and what the monitor says, before the start
    view_->update_from(session_->at_start());
    monitor_->show_snapshot(session_->at_start());
  }
  if (isVisible()) view_->draw();
  show_state();
}

void InstructorWindow::let_go() {
  if (session_) controls_->release_all();
  session_.reset();
  show_state();
}

void InstructorWindow::catch_up() {
  events_->clear();
  add_events(live_.events());
  if (!session_) return;
  const TrialPanels& panels = trial_.panels();
  bars_->show_forces({}, panels.bars().peaks());
  readings_->go_on_from(panels.readings_panel());
  monitor_->go_on_from(panels.monitor_panel());
}

void InstructorWindow::begin_anew() {
  controls_->release_all();  // with nothing held
  bars_->clear();
  readings_->clear();
  monitor_->clear();
}

void InstructorWindow::frame(const engine::Snapshot& snapshot) {
  if (!session_ || !isVisible()) return;
  const double wait_ms = std::max<double>(kLeastPictureMs, view_->last_draw_ms() / kShareOfACore);
  if (since_drawn_.isValid() && static_cast<double>(since_drawn_.elapsed()) < wait_ms) return;
  since_drawn_.start();
  ++drawn_;
  view_->update_from(snapshot);  // the look has moved to it already, in the trial page's view
  view_->draw();
  bars_->show_forces(blade_forces(snapshot.loads, snapshot.proxy_pose), trial_.panels().bars().peaks());
  readings_->set_led(session_->led_in());
  readings_->show_snapshot(snapshot, session_->paused_s());
  monitor_->show_snapshot(snapshot);
  show_state();
}

/// The trainee looks at the expert: the tissue, which the views share, is the expert's then, and the picture stays.
void InstructorWindow::wait() {
  if (session_ && isVisible()) show_state();
}

/// What an assessment keeps from the trainee, anybody could read off this window where none but instructors sit.
bool InstructorWindow::shows_figures() const { return !live_.assessed() || desk_.instructor(); }

void InstructorWindow::show_state() {
  const bool running = session_ && trial_.running();
  const bool assessed = session_ && live_.assessed();
  const bool infant = session_ && session_->scene().intubation.has_value();
  const bool frozen = running && session_->frozen_by(Holder::instructor);
  const bool expert = running && session_->frozen_by(Holder::expert);
  const bool read = running && session_->frozen_by(Holder::reader);
  const bool unseen = running && session_->frozen_by(Holder::picture);
  if (session_)
    title_->setText(plain_of(session_->scenario().title));
  else if (title_->text().isEmpty())
    title_->setText(tr("No trial is open"));
  state_->setText(!session_  ? (record_ != 0 ? tr("Over; waiting for the next trial") : tr("Waiting for a trial"))
                  : !running ? tr("Prepared, not started")
                  : frozen   ? tr("FROZEN at %1").arg(clock_words(live_.now_s()))
                  : expert   ? tr("Stands at %1: an expert is shown").arg(clock_words(live_.now_s()))
                  : read     ? tr("Stands at %1: the list of keys is read").arg(clock_words(live_.now_s()))
                  : unseen   ? tr("Stands at %1: no picture comes to the screen").arg(clock_words(live_.now_s()))
                  : session_->pause().empty() ? tr("Running, %1").arg(clock_words(live_.now_s()))
                                              : tr("Paused at %1").arg(clock_words(live_.now_s())));
  const QString trainee = trainee_.who() ? words_of(trainee_.person()) : tr("nobody is signed in");
  const QString instructor = desk_.who() ? words_of(desk_.person()) : tr("nobody: ticks cannot be kept");
  who_->setText(
      tr("At the blade: %1. Here: %2.%3").arg(trainee, instructor, assessed ? tr(" Assessment.") : QString()));
  sign_in_->setVisible(!desk_.who());
  monitor_->setVisible(infant);
  next_->setEnabled(!running && !trial_.assessing());
  const bool told = shows_figures();
  forces_->setVisible(told);
  events_->setVisible(told);
  if (!told) tabs_->setCurrentWidget(checklist_);
  tabs_->setTabEnabled(tabs_->indexOf(readings_), told);
  InstructorControls::Trial now;
  now.open = session_ != nullptr;
  now.running = running;
  now.stands = running && !session_->pause().empty();
  now.vital_signs = infant;
  now.spasm = infant && !session_->scene().intubation->glottis.relaxed;
  now.assessment = assessed;
  now.instructor = told;
  controls_->allow(now);
  controls_->show_frozen(frozen);
}

void InstructorWindow::add_events(const std::vector<LiveEvent>& events) {
  for (const LiveEvent& event : events) events_->addItem(QString("%1   %2").arg(clock_words(event.at_s), event.text));
  while (events_->count() > kMostEvents) delete events_->takeItem(0);
  if (!events.empty()) events_->scrollToBottom();
}

void InstructorWindow::freeze(bool on) {
  if (!session_) return;
  try {
    session_->freeze(Holder::instructor, on);
    live_.add(on ? tr("You froze the trial") : tr("You let it go on"));
    show_state();
  } catch (const std::exception& error) {
    show_state();
    controls_->tell(in_words(error.what()));
  }
}

void InstructorWindow::drive(std::uint32_t action, bool down) {
  if (!session_) return;
  session_->actions().hold(static_cast<engine::Action>(action), down);
  const bool was = (driven_ & action) != 0;
  driven_ = down ? driven_ | action : driven_ & ~action;
  if (!down || was) return;
  const std::map<std::uint32_t, QString> words{{engine::kInstructorSaturationDown, tr("You lower the saturation")},
                                               {engine::kInstructorSaturationUp, tr("You raise the saturation")},
                                               {engine::kInstructorHeartDown, tr("You slow the heart")},
                                               {engine::kInstructorHeartUp, tr("You quicken the heart")},
                                               {engine::kInstructorSpasm, tr("You close the cords")}};
  live_.add(words.at(action));
}

void InstructorWindow::say(const QString& line) {
  if (!session_) return;
  trial_.say(line);
  live_.add(tr("The team says: %1").arg(line));
}

void InstructorWindow::recorded(const TrialOutcome& outcome) {
  record_ = outcome.record_id;
  checklist_->recorded(shows_figures() ? outcome.score.checklist : std::vector<curricula::ChecklistItem>(),
                       !desk_.instructor() ? tr("Recorded. An instructor who is signed in here can keep the ticks.")
                       : outcome.record_id == 0 ? tr("This trial has no record: the ticks cannot be kept.")
                                                : QString());
  tabs_->setCurrentWidget(checklist_);
  show_state();
}

void InstructorWindow::keep_ratings_given() {
  keep_ratings(
      desk_, this, record_, checklist_->ratings(), [this] { checklist_->kept(); },
      [this](const QString& message) { checklist_->refuse(message); });
}

}  // namespace vallecula::gui

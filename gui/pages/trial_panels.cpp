#include "gui/pages/trial_panels.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/pages/distraction_panel.h"
#include "gui/pages/free_place.h"
#include "gui/session/package_parts.h"
#include "gui/session/user_settings.h"
#include "gui/views/force_bars.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/scrolled.h"
#include "gui/views/theme.h"
#include "gui/views/trial_readings.h"
#include "gui/views/video_view.h"

namespace vallecula::gui {
namespace {

constexpr int kArrangement = 1;         // of the kept state; another number is not taken back
constexpr double kReadingsLines = 4.0;  // the clock and how much is seen

constexpr const char* kStateKey = "trial_page/panels";
constexpr const char* kHidden = "trial_page/hidden";

const std::array<const char*, TrialPanels::kPanels> kNames{"monitor", "cut", "video", "force", "readings", "team"};

}  // namespace

TrialPanels::TrialPanels(QWidget* centre, QWidget* parent) : QMainWindow(parent) {
  setWindowFlags(Qt::Widget);                                 // the constructor makes every main window one of its own
  setContextMenuPolicy(Qt::PreventContextMenu);               // the right button turns the blade
  theme::dress(*this, "QTabBar::tab { padding: 6px 7px; }");  // three names side by side
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCentralWidget(centre);
  menu_ = new QMenu(tr("&Panels"), this);
  monitor_ = new MonitorPanel(this);
  sagittal_view_ = new SagittalView(this);
  sagittal_view_->setMinimumSize(260, 110);
  sagittal_view_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  video_view_ = new VideoView(this);
  video_view_->setMinimumSize(260, 110);
  video_view_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  bars_ = new ForceBars(this);
  readings_ = new TrialReadings(this);
  distractions_ = new DistractionPanel(this);
  connect(distractions_, &DistractionPanel::silent, this, &TrialPanels::put_back);
  const auto framed = [this](QWidget* content, int around) {
    auto* frame = new QFrame(this);
    frame->setObjectName("panel");
    auto* inside = new QVBoxLayout(frame);
    inside->setContentsMargins(around, around, around, around);
    inside->addWidget(content);
    frame->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    return frame;
  };
  add(monitor, tr("&Monitor"), monitor_);
  add(cut, tr("Mid-&sagittal cut"), sagittal_view_);
  add(video, tr("&Video laryngoscope"), video_view_);
  add(force, tr("&Force"), framed(bars_, 8));
  // With all panels open in a small window the last figures are scrolled to.
  add(readings, tr("&Readings"), new Scrolled(framed(readings_, 0), kReadingsLines, this));
  add(team, tr("&Team"), distractions_);
  menu_->addSeparator();
  menu_->addAction(tr("Panels &as at first"), this, &TrialPanels::restore_first);
  arrange();
  const auto kept = user_settings();
  const QStringList hidden = kept->value(kHidden).toStringList();
  for (int p = 0; p < kPanels; ++p) wanted_[p] = !hidden.contains(kNames[p]);
  if (!kept->contains(kHidden)) switch_as_at_first();
  // Another number of docks, or what is no state, is not taken: then it is as at first.
  if (kept->contains(kStateKey) && restoreState(kept->value(kStateKey).toByteArray(), kArrangement))
    as_at_first_ = false;
  show_what_is_wanted();
}

TrialPanels::~TrialPanels() {
  hide_floating();
  keep();
}

void TrialPanels::add(Panel panel, const QString& title, QWidget* content) {
  auto* dock = new QDockWidget(QString(title).remove('&'), this);
  dock->setObjectName(QString("panel_") + kNames[panel]);
  dock->setAccessibleName(dock->windowTitle());
  dock->setWidget(content);
  dock->installEventFilter(this);
  docks_[panel] = dock;
  // The dock's own action, which its close button and whatever else hides it keep up to date.
  QAction* action = dock->toggleViewAction();
  action->setText(title);
  action->setShortcut(Qt::ALT + Qt::Key_1 + panel);
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  menu_->addAction(action);
  parentWidget()->addAction(action);
  connect(action, &QAction::triggered, this, [this, panel](bool on) {
    if (!refusal(panel).isEmpty()) return show_what_is_wanted();
    wanted_[panel] = on;
    if (panel == team && !on) line_open_ = false;
    if (on) docks_[panel]->raise();
    fit_later();
  });
  connect(dock, &QDockWidget::topLevelChanged, this, [this, panel](bool out) {
    as_at_first_ = as_at_first_ && arranging_;
    // Dragged out it is where the hand has it.
    const bool dragged = QGuiApplication::mouseButtons() != Qt::NoButton && !double_clicked_;
    placed_[panel] = out && (dragged || !isVisible());
    if (out && !placed_[panel]) QTimer::singleShot(0, this, [this, panel] { find_place(panel); });
  });
  connect(dock, &QDockWidget::dockLocationChanged, this, [this] { as_at_first_ = as_at_first_ && arranging_; });
}

void TrialPanels::arrange() {
  arranging_ = true;
  addDockWidget(Qt::TopDockWidgetArea, docks_[monitor]);
  for (const Panel panel : {team, cut, video, force, readings}) addDockWidget(Qt::RightDockWidgetArea, docks_[panel]);
  tabifyDockWidget(docks_[cut],
                   docks_[video]);  // no window grows for the second view; fit() parts them where there is room
  for (QDockWidget* dock : docks_) dock->setFloating(false);
  arranging_ = false;
  as_at_first_ = true;
}

void TrialPanels::restore_first() {
  for (QDockWidget* dock : docks_) removeDockWidget(dock);
  arrange();
  switch_as_at_first();
  line_open_ = said_;
  show_what_is_wanted();
}

void TrialPanels::switch_as_at_first() {
  wanted_.fill(true);
  wanted_[video] = false;  // many learn by the direct view first
  wanted_[team] = false;   // comes when somebody speaks
}

std::vector<KeyRow> TrialPanels::keys() const {
  std::vector<KeyRow> rows;
  for (const QDockWidget* dock : docks_)
    rows.push_back({dock->toggleViewAction()->shortcut().toString(QKeySequence::NativeText), dock->windowTitle()});
  return rows;
}

void TrialPanels::keep() const {
  const auto kept = user_settings();
  QStringList hidden;
  for (int p = 0; p < kPanels; ++p)
    if (!wanted_[p]) hidden << kNames[p];
  kept->setValue(kHidden, hidden);
  if (as_at_first_)
    kept->remove(kStateKey);
  else
    kept->setValue(kStateKey, saveState(kArrangement));
}

QString TrialPanels::refusal(Panel panel) const {
  const QString not_here = tr("This scenario does not show it.");
  switch (panel) {
    case monitor:
      return has_infant_ ? QString() : tr("In this scenario there is no infant on a monitor.");
    case cut:
      return allowed_.cut_view ? QString() : not_here;
    case video:
      return allowed_.video_view ? QString() : not_here;
    case force:
      return allowed_.force_bar ? QString() : not_here;
    default:
      return held_open(panel) ? tr("This scenario asks you things: its place stays.") : QString();
  }
}

bool TrialPanels::held_open(Panel panel) const { return panel == team && asks_; }

void TrialPanels::show_what_is_wanted() {
  for (int p = 0; p < kPanels; ++p) {
    const auto panel = static_cast<Panel>(p);
    const QString refused = refusal(panel);
    QAction* action = docks_[p]->toggleViewAction();
    action->setEnabled(refused.isEmpty());
    action->setToolTip(refused.isEmpty() ? tr("Switches this panel on and off") : refused);
    const bool open = held_open(panel);
    docks_[p]->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
                           (open ? QDockWidget::NoDockWidgetFeatures : QDockWidget::DockWidgetClosable));
    const bool has_picture = open_ || !docks_[p]->isFloating();
    const bool told = panel == team && line_open_;  // of this trial: nobody has switched it on for others
    docks_[p]->setVisible(has_picture && (open || told || (refused.isEmpty() && wanted_[p])));
  }
  fit_later();
}

/// By its button it would lie over the panels beside it, and Qt forgets where it was before.
void TrialPanels::find_place(Panel panel) {
  QDockWidget* dock = docks_[panel];
  if (!dock->isFloating()) return;
  if (places_[panel] && QGuiApplication::screenAt(*places_[panel]) != nullptr) {
    placed_[panel] = true;
    return dock->move(*places_[panel]);
  }
  std::vector<QRect> others;
  for (const QDockWidget* other : docks_)
    if (other != dock && !other->visibleRegion().isEmpty())
      others.emplace_back(other->mapToGlobal(QPoint(0, 0)), other->size());
  dock->move(free_place(dock->frameGeometry().size(), window()->screen()->availableGeometry(),
                        window()->frameGeometry(), others));
  placed_[panel] = true;  // what moves it from now on is a person
}

/// Out of the window a panel would stand there without the page, and be there again before a trial is.
void TrialPanels::hide_floating() {
  for (QDockWidget* dock : docks_)
    if (dock->isFloating()) dock->hide();
}

void TrialPanels::open(TrialSession& session, const std::shared_ptr<PatientLook>& look) {
  open_ = true;
  const auto& scenario = session.scenario();
  const auto& scene = session.scene();
  allowed_ = scenario.assistance;
  has_infant_ = scene.intubation.has_value();
  asks_ = !scenario.distractions.empty();
  said_ = line_open_ = false;
  sagittal_view_->show_patient(look, scene.tool.surface, has_infant_ ? &*scene.intubation : nullptr);
  video_view_->show_patient(look, scene.tool.surface, has_infant_ ? &*scene.intubation : nullptr);
  sagittal_view_->update_from(session.at_start(), scenario.sight_percent);
  video_view_->update_from(session.at_start());
  readings_->show_force(allowed_.force_bar);
  distractions_->serve(&session.dual_task(), session.by_person());
  bars_->set_marks(force_marks(scenario, scene.haptics.device_limit_n));
  readings_->set_scenario(scenario, mouth_of(session.package()));
  readings_->show_tube(has_infant_);
  monitor_->clear();
  monitor_->set_breathes(has_infant_ && scene.intubation->breathes);
  monitor_->show_snapshot(session.at_start());  // nobody begins without having read it
  show_what_is_wanted();
}

void TrialPanels::close_trial() {
  put_back();
  open_ = false;
  hide_floating();
  keep();
  distractions_->serve(nullptr, false);
}

void TrialPanels::say(const QString& line) {
  distractions_->say(line);
  // Once its words have their place: as high as they are, also where a person has arranged the panels.
  QTimer::singleShot(0, this, [this] {
    const QDockWidget& dock = *docks_[team];
    if (!as_at_first_ && dock.isVisible() && !dock.isFloating())
      resizeDocks({docks_[team]}, {std::max(dock.height(), dock.sizeHint().height())}, Qt::Vertical);
  });
  if (said_) {
    if (docks_[team]->isVisible() && team_shares_place()) raise_team();
    return fit_later();
  }
  said_ = line_open_ = true;
  raise_team();
  fit_later();
}

namespace {

/// A view behind another's tab is not drawn.
bool can_be_seen(const QWidget& view) { return !view.visibleRegion().isEmpty(); }

}  // namespace

void TrialPanels::show_pictures(const engine::Snapshot& snapshot, double sight_percent) {
  const bool cut = can_be_seen(*sagittal_view_), video = can_be_seen(*video_view_);
  cut_next_ = !cut_next_;
  const bool in_turn = cut && video && GlView::governor().least();  // nothing else is left to be given up
  if (cut && !(in_turn && !cut_next_)) {
    sagittal_view_->update_from(snapshot, sight_percent);
    sagittal_view_->draw();
  }
  if (video && !(in_turn && cut_next_)) {
    video_view_->update_from(snapshot);
    video_view_->draw();
  }
}

void TrialPanels::show_expert(const engine::Snapshot& snapshot, double sight_percent) {
  show_pictures(snapshot, sight_percent);
  bars_->show_expert(blade_forces(snapshot.loads, snapshot.proxy_pose));
  readings_->show_expert(snapshot);
  monitor_->set_waiting(true);
}

void TrialPanels::show_snapshot(const engine::Snapshot& snapshot, double sight_percent, double paused_s,
                                const PeaksSoFar& peaks) {
  show_pictures(snapshot, sight_percent);
  distractions_->refresh();
  monitor_->show_snapshot(snapshot);
  readings_->show_snapshot(snapshot, paused_s);
  bars_->show_forces(blade_forces(snapshot.loads, snapshot.proxy_pose), peaks);
}

void TrialPanels::clear() {
  bars_->clear();
  readings_->clear();
  monitor_->clear();
}

void TrialPanels::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  fit_later();
}

bool TrialPanels::event(QEvent* event) {
  if (event->type() == QEvent::Show) fit_later();
  if (event->type() == QEvent::Show && !event->spontaneous() && open_) show_what_is_wanted();
  if (event->type() == QEvent::Hide && !event->spontaneous()) hide_floating();  // the page was left
  // The mouse is let go on the window itself only between two docks: a border was moved.
  if (event->type() == QEvent::MouseButtonRelease) as_at_first_ = false;
  return QMainWindow::event(event);
}

bool TrialPanels::eventFilter(QObject* watched, QEvent* event) {
  auto* dock = qobject_cast<QDockWidget*>(watched);
  if (dock == nullptr) return QMainWindow::eventFilter(watched, event);
  for (int p = 0; p < kPanels; ++p)
    if (docks_[p] == dock && event->type() == QEvent::Close) {
      wanted_[p] = false;
      if (p == team) line_open_ = false;
    }
  for (int p = 0; p < kPanels; ++p)
    if (docks_[p] == dock && event->type() == QEvent::Move && placed_[p] && dock->isFloating())
      places_[p] = dock->pos();
  if (event->type() == QEvent::MouseButtonPress) double_clicked_ = false;
  if (event->type() == QEvent::MouseButtonDblClick) double_clicked_ = true;  // takes it out without a drag
  // A panel out of the window keeps no keys for itself: they are the hands'.
  if (dock->isFloating() && (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease))
    return QCoreApplication::sendEvent(parentWidget(), event);
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace vallecula::gui

// The replay page's widgets and where they are.
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include "gui/pages/linked_chart.h"
#include "gui/pages/notes_panel.h"
#include "gui/pages/replay_page.h"
#include "gui/pages/timed_list.h"
#include "gui/pages/timeline.h"
#include "gui/report/force_chart.h"
#include "gui/report/monitor_chart.h"
#include "gui/views/elided_label.h"
#include "gui/views/force_bars.h"
#include "gui/views/heat_look.h"
#include "gui/views/monitor_panel.h"
#include "gui/views/operator_view.h"
#include "gui/views/replay_marks.h"
#include "gui/views/sagittal_view.h"
#include "gui/views/scrolled.h"

namespace vallecula::gui {

ReplayPage::ReplayPage(QWidget* parent)
    : QWidget(parent), marks_(std::make_unique<ReplayMarks>()), cut_marks_(std::make_unique<ReplayMarks>()) {
  setFocusPolicy(Qt::StrongFocus);
  auto* across = new QSplitter(Qt::Horizontal, this);
  auto* side = make_side();
  across->addWidget(make_pictures());
  across->addWidget(side);
  across->setStretchFactor(0, 17);
  across->setStretchFactor(1, 10);
  across->setChildrenCollapsible(false);
  across->setSizes({780, 470});
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(10, 8, 10, 8);
  all->setSpacing(6);
  all->addWidget(make_head());
  change_ = new QLabel(this);
  change_->setObjectName("heading");
  change_->setWordWrap(true);
  all->addWidget(change_);
  all->addWidget(across, 1);
  timeline_ = new Timeline(this);
  notice_ = new QLabel(this);
  notice_->setObjectName("replay_notice");
  notice_->setProperty("role", "warning");
  notice_->setWordWrap(true);
  notice_->hide();
  all->addWidget(notice_);
  all->addLayout(make_now());
  all->addWidget(timeline_);
  all->addWidget(make_foot());
  connect(timeline_, &Timeline::wanted, this, &ReplayPage::seek);
  for (LinkedChart* chart : {force_chart_, monitor_chart_})
    connect(chart, &LinkedChart::wanted, this, &ReplayPage::seek);
  connect(reasons_, &TimedList::wanted, this, &ReplayPage::look_at);
  connect(events_, &TimedList::wanted, this, &ReplayPage::look_at);
  connect(notes_, &NotesPanel::wanted, this, [this](double at_s) {
    set_marked(at_s);
    seek(at_s);
  });
  connect(notes_, &NotesPanel::listed, timeline_, &Timeline::show_notes);
  timer_.setInterval(static_cast<int>(1000.0 / kFilmRateHz));
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &ReplayPage::frame);
}

ReplayPage::~ReplayPage() = default;

QWidget* ReplayPage::make_head() {
  auto* head = new QWidget(this);
  title_ = new ElidedLabel(head);
  title_->setObjectName("heading");
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(title_, 1);
  const auto box = [&](const QString& text, const char* name, const QString& tip, bool on) {
    auto* made = new QCheckBox(text, head);
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setChecked(on);
    made->setFocusPolicy(Qt::TabFocus);
    row->addWidget(made);
    return made;
  };
  arrows_ = box(tr("Forces"), "arrows",
                tr("A: arrows of the blade's push on the tissue, 5 mm a newton; blue on soft tissue, red "
                   "on gums, palate and teeth"),
                true);
  path_ = box(tr("Tip's path"), "path",
              tr("P: the way of the blade's tip until now, coloured by the force on the tongue"), false);
  expert_ = box(tr("Expert's path"), "expert", "", false);
  heat_ = box(tr("Heat map"), "heat",
              tr("C: where the blade pressed on tongue and epiglottis so far, and how hard (kPa): the highest "
                 "pressure on each part"),
              false);
  free_ = box(tr("Free camera"), "free",
              tr("F: drag turns the view, Shift-drag moves it, the wheel goes nearer; Shift and arrow "
                 "keys turn it too"),
              false);
  half_ =
      box(tr("Half head"), "half",
          tr("H: with the free camera, without the skin of the patient's left half, for a look from the side"), false);
  half_->setEnabled(false);
  connect(arrows_, &QCheckBox::toggled, this, [this](bool on) {
    for (const auto& marks : {marks_.get(), cut_marks_.get()}) marks->show_arrows(on);
    dirty_ = true;
  });
  connect(path_, &QCheckBox::toggled, this, [this](bool on) {
    for (const auto& marks : {marks_.get(), cut_marks_.get()}) marks->show_path(on);
    show_legend();
    dirty_ = true;
  });
  connect(expert_, &QCheckBox::toggled, this, [this](bool on) {
    for (const auto& marks : {marks_.get(), cut_marks_.get()}) marks->show_expert(on);
    dirty_ = true;
  });
  connect(heat_, &QCheckBox::toggled, this, [this](bool on) {
    if (!heat_look_) return;
    heat_look_->actor()->SetVisibility(on);
    show_heat();
    show_legend();
    dirty_ = true;
  });
  connect(free_, &QCheckBox::toggled, this, [this](bool on) {
    operator_view_->set_free_camera(on);
    half_->setEnabled(on);
    if (!on) half_->setChecked(false);  // the operator's eye sees whole heads
    dirty_ = true;
  });
  connect(half_, &QCheckBox::toggled, this, [this](bool on) {
    operator_view_->set_half(on);
    dirty_ = true;
  });
  return head;
}

QWidget* ReplayPage::make_pictures() {
  auto* splitter = new QSplitter(Qt::Vertical, this);
  auto* top = views_ = new QWidget(splitter);
  operator_view_ = new OperatorView(top);
  operator_view_->setMinimumSize(360, 170);
  legend_ = new QLabel(top);
  legend_->setMargin(5);
  legend_->setWordWrap(true);                              // no wider than the view it lies over
  legend_->setStyleSheet("background: palette(window);");  // follows the look, as the words on it do
  legend_->setAttribute(Qt::WA_TransparentForMouseEvents);
  legend_->hide();
  monitor_ = new MonitorPanel(top);
  auto* column = new QVBoxLayout(top);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* picture = new QGridLayout;  // the legend lies over the view
  picture->addWidget(operator_view_, 0, 0);
  picture->addWidget(legend_, 0, 0, Qt::AlignBottom);
  column->addLayout(picture, 1);
  column->addWidget(monitor_);
  charts_ = new QTabWidget(splitter);
  charts_->setObjectName("charts");
  charts_->setFocusPolicy(Qt::NoFocus);
  force_chart_ = new LinkedChart(tr("Force over time"), kLeastUntitledForceChart, charts_);
  force_chart_->setObjectName("force_chart");
  monitor_chart_ = new LinkedChart(tr("Saturation and heart rate over time"), kLeastUntitledMonitorChart, charts_);
  for (LinkedChart* chart : {force_chart_, monitor_chart_})
    connect(chart, &LinkedChart::room_wanted, this, [this] { show_large_chart(!views_->isHidden()); });
  // With large text in a small window a chart is higher than its place.
  charts_->addTab(new Scrolled(force_chart_, 7.0, charts_), tr("Force"));
  charts_->addTab(new Scrolled(monitor_chart_, 7.0, charts_), tr("Monitor"));
  charts_->setTabPosition(QTabWidget::West);
  splitter->addWidget(top);
  splitter->addWidget(charts_);
  splitter->setSizes({430, 260});
  splitter->setStretchFactor(0, 1);
  splitter->setStretchFactor(1, 0);
  splitter->setChildrenCollapsible(false);
  return splitter;
}

void ReplayPage::show_large_chart(bool large) {
  views_->setVisible(!large);
  for (LinkedChart* chart : {force_chart_, monitor_chart_}) chart->show_large(large);
  dirty_ = true;  // the views were not drawn meanwhile
}

QWidget* ReplayPage::make_side() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  sagittal_view_ = new SagittalView(side);
  sagittal_view_->setMinimumSize(260, 130);
  bars_ = new ForceBars(side);
  auto* bars_panel = new QFrame(side);
  bars_panel->setObjectName("panel");
  (new QVBoxLayout(bars_panel))->addWidget(bars_);
  lists_ = new QTabWidget(side);
  lists_->setObjectName("lists");
  reasons_ = new TimedList(tr("What was judged"), lists_);
  events_ = new TimedList(tr("What happened"), lists_);
  notes_ = new NotesPanel(lists_);
  reasons_->setObjectName("reasons");
  reasons_->setToolTip(tr("Enter or a click begins %1 s before; on the timeline the moment itself is framed in yellow")
                           .arg(kBeforeReason_s, 0, 'f', 0));
  events_->setObjectName("events");
  lists_->addTab(reasons_, tr("Score"));
  lists_->addTab(events_, tr("Events"));
  lists_->addTab(notes_, tr("Notes"));
  lists_->setMinimumHeight(120);
  column->addWidget(sagittal_view_, 3);
  column->addWidget(bars_panel);
  column->addWidget(lists_, 2);
  return side;
}

QLayout* ReplayPage::make_now() {
  auto* row = new QHBoxLayout;
  clock_ = new QLabel(this);
  QFont bold = clock_->font();
  bold.setBold(true);
  clock_->setFont(bold);
  figures_ = new QLabel(this);
  told_ = new ElidedLabel(this);
  told_->setObjectName("faint");
  told_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(clock_);
  row->addSpacing(14);
  row->addWidget(figures_);
  row->addSpacing(14);
  row->addWidget(told_, 1);
  return row;
}

QWidget* ReplayPage::make_foot() {
  auto* foot = new QWidget(this);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);  // all of it, with the bar, in a small window
  const auto button = [&](const QString& text, const QString& name, const QString& tip) {
    auto* made = new QPushButton(text, foot);
    made->setAccessibleName(name);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the page
    row->addWidget(made);
    return made;
  };
  auto* back = button(tr("\u00ab Event"), tr("Previous event"), "PgUp");
  auto* frame_back = button(tr("\u2039 Frame"), tr("A frame back"), "Left");
  play_ = button(tr("Play"), tr("Play or pause"), "Space");
  play_->setObjectName("primary");
  play_->setMinimumWidth(84);
  auto* frame_on = button(tr("Frame \u203a"), tr("A frame on"), "Right");
  auto* on = button(tr("Event \u00bb"), tr("Next event"), "PgDn");
  rate_ = new QComboBox(foot);
  rate_->setAccessibleName(tr("Speed"));
  rate_->setToolTip(tr("+ and -"));
  rate_->setFocusPolicy(Qt::TabFocus);
  for (const double rate : {0.25, 0.5, 1.0, 2.0, 4.0}) rate_->addItem(QString::fromUtf8("%1\u00d7").arg(rate), rate);
  rate_->setCurrentIndex(2);
  row->addWidget(rate_);
  row->addStretch(1);
  progress_ = new QProgressBar(foot);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);  // the line above says it in words
  progress_->setFixedWidth(80);
  progress_->setAccessibleName(tr("Simulating the trial again"));
  progress_->setToolTip(
      tr("Simulating the trial again: the tissue's shape is not in the log and is computed anew. What is "
         "blue on the timeline is there; Stop ends it, and what is computed stays."));
  row->addWidget(progress_);
  stop_ = button(tr("Stop"), tr("Stop computing"), tr("What is computed stays"));
  auto* picture = button(tr("Picture ..."), tr("Save a picture"), tr("Ctrl+S: both views as a PNG"));
  auto* clip = button(tr("Clip ..."), tr("Save a clip"), tr("Both views from one second to another"));
  connect(clip, &QPushButton::clicked, this, &ReplayPage::ask_for_clip);
  auto* leave = button(tr("Back"), tr("Back"), "Esc");
  connect(back, &QPushButton::clicked, this, &ReplayPage::to_previous_event);
  connect(frame_back, &QPushButton::clicked, this, [this] { step(-1); });
  connect(play_, &QPushButton::clicked, this, [this] { play(!playing_); });
  connect(frame_on, &QPushButton::clicked, this, [this] { step(1); });
  connect(on, &QPushButton::clicked, this, &ReplayPage::to_next_event);
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (trial_) trial_->film->stop();
  });
  connect(picture, &QPushButton::clicked, this, &ReplayPage::ask_for_picture);
  connect(leave, &QPushButton::clicked, this, &ReplayPage::left);
  return foot;
}

}  // namespace vallecula::gui

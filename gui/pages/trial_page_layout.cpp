// Where everything on the trial page stands.
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/pages/blade_control.h"
#include "gui/pages/hand_panel.h"
#include "gui/pages/help_panel.h"
#include "gui/pages/mouse_introduction.h"
#include "gui/pages/parts_label.h"
#include "gui/pages/sound_button.h"
#include "gui/pages/trial_page.h"
#include "gui/pages/trial_panels.h"
#include "gui/session/user_settings.h"
#include "gui/views/operator_view.h"

namespace vallecula::gui {
namespace {

// What the quality governor keeps to (views/quality).
constexpr int kFrameMs = 33;

}  // namespace

TrialPage::TrialPage(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  auto* head = make_head();
  panels_ = new TrialPanels(make_centre(), this);
  panels_button_->setMenu(panels_->menu());
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(10, 6, 10, 8);
  all->setSpacing(4);
  all->addLayout(head);
  all->addWidget(panels_, 1);
  all->addWidget(make_foot());
  timer_.setInterval(kFrameMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &TrialPage::draw_frame);
  hands_->hide();
  steered_->hide();
  sound_->hide();
  show_banner({});
  show_buttons();
}

QLayout* TrialPage::make_head() {
  title_ = new QLabel(this);
  title_->setObjectName("heading");
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  sound_ = new SoundButton(this);
  panels_button_ = new QToolButton(this);
  panels_button_->setText(tr("&Panels"));
  panels_button_->setToolTip(
      tr("Which panels are shown (Alt+1 and on); each may be moved, or taken out of the window"));
  panels_button_->setPopupMode(QToolButton::InstantPopup);
  panels_button_->setFocusPolicy(Qt::NoFocus);
  auto* keys = new QToolButton(this);
  keys->setText(tr("Keys"));
  keys->setToolTip(tr("All keys of this page (F1)"));
  keys->setFocusPolicy(Qt::NoFocus);
  connect(keys, &QToolButton::clicked, this, &TrialPage::list_keys);
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  for (QToolButton* button : {static_cast<QToolButton*>(sound_), panels_button_, keys}) head->addWidget(button);
  return head;
}

QWidget* TrialPage::make_centre() {
  auto* centre = new QWidget(this);
  operator_view_ = new OperatorView(centre);
  operator_view_->setMinimumSize(400, 240);
  connect(operator_view_, &GlView::painted, this, &TrialPage::picture_came);
  control_ = new BladeControl(operator_view_);
  introduction_ = new MouseIntroduction(centre);
  connect(control_, &BladeControl::gain_changed, this, [this](double gain) {
    keep_mouse_gain(gain);
    show_help();
  });
  hands_ = new HandPanel(centre);
  helps_ = new HelpPanel(centre);
  steered_ = new QLabel(centre);
  steered_->setMargin(6);
  steered_->setAttribute(Qt::WA_TransparentForMouseEvents);
  connect(helps_->vallecula(), &QPushButton::clicked, this, &TrialPage::begin_at_vallecula);
  connect(helps_->expert(), &QPushButton::clicked, this, &TrialPage::expert_pressed);
  expert_sign_ = new QLabel(centre);
  expert_sign_->setAttribute(Qt::WA_TransparentForMouseEvents);
  expert_sign_->setAlignment(Qt::AlignCenter);
  expert_sign_->hide();
  banner_ = new QLabel(centre);
  banner_->setWordWrap(true);
  banner_->setMinimumHeight(2 * banner_->fontMetrics().lineSpacing() + 16);  // two lines and their padding
  banner_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* picture = new QGridLayout;  // the introduction and whose hand is steered lie over the view
  picture->addWidget(operator_view_, 0, 0);
  picture->addWidget(steered_, 0, 0, Qt::AlignTop | Qt::AlignLeft);
  picture->addWidget(expert_sign_, 0, 0, Qt::AlignTop | Qt::AlignHCenter);
  column->addLayout(picture, 1);
  column->addWidget(hands_);
  column->addWidget(helps_);
  column->addWidget(banner_);
  return centre;
}

QWidget* TrialPage::make_foot() {
  auto* foot = new QWidget(this);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 2, 0, 0);
  help_ = new PartsLabel(foot);
  help_->setObjectName("faint");
  start_ = new QPushButton(tr("Start"), foot);
  start_->setObjectName("primary");
  end_ = new QPushButton(tr("End"), foot);
  reset_ = new QPushButton(tr("Reset"), foot);
  zoom_ = new QPushButton(foot);
  leave_ = new QPushButton(tr("Back"), foot);
  device_note_ = new QLabel(foot);
  device_note_->setObjectName("faint");
  device_note_->hide();
  row->addWidget(help_, 1);
  row->addWidget(device_note_);
  for (auto* button : {zoom_, reset_, end_, start_, leave_}) {
    button->setFocusPolicy(Qt::NoFocus);  // keys are the blade's
    row->addWidget(button);
  }
  start_->setToolTip(tr("Begins the trial (Enter)"));
  reset_->setToolTip(tr("Begins anew; what was done until now is kept (R)"));
  zoom_->setToolTip(tr("How near the operator's view is: by itself, the face, or the mouth (Z)"));
  connect(start_, &QPushButton::clicked, this, &TrialPage::start);
  connect(end_, &QPushButton::clicked, this, [this] { end(curricula::kEndedByTrainee); });
  connect(reset_, &QPushButton::clicked, this, &TrialPage::reset);
  connect(leave_, &QPushButton::clicked, this, &TrialPage::left);
  connect(zoom_, &QPushButton::clicked, this, &TrialPage::change_zoom);
  return foot;
}

}  // namespace vallecula::gui

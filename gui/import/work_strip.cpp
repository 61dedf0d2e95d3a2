#include "gui/import/work_strip.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "gui/import/import_work.h"

namespace vallecula::gui {

WorkStrip::WorkStrip(ImportWork& work, QWidget* parent) : QWidget(parent), work_(work) {
  stage_ = new QLabel(this);
  stage_->setObjectName("heading");
  left_ = new QLabel(this);
  left_->setObjectName("faint");
  left_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar_ = new QProgressBar(this);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setShortcut(Qt::Key_Escape);
  cancel_->setToolTip(tr("Ends it and leaves nothing behind (Esc)"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(stage_, 0, 0);
  grid->addWidget(left_, 0, 1);
  grid->addWidget(bar_, 1, 0, 1, 2);
  grid->addWidget(cancel_, 1, 2);
  grid->setColumnStretch(0, 1);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    work_.cancel();
    cancel_->setEnabled(false);
    stage_->setText(tr("Stopping ..."));
    tick_.stop();
    left_->clear();
  });
  connect(&work_, &ImportWork::progressed, this, [this](const QString& stage, double share, double seconds) {
    stage_->setText(stage);
    seconds_left_ = seconds;
    reported_.start();
    show_left();
    bar_->setValue(static_cast<int>(1000.0 * share));
  });
  tick_.setInterval(500);
  connect(&tick_, &QTimer::timeout, this, &WorkStrip::show_left);
}

void WorkStrip::show_left() {
  if (!work_.busy()) tick_.stop();
  left_->setText(time_left_text(seconds_left_, 1e-3 * static_cast<double>(reported_.elapsed())));
}

void WorkStrip::begin(const QString& what) {
  stage_->setText(what);
  left_->clear();
  seconds_left_ = -1.0;
  reported_.start();
  tick_.start();
  bar_->setValue(0);
  cancel_->setEnabled(true);
}

}  // namespace vallecula::gui

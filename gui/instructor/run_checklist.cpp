#include "gui/instructor/run_checklist.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/session/words_from_below.h"

namespace vallecula::gui {

RunChecklist::RunChecklist(QWidget* parent) : QWidget(parent) {
  auto* inside = new QWidget(this);
  grid_ = new QGridLayout;
  grid_->setContentsMargins(0, 0, 6, 0);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(0, 1);
  auto* column_inside = new QVBoxLayout(inside);
  column_inside->setContentsMargins(0, 0, 0, 0);
  column_inside->addLayout(grid_);
  column_inside->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(inside);
  auto* all_in_all = new QHBoxLayout;
  all_in_all->setSpacing(4);
  all_in_all->addWidget(new QLabel(tr("All in all"), this));
  for (int step = 1; step <= 5; ++step) {
    QToolButton* button = tick(QString::number(step), QString());
    const QString words = in_words(curricula::kGlobalRatingWords[static_cast<std::size_t>(step - 1)]);
    button->setToolTip(tr("%1 of 5: %2").arg(step).arg(words));
    button->setAccessibleName(tr("All in all %1 of 5: %2").arg(step).arg(words));
    connect(button, &QToolButton::toggled, this, [this, button](bool on) {
      if (on)
        for (QToolButton* other : steps_)
          if (other != button) other->setChecked(false);
    });
    steps_.push_back(button);
    all_in_all->addWidget(button);
  }
  all_in_all->addStretch(1);
  keep_ = new QPushButton(tr("&Keep as my rating"), this);
  keep_->setObjectName("primary");
  keep_->setToolTip(tr("Once the trial is recorded: the ticks become your rating of it"));
  message_ = new QLabel(this);
  message_->setObjectName("checklist_message");
  message_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 4);
  column->setSpacing(6);
  column->addWidget(scroll, 1);
  column->addLayout(all_in_all);
  column->addWidget(message_);
  column->addWidget(keep_, 0, Qt::AlignRight);
  connect(keep_, &QPushButton::clicked, this, [this] {
    keep_->setEnabled(false);
    emit keep_wanted();
  });
  show_button();
}

QToolButton* RunChecklist::tick(const QString& text, const QString& meaning) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setCheckable(true);
  button->setStyleSheet("padding: 2px 9px;");  // a whole list is to be seen at once
  button->setFocusPolicy(Qt::StrongFocus);
  button->setAccessibleName(meaning);
  button->setToolTip(meaning);
  connect(button, &QToolButton::toggled, this, &RunChecklist::show_button);
  return button;
}

void RunChecklist::begin(const curricula::Scenario& scenario) {
  delete rows_widget_;
  rows_.clear();
  rows_widget_ = new QWidget(this);
  auto* grid = new QGridLayout(rows_widget_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  for (const curricula::ChecklistItem& item : curricula::checklist_to_watch(scenario)) {
    Row row;
    row.id = item.id;
    row.text = in_words(item.text);
    auto* text = new QLabel(row.text, rows_widget_);
    text->setWordWrap(true);
    row.yes = tick(tr("Yes"), tr("%1: yes").arg(row.text));
    row.no = tick(tr("No"), tr("%1: no").arg(row.text));
    for (const auto& [one, other] : {std::pair(row.yes, row.no), std::pair(row.no, row.yes)})
      connect(one, &QToolButton::toggled, other, [other = other](bool on) {
        if (on) other->setChecked(false);
      });
    row.recording = new QLabel(rows_widget_);
    row.recording->setObjectName("faint");
    const int at = static_cast<int>(rows_.size());
    grid->addWidget(text, at, 0);
    grid->addWidget(row.yes, at, 1);
    grid->addWidget(row.no, at, 2);
    grid->addWidget(row.recording, at, 3);
    rows_.push_back(row);
  }
  grid_->addWidget(rows_widget_, 0, 0);
  for (QToolButton* step : steps_) step->setChecked(false);
  may_keep_ = false;
  message_->setText(tr("Tick while you watch; ticked again, it is open."));
  show_button();
}

void RunChecklist::recorded(const std::vector<curricula::ChecklistItem>& decided, const QString& why_not) {
  for (const curricula::ChecklistItem& item : decided)
    for (Row& row : rows_)
      if (row.id == item.id && item.done != curricula::ChecklistItem::Done::not_seen) {
        const bool yes = item.done == curricula::ChecklistItem::Done::yes;
        row.decided = true;
        row.recording->setText(yes ? tr("recorded: yes") : tr("recorded: no"));
        row.recording->setToolTip(in_words(item.sentence));
      }
  may_keep_ = why_not.isEmpty();
  message_->setText(may_keep_ ? tr("Recorded. What the recording could not tell is yours to give.") : why_not);
  show_button();
}

std::vector<curricula::Rating> RunChecklist::ratings() const {
  std::vector<curricula::Rating> ratings;
  for (std::size_t i = 0; i < steps_.size(); ++i)
    if (steps_[i]->isChecked()) ratings.push_back({"instructor", curricula::kGlobalRating, static_cast<double>(i + 1)});
  for (const Row& row : rows_)
    if (!row.decided && (row.yes->isChecked() || row.no->isChecked()))
      ratings.push_back({"instructor", row.id, row.yes->isChecked() ? 1.0 : 0.0});
  return ratings;
}

void RunChecklist::show_button() { keep_->setEnabled(may_keep_ && !ratings().empty()); }

void RunChecklist::kept() {
  message_->setText(tr("The rating is kept."));
  show_button();  // changed, it may be kept again: a newer one takes the older one's place
}

void RunChecklist::refuse(const QString& message) {
  message_->setText(message);
  show_button();
}

}  // namespace vallecula::gui

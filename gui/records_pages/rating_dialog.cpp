#include "gui/records_pages/rating_dialog.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVariant>
#include <cmath>

#include "curricula/score/checklist.h"
#include "gui/session/words_from_below.h"

namespace vallecula::gui {
namespace {

constexpr int kNotJudged = 2;  // beside 0, not done, and 1, done

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName("heading");
  label->setWordWrap(true);
  return label;
}

}  // namespace

RatingDialog::RatingDialog(QWidget* parent, const QString& trial, const std::vector<Item>& items,
                           const std::map<std::string, double>& before, const QString& remark)
    : QDialog(parent) {
  setWindowTitle(tr("Rate a trial"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(22, 18, 22, 16);
  column->setSpacing(8);
  column->addWidget(heading(trial, this));
  auto* say = new QLabel(tr("The trainee sees your rating beside the figures. A newer one takes its place."), this);
  say->setObjectName("faint");
  say->setWordWrap(true);
  column->addWidget(say);
  add_global(column, before);
  if (!items.empty()) add_items(column, items, before);
  if (!remark.isEmpty()) {
    auto* why = new QLabel(tr("Without the checklist: %1").arg(remark), this);
    why->setObjectName("faint");
    why->setWordWrap(true);
    column->addSpacing(8);
    column->addWidget(why);
  }
  message_ = new QLabel(this);
  message_->setObjectName("dialog_message");
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  column->addWidget(message_);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setAutoDefault(false);
  take_ = new QPushButton(tr("&Keep the rating"), this);
  take_->setObjectName("primary");
  take_->setDefault(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(cancel);
  buttons->addStretch(1);
  buttons->addWidget(take_);
  column->addLayout(buttons);
  setMinimumWidth(620);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(take_, &QPushButton::clicked, this, [this] {
    if (ratings().empty()) return refuse(tr("Nothing is judged yet: choose one of the five steps, or yes or no."));
    message_->clear();
    take_->setEnabled(false);
    emit given();
  });
}

void RatingDialog::add_global(QVBoxLayout* column, const std::map<std::string, double>& before) {
  global_ = new QButtonGroup(this);
  column->addSpacing(8);
  column->addWidget(heading(tr("How was it, all in all?  (Alt+1 to Alt+5)"), this));
  for (int step = 1; step <= 5; ++step) {
    auto* button =
        new QRadioButton(QString("&%1  %2").arg(step).arg(in_words(curricula::kGlobalRatingWords[step - 1])), this);
    global_->addButton(button, step);
    column->addWidget(button);
  }
  if (const auto found = before.find(curricula::kGlobalRating); found != before.end())
    if (auto* given = global_->button(static_cast<int>(std::lround(found->second)))) given->setChecked(true);
}

void RatingDialog::add_items(QVBoxLayout* column, const std::vector<Item>& items,
                             const std::map<std::string, double>& before) {
  column->addSpacing(8);
  column->addWidget(heading(tr("What the recording could not tell"), this));
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  for (const Item& item : items) {
    const int row = static_cast<int>(items_.size());
    auto* text = new QLabel(item.text, this);
    text->setWordWrap(true);
    grid->addWidget(text, row, 0);
    auto* group = new QButtonGroup(this);
    const auto found = before.find(item.id);
    const int chosen = found == before.end() ? kNotJudged : found->second != 0.0 ? 1 : 0;
    int place = 1;
    for (const auto& [words, id] :
         {std::pair(tr("Yes"), 1), std::pair(tr("No"), 0), std::pair(tr("Not judged"), kNotJudged)}) {
      auto* button = new QRadioButton(words, this);
      button->setAccessibleName(item.text + ": " + words);
      button->setChecked(id == chosen);
      button->setEnabled(id != kNotJudged || chosen == kNotJudged);  // what was given can be changed, not taken back
      group->addButton(button, id);
      grid->addWidget(button, row, place++);
    }
    items_.emplace_back(item.id, group);
  }
  column->addLayout(grid);
}

std::vector<curricula::Rating> RatingDialog::ratings() const {
  std::vector<curricula::Rating> ratings;
  if (global_->checkedId() > 0)
    ratings.push_back({"instructor", curricula::kGlobalRating, static_cast<double>(global_->checkedId())});
  for (const auto& [id, group] : items_)
    if (group->checkedId() != kNotJudged)
      ratings.push_back({"instructor", id, static_cast<double>(group->checkedId())});
  return ratings;
}

void RatingDialog::refuse(const QString& message) {
  message_->setText(message);
  take_->setEnabled(true);
}

}  // namespace vallecula::gui

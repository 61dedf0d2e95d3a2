#include "gui/pages/self_rating_page.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

#include "curricula/score/checklist.h"
#include "gui/session/words_from_below.h"
#include "gui/views/capitalised.h"

namespace vallecula::gui {
namespace {

constexpr int kYes = 1, kNo = 2;

}  // namespace

SelfRatingPage::SelfRatingPage(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  title_ = new QLabel(this);
  title_->setObjectName("title");
  auto* before = new QLabel(tr("Before you see the score: what do you think yourself? Your answer is kept with the "
                               "trial and cannot be changed."),
                            this);
  before->setObjectName("faint");
  before->setWordWrap(true);
  global_ = new QButtonGroup(this);
  place_ = new QButtonGroup(this);
  sure_ = new QButtonGroup(this);
  auto* panel = new QFrame(this);
  panel->setObjectName("panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(22, 18, 22, 18);
  column->setSpacing(10);
  const auto heading = [](const QString& text, QWidget* of, QVBoxLayout* into) {
    auto* label = new QLabel(text, of);
    label->setObjectName("heading");
    label->setWordWrap(true);
    into->addWidget(label);
  };
  const auto choice = [this](const QString& text, QButtonGroup* group, int id, QWidget* of) {
    auto* button = new QRadioButton(text, of);
    button->setFocusPolicy(Qt::TabFocus);
    group->addButton(button, id);
    connect(button, &QRadioButton::toggled, this, &SelfRatingPage::show_button);
    return button;
  };
  heading(tr("How did you do, all in all?  (keys 1 to 5)"), panel, column);
  // The instructor's scale: the two are read beside each other.
  for (std::size_t i = 0; i < curricula::kGlobalRatingWords.size(); ++i) {
    const int value = static_cast<int>(i) + 1;
    column->addWidget(choice(QString("%1  %2").arg(value).arg(capitalised(in_words(curricula::kGlobalRatingWords[i]))),
                             global_, value, panel));
  }
  of_tube_ = new QWidget(panel);
  auto* tube = new QVBoxLayout(of_tube_);
  tube->setContentsMargins(0, 10, 0, 0);
  tube->setSpacing(10);
  heading(tr("Did the tube go into the trachea, and is it still there?  (Y, N)"), of_tube_, tube);
  auto* place = new QHBoxLayout;
  place->addWidget(choice(tr("Yes"), place_, kYes, of_tube_));
  place->addWidget(choice(tr("No"), place_, kNo, of_tube_));
  place->addStretch(1);
  tube->addLayout(place);
  heading(tr("Are you sure of that?  (S, U)"), of_tube_, tube);
  auto* sure = new QHBoxLayout;
  sure->addWidget(choice(tr("Sure"), sure_, kYes, of_tube_));
  sure->addWidget(choice(tr("Unsure"), sure_, kNo, of_tube_));
  sure->addStretch(1);
  tube->addLayout(sure);
  column->addWidget(of_tube_);
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  done_ = new QPushButton(tr("Show the score"), this);
  done_->setObjectName("primary");
  done_->setToolTip(tr("Enter"));
  connect(done_, &QPushButton::clicked, this, [this] {
    keeping_ = true;
    show_button();
    emit rated(answer());
  });
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(120, 40, 120, 40);
  all->setSpacing(12);
  all->addWidget(title_);
  all->addWidget(before);
  all->addWidget(panel);
  all->addWidget(message_);
  all->addWidget(done_, 0, Qt::AlignRight);
  all->addStretch(1);
}

void SelfRatingPage::ask(const curricula::Scenario& scenario) {
  title_->setText(course_words(scenario.title));
  with_tube_ = scenario.intubation.has_value();
  of_tube_->setVisible(with_tube_);
  for (QButtonGroup* group : {global_, place_, sure_}) {
    group->setExclusive(false);  // else the last choice stays
    for (auto* button : group->buttons()) button->setChecked(false);
    group->setExclusive(true);
  }
  asked_to_stay_ = false;
  set_message("");
  setFocus();
}

void SelfRatingPage::set_message(const QString& message) {
  message_->setText(message);
  keeping_ = false;
  show_button();
}

bool SelfRatingPage::may_close() {
  if (keeping_ || asked_to_stay_) return !keeping_;
  asked_to_stay_ = true;
  set_message(
      tr("The trial is over and counts. Your own rating is still missing: give it now. After closing the window once "
         "more, "
         "Records asks whose trial it is for it before anything of the trial is shown."));
  return false;
}

void SelfRatingPage::show_button() {
  done_->setEnabled(!keeping_ && global_->checkedId() > 0 &&
                    (!with_tube_ || (place_->checkedId() > 0 && sure_->checkedId() > 0)));
}

SelfRating SelfRatingPage::answer() const {
  SelfRating rating;
  rating.global = global_->checkedId();
  if (with_tube_) {
    rating.tube_in_trachea = place_->checkedId() == kYes;
    rating.sure = sure_->checkedId() == kYes;
  }
  return rating;
}

void SelfRatingPage::keyPressEvent(QKeyEvent* event) {
  const auto check = [](QButtonGroup* group, int id) { group->button(id)->setChecked(true); };
  const int number = event->key() - Qt::Key_0;
  if (number >= 1 && number <= static_cast<int>(curricula::kGlobalRatingWords.size()))
    check(global_, number);
  else if (with_tube_ && (event->key() == Qt::Key_Y || event->key() == Qt::Key_N))
    check(place_, event->key() == Qt::Key_Y ? kYes : kNo);
  else if (with_tube_ && (event->key() == Qt::Key_S || event->key() == Qt::Key_U))
    check(sure_, event->key() == Qt::Key_S ? kYes : kNo);
  else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    done_->click();
  else
    QWidget::keyPressEvent(event);
}

}  // namespace vallecula::gui

#include "gui/pages/distraction_panel.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/pages/wrap_row.h"
#include "gui/report/markdown.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

using DistractionKind = curricula::Distraction::Kind;

constexpr int kBeepMs = 1500;
constexpr int kBarSteps = 1000;
constexpr double kHeight = 150.0;  // of a question and one more; what is seen beside it must not jump
constexpr int kLeastLines = 3;     // of a sentence, where all else has its least room too
constexpr int kFirstAnswer = Qt::Key_1, kLastAnswer = Qt::Key_9, kSilence = Qt::Key_M;

QColor colour_of(DistractionKind kind) {
  return kind == DistractionKind::alarm      ? theme::bad()
         : kind == DistractionKind::question ? theme::device()
                                             : theme::faint();
}

QString name_of(DistractionKind kind) {
  return kind == DistractionKind::alarm      ? DistractionPanel::tr("Alarm")
         : kind == DistractionKind::question ? DistractionPanel::tr("Question")
                                             : DistractionPanel::tr("The team talks");
}

QString headed(const QString& who, const QColor& colour, const QString& text) {
  return QString("<b style='color:%1'>%2</b> &nbsp;").arg(colour.name(), who) +
         text.toHtmlEscaped().replace('\n', "<br>");
}

QFont larger(QFont font) {
  font.setPointSizeF(theme::points(11.0));
  return font;
}

}  // namespace

DistractionPanel::DistractionPanel(QWidget* parent) : QFrame(parent) {
  setObjectName("panel");
  setAccessibleName(tr("Messages of the team"));
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(10, 8, 10, 8);
  column_->setSpacing(6);
  idle_ = new QLabel(this);
  idle_->setObjectName("faint");
  idle_->setWordWrap(true);
  idle_->setTextFormat(Qt::PlainText);  // an instructor's words are no markup
  column_->addWidget(idle_);
  said_ = new QLabel(this);
  said_->setObjectName("said");
  said_->setTextFormat(Qt::RichText);
  said_->setWordWrap(true);
  said_->hide();
  column_->addWidget(said_);
  said_for_.setSingleShot(true);
  said_for_.setInterval(kSaidMs);
  connect(&said_for_, &QTimer::timeout, this, [this] {
    said_->hide();
    const bool asks = task_ != nullptr && !task_->distractions().empty();  // how to answer stays to be read
    idle_->setText((asks ? asked_ + '\n' : QString()) + tr("Said before: %1").arg(line_));
    idle_->setVisible(rows_.empty());
    emit silent();
  });
  serve(nullptr, false);
  column_->addStretch(1);
}

void DistractionPanel::serve(DualTask* task, bool by_person) {
  for (const Row& row : rows_) delete row.widget;
  rows_.clear();
  task_ = task;
  by_person_ = by_person;
  said_for_.stop();
  said_->hide();
  const bool asks = task_ != nullptr && !task_->distractions().empty();
  idle_->setText(
      asks ? tr("You will be asked things meanwhile, here. Keys 1 to 6 answer, M silences an alarm; talk asks "
                "for nothing.")
           : tr("Nobody has said anything. An instructor's words come up here."));
  asked_ = idle_->text();
  idle_->show();
}

// A dock takes no height for width: its panel says how high it is in the width it has, or is about to have.
QSize DistractionPanel::sizeHint() const {
  const bool asks = task_ != nullptr && !task_->distractions().empty();
  const int wide = width() < window()->width() / 4 ? window()->width() / 3 : width();
  return {QFrame::sizeHint().width(),
          std::max(layout()->heightForWidth(wide), asks ? static_cast<int>(theme::points(kHeight)) : 0)};
}

QSize DistractionPanel::minimumSizeHint() const {
  const bool asks = task_ != nullptr && !task_->distractions().empty();
  const QMargins around = layout()->contentsMargins();
  const int some = kLeastLines * QFontMetrics(larger(font())).lineSpacing() + around.top() + around.bottom();
  return {QFrame::minimumSizeHint().width(), asks ? sizeHint().height() : std::min(sizeHint().height(), some)};
}

void DistractionPanel::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) updateGeometry();
}

int DistractionPanel::first_of(DistractionKind kind) const {
  for (const Row& row : rows_)
    if (task_->distractions()[static_cast<std::size_t>(row.distraction - 1)].kind == kind) return row.distraction;
  return 0;
}

bool DistractionPanel::key(QKeyEvent* event, bool pressed) {
  if (task_ == nullptr || task_->distractions().empty()) return false;
  const int answer = event->key() - kFirstAnswer + 1;
  const bool number = event->key() >= kFirstAnswer && event->key() <= kLastAnswer;
  if ((!number && event->key() != kSilence) || event->modifiers().testFlag(Qt::ControlModifier)) return false;
  if (!pressed || event->isAutoRepeat() || !by_person_) return true;
  if (number)
    task_->answer(first_of(DistractionKind::question), answer);
  else
    task_->silence(first_of(DistractionKind::alarm));
  return true;
}

void DistractionPanel::say(const QString& line) {
  line_ = line;
  said_->setFont(larger(said_->font()));
  said_->setText(headed(tr("Instructor"), theme::target(), line));
  said_->show();
  idle_->hide();
  said_for_.start();
}

std::vector<KeyRow> DistractionPanel::keys() const {
  if (task_ == nullptr || task_->distractions().empty()) return {};
  return {{tr("%1 to %2").arg(key_name(kFirstAnswer), key_name(kLastAnswer)),
           tr("answers the question that has been open longest")},
          {key_name(kSilence), tr("silences the alarm that has been open longest")}};
}

DistractionPanel::Row DistractionPanel::make_row(const DualTask::Open& open, bool has_keys) {
  const int number = open.distraction;
  const curricula::Distraction& it = task_->distractions()[static_cast<std::size_t>(number - 1)];
  const QColor colour = colour_of(it.kind);
  Row row;
  row.distraction = number;
  row.widget = new QWidget(this);
  auto* inside = new QVBoxLayout(row.widget);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(4);
  auto* text = new QLabel(headed(name_of(it.kind), colour, plain_of(it.text)), row.widget);
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  text->setFont(larger(text->font()));
  inside->addWidget(text);
  if (it.kind == DistractionKind::talk) return row;
  auto* answers = new QWidget(row.widget);
  auto* buttons = new WrapRow(answers);
  buttons->setSpacing(6);
  const auto button = [&](const QString& label) {
    auto* made = new QPushButton(label, answers);
    made->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    made->setFocusPolicy(Qt::NoFocus);  // keys are the hands'
    made->setStyleSheet("padding: 5px 8px;");
    made->setEnabled(by_person_);
    buttons->addWidget(made);
    return made;
  };
  if (it.kind == DistractionKind::alarm) {
    connect(button(has_keys ? tr("Silence (M)") : tr("Silence")), &QPushButton::clicked, this,
            [this, number] { task_->silence(number); });
  } else {
    for (std::size_t a = 0; a < it.answers.size(); ++a) {
      const int answer = static_cast<int>(a) + 1;
      const QString words = plain_of(it.answers[a]);
      connect(button(has_keys ? QString("%1:  %2").arg(answer).arg(words) : words), &QPushButton::clicked, this,
              [this, number, answer] { task_->answer(number, answer); });
    }
  }
  inside->addWidget(answers);
  row.left = new QProgressBar(row.widget);
  row.left->setRange(0, kBarSteps);
  row.left->setTextVisible(false);
  row.left->setFixedHeight(7);
  row.left->setAccessibleName(tr("Time left"));
  row.left->setStyleSheet(
      QString("QProgressBar::chunk { background: %1; border-radius: 3px; } QProgressBar { border-radius: 3px; }")
          .arg(colour.name()));
  inside->addWidget(row.left);
  return row;
}

void DistractionPanel::refresh() {
  if (task_ == nullptr || task_->distractions().empty()) return;
  const std::vector<DualTask::Open> open = task_->open();
  const bool same =
      std::equal(open.begin(), open.end(), rows_.begin(), rows_.end(),
                 [](const DualTask::Open& o, const Row& row) { return o.distraction == row.distraction; });
  if (!same) {
    for (const Row& row : rows_) row.widget->deleteLater(), row.widget->hide();
    rows_.clear();
    bool question = false, alarm = false;
    for (const DualTask::Open& one : open) {
      const DistractionKind kind = task_->distractions()[static_cast<std::size_t>(one.distraction - 1)].kind;
      bool& taken = kind == DistractionKind::question ? question : alarm;
      rows_.push_back(make_row(one, !taken));
      if (kind != DistractionKind::talk) taken = true;
      column_->insertWidget(static_cast<int>(rows_.size()) - 1, rows_.back().widget);
    }
    idle_->setVisible(rows_.empty() && said_->isHidden());
  }
  for (std::size_t i = 0; i < open.size(); ++i)
    if (rows_[i].left != nullptr)
      rows_[i].left->setValue(static_cast<int>(kBarSteps * open[i].left_s / std::max(1e-3, open[i].of_s)));
  if (first_of(DistractionKind::alarm) != 0 && (!since_beep_.isValid() || since_beep_.elapsed() > kBeepMs)) {
    QApplication::beep();
    since_beep_.start();
  }
}

}  // namespace vallecula::gui

#include "gui/pages/big_choice.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace vallecula::gui {

BigChoice::BigChoice(QWidget* parent) : QPushButton(parent) {
  title_ = new QLabel(this);
  title_->setObjectName("heading");
  about_ = new QLabel(this);
  about_->setWordWrap(true);
  about_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  picture_ = new QLabel(this);
  picture_->hide();
  auto* words = new QVBoxLayout;
  words->setSpacing(4);
  words->addStretch(1);
  words->addWidget(title_);
  words->addWidget(about_);
  words->addStretch(1);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(18, 12, 18, 12);
  row->setSpacing(18);
  row->addWidget(picture_);
  row->addLayout(words, 1);
  for (QLabel* label : {title_, about_, picture_}) label->setAttribute(Qt::WA_TransparentForMouseEvents);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAutoDefault(true);
}

void BigChoice::say(const QString& title, const QString& about) {
  title_->setText(title);
  about_->setText(about);
  setAccessibleName(title);
  setAccessibleDescription(about);
  updateGeometry();
}

void BigChoice::show_picture(const QImage& picture, int height) {
  picture_->setVisible(!picture.isNull());
  if (picture.isNull()) return;
  const double dense = devicePixelRatioF();
  QPixmap drawn = QPixmap::fromImage(
      picture.scaledToHeight(static_cast<int>(height * dense), Qt::SmoothTransformation));
  drawn.setDevicePixelRatio(dense);
  picture_->setPixmap(drawn);
  updateGeometry();
}

// A push button asks its own text for its size; the words here are labels.
QSize BigChoice::sizeHint() const { return layout()->totalSizeHint(); }
QSize BigChoice::minimumSizeHint() const { return layout()->totalMinimumSize(); }

void BigChoice::changeEvent(QEvent* event) {
  QPushButton::changeEvent(event);
  if (event->type() == QEvent::EnabledChange)
    for (QLabel* label : {title_, about_, picture_}) label->setEnabled(isEnabled());
}

}  // namespace vallecula::gui

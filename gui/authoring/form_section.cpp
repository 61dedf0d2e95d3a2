#include "gui/authoring/form_section.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

namespace vallecula::gui {

FormSection::FormSection(const QString& title, const QString& help, QWidget* parent) : QWidget(parent) {
  head_ = new QToolButton(this);
  head_->setText(title);
  head_->setCheckable(true);
  head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  head_->setArrowType(Qt::RightArrow);
  head_->setProperty("role", "section");
  auto* about = new QLabel(help, this);
  about->setObjectName("faint");
  about->setWordWrap(true);
  body_ = new QWidget(this);
  body_layout_ = new QVBoxLayout(body_);
  body_layout_->setContentsMargins(14, 0, 0, 6);
  body_layout_->setSpacing(4);
  row_ = new QHBoxLayout;
  row_->addWidget(head_);
  row_->addWidget(about, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(2);
  column->addLayout(row_);
  column->addWidget(body_);
  body_->hide();
  connect(head_, &QToolButton::toggled, this, [this](bool on) {
    head_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    body_->setVisible(on);
    emit toggled(on);
  });
}

QToolButton* FormSection::add_button(const QString& text) {
  auto* button = new QToolButton(this);
  button->setText(text);
  row_->addWidget(button);
  return button;
}

void FormSection::open(bool on) { head_->setChecked(on); }
bool FormSection::is_open() const { return head_->isChecked(); }

}  // namespace vallecula::gui

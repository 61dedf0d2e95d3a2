#include "gui/authoring/number_box.h"

#include <QLineEdit>
#include <QLocale>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace vallecula::gui {
namespace {

/// A file's number as it is written here; what is no number stays.
QString shown(QString value) {
  bool is_number = false;
  value.toDouble(&is_number);
  return is_number ? value.replace('.', QLocale().decimalPoint()) : value;
}

}  // namespace

NumberBox::NumberBox(const curricula::FieldRule& rule, QWidget* parent)
    : QAbstractSpinBox(parent), minimum_(rule.minimum), maximum_(rule.maximum) {
  const double span = maximum_ - minimum_;
  step_ = rule.kind == curricula::FieldRule::Kind::whole_number ? 1.0
          : span <= 1.0                                         ? 0.01
          : span <= 60.0                                        ? 0.1
          : span <= 700.0                                       ? 1.0
                                                                : 100.0;
  setFocusPolicy(Qt::StrongFocus);
  setFixedWidth(120);
  lineEdit()->setPlaceholderText(rule.required ? "" : tr("left out"));
  connect(lineEdit(), &QLineEdit::textEdited, this, &NumberBox::edited);
}

QString NumberBox::value() const {
  QString text = lineEdit()->text().trimmed();
  bool is_number = false;
  QString pointed = text;
  pointed.replace(',', '.').toDouble(&is_number);
  return is_number ? pointed.replace(',', '.') : text;
}

void NumberBox::set_value(const QString& value) {
  if (this->value() != value) lineEdit()->setText(shown(value));
}

void NumberBox::stepBy(int steps) {
  bool is_number = false;
  const double now = value().toDouble(&is_number);
  const double next = is_number ? now + steps * step_ : minimum_;
  const double rounded = std::round(std::clamp(next, minimum_, maximum_) / step_) * step_;
  lineEdit()->setText(shown(QString::number(std::clamp(rounded, minimum_, maximum_), 'g', 8)));
  emit edited();
}

void NumberBox::wheelEvent(QWheelEvent* event) { event->ignore(); }

}  // namespace vallecula::gui

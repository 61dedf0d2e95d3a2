// A number with steps that shows whatever stands in the file, be it a number or not.
#pragma once

#include <QAbstractSpinBox>

#include "curricula/authoring/field_rules.h"

namespace vallecula::gui {

class NumberBox : public QAbstractSpinBox {
  Q_OBJECT
 public:
  /// Steps stay within the rule's range; what is typed does not, it is judged like the file.
  NumberBox(const curricula::FieldRule& rule, QWidget* parent);
  /// As it is to stand in the file: a comma that is meant as a point is one; empty: left out.
  QString value() const;
  void set_value(const QString& value);

 signals:
  void edited();

 protected:
  void stepBy(int steps) override;
  StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }
  QValidator::State validate(QString&, int&) const override { return QValidator::Acceptable; }
  void wheelEvent(QWheelEvent* event) override;  ///< scrolls the form, not the number

 private:
  double minimum_, maximum_, step_;
};

}  // namespace vallecula::gui

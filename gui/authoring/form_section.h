// A part of a form that opens and closes, for a group of fields.
#pragma once

#include <QWidget>

class QCheckBox;
class QHBoxLayout;
class QToolButton;
class QVBoxLayout;

namespace vallecula::gui {

class FormSection : public QWidget {
  Q_OBJECT
 public:
  FormSection(const QString& title, const QString& help, QWidget* parent);
  QVBoxLayout* body() const { return body_layout_; }
  /// A button beside the title.
  QToolButton* add_button(const QString& text);
  void open(bool on);
  bool is_open() const;

 signals:
  void toggled(bool open);

 private:
  QToolButton* head_;
  QHBoxLayout* row_;
  QWidget* body_;
  QVBoxLayout* body_layout_;
};

}  // namespace vallecula::gui

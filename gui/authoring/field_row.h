// One field of a form: label, editor by the field's kind, unit, what is allowed, and what is wrong with it.
#pragma once

#include <QWidget>
#include <functional>

#include "curricula/authoring/field_rules.h"
#include "curricula/authoring/yaml_text.h"

class QHBoxLayout;
class QLabel;

namespace vallecula::gui {

class FieldRow : public QWidget {
  Q_OBJECT
 public:
  /// `path` in the document; `choices` stand for the words of a list of ids.
  FieldRow(const curricula::FieldRule& rule, const QString& path, const QStringList& choices, QWidget* parent);
  const QString& path() const { return path_; }
  const curricula::FieldRule& rule() const { return rule_; }
  void show_value(const curricula::YamlNode* value);  ///< null: left out
  void show_problem(const QString& problem);          ///< empty: none
  QString problem() const;
  QWidget* editor() const { return editor_; }

 signals:
  void edited(const QString& path, const vallecula::curricula::YamlNode& value);
  void left_out(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_editor(const QStringList& choices);
  void make_number();
  void make_range();
  void make_word();
  void make_truth();
  void make_words(const QStringList& choices);
  void make_line();
  void make_text();
  void tell(const QString& scalar, bool is_text);

  curricula::FieldRule rule_;
  QString path_;
  QWidget* editor_ = nullptr;
  QLabel *problem_, *help_, *unit_ = nullptr;  ///< a unit where the editor is small
  QHBoxLayout *row_, *below_ = nullptr;        ///< the editor's, and the one below it
  bool help_is_below_ = false;
  std::function<void(const curricula::YamlNode*)> show_;
};

}  // namespace vallecula::gui

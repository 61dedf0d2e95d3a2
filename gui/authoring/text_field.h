// A text that trainees read: Markdown, in one language or several, with a preview.
#pragma once

#include <QWidget>

#include "curricula/authoring/yaml_text.h"

class QLabel;
class QPlainTextEdit;
class QTabBar;
class QToolButton;

namespace vallecula::gui {

class TextField : public QWidget {
  Q_OBJECT
 public:
  TextField(const QString& name, QWidget* parent);
  void show_value(const curricula::YamlNode* value);  ///< null: none
  curricula::YamlNode value() const;

 signals:
  void edited();

 private:
  void show_language(int tab);
  void add_language();
  void remove_language();
  void preview();
  QString ended(const QString& text) const;

  std::vector<std::pair<QString, QString>> texts_;  ///< by language code, English first
  bool ends_with_newline_ = true;
  QTabBar* languages_;
  QToolButton *add_, *remove_;
  QPlainTextEdit* editor_;
  QLabel* preview_;
};

}  // namespace vallecula::gui

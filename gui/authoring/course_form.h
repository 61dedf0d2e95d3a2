// The form of one course, module or scenario, made from the schema.
#pragma once

#include <QScrollArea>
#include <QSet>
#include <functional>
#include <vector>

#include "curricula/authoring/field_rules.h"
#include "gui/authoring/course_document.h"

class QVBoxLayout;

namespace vallecula::gui {

class FieldRow;
class FormSection;

class CourseForm : public QScrollArea {
  Q_OBJECT
 public:
  CourseForm(CourseDocument& document, QWidget* parent);
  /// "" (the course), "modules[1]" or "scenarios[3]".
  void show_part(const QString& path);
  const QString& part() const { return part_; }
  /// To the row of this field, or the nearest one; false: it is of another part.
  bool go_to(const QString& field);
  FieldRow* row(const QString& path) const;  ///< null: none

 signals:
  void refused(const QString& why);

 private:
  void refresh();
  void rebuild();
  QString focused_field() const;  ///< empty: the hand is elsewhere
  void show_problems();
  void add_fields(const std::vector<curricula::FieldRule>& rules, const QString& path, QVBoxLayout* layout);
  void add_group(const curricula::FieldRule& rule, const QString& path, QVBoxLayout* layout);
  void add_groups(const curricula::FieldRule& rule, const QString& path, QVBoxLayout* layout);
  FormSection* add_section(const QString& title, const QString& help, const QString& path, QVBoxLayout* layout,
                           bool open);
  void add_list_buttons(FormSection* section, const QString& list, std::size_t index, std::size_t count);
  void add_row(const curricula::FieldRule& rule, const QString& path, QVBoxLayout* layout);
  void set_value(const QString& path, const curricula::YamlNode& value);
  void leave_out(const QString& path);
  /// Runs an edit; what it cannot do is told.
  void edit(const std::function<std::string(const curricula::YamlText&)>& change, const QString& what,
            const QString& merge = {});
  QString shape() const;  ///< which groups and entries there are: another one needs another form

  CourseDocument& document_;
  QString part_, shape_;
  std::vector<FieldRow*> rows_;
  std::vector<std::pair<QString, FormSection*>> sections_;
  QSet<QString> opened_, closed_;  ///< sections by the person's own hand
};

}  // namespace vallecula::gui

#include "gui/authoring/course_form.h"

#include <QApplication>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "curricula/authoring/course_edit.h"
#include "curricula/authoring/yaml_edit.h"
#include "curricula/schema/schema_text.h"
#include "gui/authoring/field_row.h"
#include "gui/authoring/field_words.h"
#include "gui/authoring/form_section.h"

namespace vallecula::gui {

using curricula::FieldRule;
using curricula::YamlNode;
using curricula::YamlText;
using Kind = curricula::FieldRule::Kind;

namespace {

QString joined(const QString& path, const QString& name) { return path.isEmpty() ? name : path + "." + name; }
QString at(const QString& list, std::size_t index) { return list + "[" + QString::number(index) + "]"; }

bool asks_for_something(const FieldRule& group) {
  return std::any_of(group.fields.begin(), group.fields.end(), [](const FieldRule& rule) { return rule.required; });
}

/// What a new group or entry begins with: its required fields, at the least that is allowed, or a term infant's.
YamlNode beginning(const FieldRule& rule) {
  switch (rule.kind) {
    case Kind::group:
    case Kind::groups: {
      std::vector<std::pair<std::string, YamlNode>> fields;
      for (const FieldRule& field : rule.fields)
        if (field.required) fields.emplace_back(field.name.toStdString(), beginning(field));
      return curricula::yaml_group(std::move(fields));
    }
    case Kind::number:
    case Kind::whole_number:
      return curricula::yaml_plain(rule.name == "gestation_weeks" ? "40"
                                   : rule.name == "below_kg"      ? "5"
                                                                  : QString::number(rule.minimum).toStdString());
    // The last word asks for the least: talk before a question, the delivery room before a calibrated course.
    case Kind::word:
      return curricula::yaml_text(rule.words.last().toStdString());
    case Kind::truth:
      return curricula::yaml_plain("false");
    default:
      return curricula::yaml_text(rule.name == "source" ? "assumed" : "To be written.");
  }
}

void shape_of(const YamlNode& node, const QString& path, QString& out) {
  if (node.kind == YamlNode::Kind::scalar) return;
  const bool text_by_language = node.child("en") != nullptr;
  out += path + (node.kind == YamlNode::Kind::list ? QString("#%1;").arg(node.children.size()) : QString(";"));
  if (text_by_language) return;
  for (std::size_t i = 0; i < node.children.size(); ++i)
    shape_of(node.children[i], path + "/" + QString::fromStdString(node.children[i].key), out);
}

}  // namespace

CourseForm::CourseForm(CourseDocument& document, QWidget* parent) : QScrollArea(parent), document_(document) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  connect(&document_, &CourseDocument::changed, this, &CourseForm::refresh);
  connect(&document_, &CourseDocument::problems_changed, this, &CourseForm::show_problems);
}

void CourseForm::show_part(const QString& path) {
  if (QWidget* focus = QApplication::focusWidget(); focus != nullptr && isAncestorOf(focus))
    focus->clearFocus();  // an id that was being typed is taken as it is
  document_.end_merging();
  part_ = path;
  rebuild();
  verticalScrollBar()->setValue(0);
}

QString CourseForm::shape() const {
  const YamlText* text = document_.yaml();
  const YamlNode* node = text == nullptr ? nullptr : text->find(part_.toStdString());
  if (node == nullptr) return {};
  QString shape = QString::number(document_.schema());
  if (!part_.isEmpty()) {
    shape_of(*node, "", shape);
    for (const std::string& id : curricula::ids_in(*text, "modules")) shape += "," + QString::fromStdString(id);
    return shape;
  }
  for (const YamlNode& child : node->children)  // modules and scenarios have forms of their own
    if (child.key != "modules" && child.key != "scenarios") shape_of(child, QString::fromStdString(child.key), shape);
  return shape;
}

void CourseForm::refresh() {
  const YamlText* text = document_.yaml();
  if (widget() != nullptr) widget()->setEnabled(text != nullptr);
  if (text == nullptr) return;  // the last form stays to be seen until the text can be read again
  if (shape() != shape_) {
    // Not now: it may be one of the form's own fields that tells of the change.
    QTimer::singleShot(0, this, [this] {
      if (shape() != shape_) rebuild();
    });
  }
  for (FieldRow* row : rows_) row->show_value(text->find(row->path().toStdString()));
}

QString CourseForm::focused_field() const {
  const QWidget* focus = QApplication::focusWidget();
  if (focus == nullptr || !isAncestorOf(focus)) return {};
  for (const FieldRow* row : rows_)
    if (row->isAncestorOf(focus)) return row->path();
  return {};
}

void CourseForm::rebuild() {
  const int scrolled = verticalScrollBar()->value();
  const QString focused = focused_field();
  rows_.clear();
  sections_.clear();
  shape_ = shape();
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(4, 4, 14, 12);
  layout->setSpacing(4);
  const char* schema = document_.schema() == 1 ? curricula::curriculum_schema_1() : curricula::curriculum_schema_2();
  const QString definition = part_.isEmpty() ? "curriculum" : part_.startsWith("modules") ? "module" : "scenario";
  if (!shape_.isEmpty())
    add_fields(fields_in_words(schema, definition, {"schema", "modules", "scenarios", "attempt"}), part_, layout);
  layout->addStretch(1);
  if (QWidget* old = takeWidget()) {
    old->hide();
    old->deleteLater();  // it may be one of its own fields that led here
  }
  setWidget(page);
  refresh();
  show_problems();
  if (FieldRow* again = row(focused)) again->editor()->setFocus();
  QTimer::singleShot(0, this, [this, scrolled] { verticalScrollBar()->setValue(scrolled); });
}

void CourseForm::add_fields(const std::vector<FieldRule>& rules, const QString& path, QVBoxLayout* layout) {
  for (const FieldRule& rule : rules) {
    const QString here = joined(path, rule.name);
    if (rule.kind == Kind::group)
      add_group(rule, here, layout);
    else if (rule.kind == Kind::groups || rule.kind == Kind::texts)
      add_groups(rule, here, layout);
    else
      add_row(rule, here, layout);
  }
}

FormSection* CourseForm::add_section(const QString& title, const QString& help, const QString& path,
                                     QVBoxLayout* layout, bool open) {
  auto* section = new FormSection(title, help, layout->parentWidget());
  section->setObjectName("section:" + path);
  layout->addWidget(section);
  sections_.emplace_back(path, section);
  section->open((open || opened_.contains(path)) && !closed_.contains(path));
  connect(section, &FormSection::toggled, this, [this, path](bool on) {
    (on ? opened_ : closed_) << path;
    (on ? closed_ : opened_).remove(path);
  });
  return section;
}

void CourseForm::add_group(const FieldRule& rule, const QString& path, QVBoxLayout* layout) {
  const bool there = document_.yaml()->find(path.toStdString()) != nullptr;
  const bool optional = !rule.required && asks_for_something(rule);
  FormSection* section = add_section(rule.label + (rule.required ? " *" : ""),
                                     there || rule.required ? rule.help
                                     : rule.help.isEmpty()  ? tr("left out")
                                                            : tr("%1 (left out)").arg(rule.help),
                                     path, layout, rule.required || (there && rule.name != "rubric"));
  if (optional) {
    QToolButton* button = section->add_button(there ? tr("Leave out") : tr("Add"));
    button->setObjectName((there ? "leave:" : "add:") + path);
    connect(button, &QToolButton::clicked, this, [this, rule, path, there] {
      if (!there) opened_ << path;
      if (there)
        leave_out(path);
      else
        set_value(path, beginning(rule));
    });
    if (!there) return;
  }
  add_fields(rule.fields, path, section->body());
}

void CourseForm::add_groups(const FieldRule& rule, const QString& path, QVBoxLayout* layout) {
  const YamlNode* list = document_.yaml()->find(path.toStdString());
  const std::size_t count = list == nullptr ? 0 : list->children.size();
  FormSection* section = add_section(QString("%1 (%2)").arg(rule.label).arg(count), rule.help, path, layout, count > 0);
  QToolButton* add = section->add_button(tr("Add one"));
  add->setObjectName("add:" + path);
  connect(add, &QToolButton::clicked, this, [this, rule, path, count] {
    opened_ << path;
    edit(
        [&](const YamlText& text) {
          const std::string where = path.toStdString();
          if (count > 0 && rule.kind == Kind::groups)  // the last one again, for most stays as it is
            return curricula::with_item_copied(text, where, count, text, where, count - 1);
          return curricula::with_item(text, where, count, beginning(rule));
        },
        tr("Add to %1").arg(rule.label));
  });
  for (std::size_t i = 0; i < count; ++i) {
    const QString here = at(path, i), title = QString("%1.").arg(i + 1);
    if (rule.kind == Kind::groups) {
      FormSection* one = add_section(title, "", here, section->body(), true);
      add_list_buttons(one, path, i, count);
      add_fields(rule.fields, here, one->body());
    } else {
      FieldRule text = rule;
      text.kind = Kind::text;
      text.required = true;
      text.label = title;
      text.help.clear();
      FormSection* one = add_section(title, "", here, section->body(), true);
      add_list_buttons(one, path, i, count);
      add_row(text, here, one->body());
    }
  }
}

void CourseForm::add_list_buttons(FormSection* section, const QString& list, std::size_t index, std::size_t count) {
  const std::string where = list.toStdString();
  const auto move = [this, where, index](std::ptrdiff_t by) {
    edit(
        [&](const YamlText& text) {
          return curricula::with_item_moved(text, where, index,
                                            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) + by));
        },
        tr("Move"));
  };
  if (index > 0) connect(section->add_button(tr("Up")), &QToolButton::clicked, this, [move] { move(-1); });
  if (index + 1 < count) connect(section->add_button(tr("Down")), &QToolButton::clicked, this, [move] { move(1); });
  connect(section->add_button(tr("Remove")), &QToolButton::clicked, this, [this, where, index] {
    edit([&](const YamlText& text) { return curricula::without_item(text, where, index); }, tr("Remove"));
  });
}

void CourseForm::add_row(const FieldRule& rule, const QString& path, QVBoxLayout* layout) {
  QStringList modules;
  if (rule.name == "after")
    for (const std::string& id : curricula::ids_in(*document_.yaml(), "modules"))
      if (const YamlNode* own = document_.yaml()->find((part_ + ".id").toStdString());
          part_.startsWith("scenarios") || own == nullptr || own->value != id)
        modules << QString::fromStdString(id);
  auto* row = new FieldRow(rule, path, modules, layout->parentWidget());
  connect(row, &FieldRow::edited, this, &CourseForm::set_value);
  connect(row, &FieldRow::left_out, this, &CourseForm::leave_out);
  layout->addWidget(row);
  rows_.push_back(row);
}

void CourseForm::set_value(const QString& path, const YamlNode& value) {
  edit(
      [&](const YamlText& text) {
        if (!part_.isEmpty() && path == part_ + ".id")
          if (const YamlNode* old = text.find(path.toStdString()); old != nullptr && !old->value.empty())
            return curricula::with_id(text, part_.section('[', 0, 0).toStdString(), old->value, value.value);
        return curricula::with_value(text, path.toStdString(), value);
      },
      tr("Change %1").arg(curricula::label_of(path.section('.', -1)).toLower()), path);
}

void CourseForm::leave_out(const QString& path) {
  edit([&](const YamlText& text) { return curricula::without_value(text, path.toStdString()); },
       tr("Leave out %1").arg(curricula::label_of(path.section('.', -1)).toLower()), path);
}

void CourseForm::edit(const std::function<std::string(const YamlText&)>& change, const QString& what,
                      const QString& merge) {
  const YamlText* text = document_.yaml();
  if (text == nullptr) return;
  try {
    document_.set_bytes(change(*text), what, merge);
  } catch (const std::exception& error) {
    emit refused(QString::fromUtf8(error.what()));
    refresh();
  }
}

void CourseForm::show_problems() {
  for (FieldRow* row : rows_) {
    QStringList told;
    for (const curricula::Problem& problem : document_.problems()) {
      const QString field = QString::fromStdString(problem.field);
      if (field != row->path() && !field.startsWith(row->path() + "[") && !field.startsWith(row->path() + "."))
        continue;
      told << tr("is %1; allowed: %2")
                  .arg(QString::fromStdString(problem.value), QString::fromStdString(problem.allowed));
    }
    row->show_problem(told.join("\n"));
  }
}

FieldRow* CourseForm::row(const QString& path) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const FieldRow* row) { return row->path() == path; });
  return found == rows_.end() ? nullptr : *found;
}

bool CourseForm::go_to(const QString& field) {
  if (!part_.isEmpty() && !field.startsWith(part_)) return false;
  QString path = field;
  while (!path.isEmpty()) {
    for (auto& [name, section] : sections_)
      if (path == name || path.startsWith(name + ".") || path.startsWith(name + "[")) section->open(true);
    if (FieldRow* found = row(path)) {
      QTimer::singleShot(0, found, [this, found] {
        ensureWidgetVisible(found);
        found->editor()->setFocus();
      });
      return true;
    }
    path.truncate(std::max(0, std::max(path.lastIndexOf('.'), path.lastIndexOf('['))));
  }
  return true;
}

}  // namespace vallecula::gui

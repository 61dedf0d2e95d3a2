#include "gui/authoring/course_tree.h"

#include <QCoreApplication>
#include <QDropEvent>
#include <QKeyEvent>
#include <QTreeWidgetItemIterator>
#include <algorithm>

#include "curricula/authoring/course_edit.h"
#include "curricula/authoring/yaml_edit.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

using curricula::YamlNode;
using curricula::YamlText;

namespace {

constexpr int kPart = Qt::UserRole;

QString title_of(const YamlNode& node) {
  for (const char* field : {"title", "id"})
    if (const YamlNode* given = node.child(field); given != nullptr && !given->value.empty())
      return QString::fromStdString(given->value);
  return QCoreApplication::translate("CourseTree", "(no title)");
}

QString place(const char* list, std::size_t index) { return QString("%1[%2]").arg(list).arg(index); }

std::size_t index_in(const QString& part) { return part.section('[', 1).section(']', 0, 0).toULong(); }

}  // namespace

CourseTree::CourseTree(CourseDocument& document, QWidget* parent) : QTreeWidget(parent), document_(document) {
  setHeaderHidden(true);
  setAccessibleName(tr("Course, modules and scenarios"));
  setDragDropMode(QAbstractItemView::InternalMove);
  setDragEnabled(true);
  setDropIndicatorShown(true);
  connect(&document_, &CourseDocument::changed, this, &CourseTree::refresh);
  connect(&document_, &CourseDocument::problems_changed, this, &CourseTree::mark_problems);
  connect(this, &QTreeWidget::currentItemChanged, this, [this] {
    if (!refreshing_) emit chosen(part());
  });
}

QString CourseTree::part() const {
  return currentItem() == nullptr ? QString() : currentItem()->data(0, kPart).toString();
}

QTreeWidgetItem* CourseTree::item_of(const QString& part) const {
  for (QTreeWidgetItemIterator it(const_cast<CourseTree*>(this)); *it != nullptr; ++it)
    if ((*it)->data(0, kPart).toString() == part) return *it;
  return nullptr;
}

void CourseTree::choose(const QString& part) {
  if (QTreeWidgetItem* item = item_of(part)) setCurrentItem(item);
}

std::size_t CourseTree::module() const {
  for (QTreeWidgetItem* item = currentItem(); item != nullptr; item = item->parent())
    if (item->data(0, kPart).toString().startsWith("modules")) return index_in(item->data(0, kPart).toString());
  return 0;
}

void CourseTree::refresh() {
  const YamlText* text = document_.yaml();
  setEnabled(text != nullptr);
  if (text == nullptr) return;
  struct Row {
    int depth;
    QString part, title;
  };
  std::vector<Row> rows{{0, "", title_of(text->root())}};
  const YamlNode *modules = text->find("modules"), *scenarios = text->find("scenarios");
  const std::size_t count = scenarios == nullptr ? 0 : scenarios->children.size();
  std::vector<bool> shown(count, false);
  for (std::size_t m = 0; modules != nullptr && m < modules->children.size(); ++m) {
    rows.push_back({1, place("modules", m), title_of(modules->children[m])});
    const YamlNode* ids = modules->children[m].child("scenarios");
    for (std::size_t k = 0; ids != nullptr && k < ids->children.size(); ++k)
      for (std::size_t s = 0; s < count; ++s) {
        const YamlNode* id = scenarios->children[s].child("id");
        if (id == nullptr || id->value != ids->children[k].value || shown[s]) continue;
        shown[s] = true;
        rows.push_back({2, place("scenarios", s), title_of(scenarios->children[s])});
      }
  }
  for (std::size_t s = 0; s < count; ++s)
    if (!shown[s])
      rows.push_back({1, place("scenarios", s),
                      modules == nullptr ? title_of(scenarios->children[s])
                                         : tr("%1  (in no module)").arg(title_of(scenarios->children[s]))});
  QStringList described;
  for (const Row& row : rows) described << QString("%1 %2 %3").arg(row.depth).arg(row.part, row.title);
  if (described == rows_) return;
  rows_ = described;
  const QString before = part();
  refreshing_ = true;
  clear();
  QTreeWidgetItem* parents[3] = {nullptr, nullptr, nullptr};
  for (const Row& row : rows) {
    auto* item = row.depth == 0 ? new QTreeWidgetItem(this) : new QTreeWidgetItem(parents[row.depth - 1]);
    item->setText(0, row.title);
    item->setToolTip(0, row.title);
    item->setData(0, kPart, row.part);
    Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsDropEnabled;
    item->setFlags(row.depth == 0 ? flags : flags | Qt::ItemIsDragEnabled);
    if (row.depth == 0 || row.part.startsWith("modules")) {
      QFont font = item->font(0);
      font.setBold(true);
      item->setFont(0, font);
    }
    parents[row.depth] = item;
  }
  expandAll();
  QTreeWidgetItem* chosen_item = item_of(before);
  setCurrentItem(chosen_item != nullptr ? chosen_item : topLevelItem(0));
  refreshing_ = false;
  if (chosen_item == nullptr) emit chosen(part());
  mark_problems();
}

void CourseTree::mark_problems() {
  for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it) {
    const QString part = (*it)->data(0, kPart).toString();
    const bool wrong =
        std::any_of(document_.problems().begin(), document_.problems().end(), [&](const curricula::Problem& problem) {
          const QString field = QString::fromStdString(problem.field);
          const bool inner = field.startsWith("modules[") || field.startsWith("scenarios[");
          return part.isEmpty() ? !inner : field.startsWith(part);
        });
    (*it)->setForeground(0, wrong ? theme::over() : theme::text());
    (*it)->setToolTip(0, wrong ? tr("Something in it is not allowed: see below") : (*it)->text(0));
  }
}

void CourseTree::move_scenario(const QString& part, std::size_t module, std::size_t position) {
  const YamlText* text = document_.yaml();
  const YamlNode* id = text == nullptr ? nullptr : text->find((part + ".id").toStdString());
  if (id == nullptr) return;
  document_.end_merging();
  document_.set_bytes(curricula::with_scenario_moved(*text, id->value, module, position), tr("Move the scenario"));
  choose(part);
}

void CourseTree::shift(int by) {
  QTreeWidgetItem* item = currentItem();
  if (item == nullptr || item->parent() == nullptr || document_.yaml() == nullptr) return;
  const QString moved = part();
  try {
    QTreeWidgetItem* parent = item->parent();
    const int row = parent->indexOfChild(item), to = row + by;
    if (moved.startsWith("modules")) {
      const int index = static_cast<int>(index_in(moved)) + by,
                last = static_cast<int>(curricula::ids_in(*document_.yaml(), "modules").size()) - 1;
      if (index < 0 || index > last) return;
      document_.set_bytes(
          curricula::with_item_moved(*document_.yaml(), "modules", index_in(moved), static_cast<std::size_t>(index)),
          tr("Move the module"));
      choose(place("modules", static_cast<std::size_t>(index)));
    } else if (to >= 0 && to < parent->childCount()) {
      move_scenario(moved, module(), static_cast<std::size_t>(to));
    } else if (parent->parent() != nullptr) {  // over the module's end: into the next one
      const int next = parent->parent()->indexOfChild(parent) + by;
      if (next < 0 || next >= parent->parent()->childCount()) return;
      QTreeWidgetItem* other = parent->parent()->child(next);
      if (!other->data(0, kPart).toString().startsWith("modules")) return;
      move_scenario(moved, index_in(other->data(0, kPart).toString()),
                    by > 0 ? 0 : static_cast<std::size_t>(other->childCount()));
    }
  } catch (const std::exception& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
}

void CourseTree::dropEvent(QDropEvent* event) {
  QTreeWidgetItem *item = currentItem(), *target = itemAt(event->pos());
  const DropIndicatorPosition where = dropIndicatorPosition();
  event->setDropAction(Qt::IgnoreAction);  // the tree follows the text, which changes below
  event->accept();
  if (item == nullptr || target == nullptr || item == target || document_.yaml() == nullptr) return;
  const QString moved = part(), to = target->data(0, kPart).toString();
  try {
    const std::size_t below = where == QAbstractItemView::BelowItem ? 1 : 0;
    if (moved.startsWith("modules")) {
      QTreeWidgetItem* module = to.startsWith("scenarios") ? target->parent() : target;
      const QString name = module->data(0, kPart).toString();
      if (!name.startsWith("modules")) return;
      const std::size_t from = index_in(moved), last = curricula::ids_in(*document_.yaml(), "modules").size() - 1;
      std::size_t index = index_in(name) + (module == target ? below : 0);
      if (index > from) --index;
      document_.end_merging();
      document_.set_bytes(curricula::with_item_moved(*document_.yaml(), "modules", from, std::min(index, last)),
                          tr("Move the module"));
      choose(place("modules", std::min(index, last)));
    } else if (to.startsWith("modules")) {
      move_scenario(moved, index_in(to), static_cast<std::size_t>(target->childCount()));
    } else if (!to.isEmpty()) {
      QTreeWidgetItem* parent = target->parent();
      const auto row = static_cast<std::size_t>(parent->indexOfChild(target));
      std::size_t position = row + below;
      if (parent == item->parent() && static_cast<std::size_t>(parent->indexOfChild(item)) < position) --position;
      move_scenario(moved, index_in(parent->data(0, kPart).toString()), position);
    }
  } catch (const std::exception& error) {
    emit refused(QString::fromUtf8(error.what()));
  }
}

void CourseTree::keyPressEvent(QKeyEvent* event) {
  if (event->modifiers() == Qt::AltModifier && event->key() == Qt::Key_Up) return move_up();
  if (event->modifiers() == Qt::AltModifier && event->key() == Qt::Key_Down) return move_down();
  QTreeWidget::keyPressEvent(event);
}

}  // namespace vallecula::gui

#include "gui/pages/module_tree.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>

#include "gui/pages/module_words.h"
#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr int kTitle = 0, kState = 1;
/// What a row stands for: a scenario's id, a module's after a colon, which no id has.
constexpr int kKeyRole = Qt::UserRole;
const char* const kCourseKey = "::";
QString module_key(const std::string& id) { return ":" + QString::fromStdString(id); }

QTreeWidgetItem* row_in(QTreeWidgetItem* parent, const QString& title, const QString& key) {
  auto* row = new QTreeWidgetItem(parent);
  row->setText(kTitle, title);
  row->setToolTip(kTitle, title);  // a small window has no room for long ones
  row->setData(kTitle, kKeyRole, key);
  return row;
}

}  // namespace

ModuleTree::ModuleTree(QWidget* parent) : QTreeWidget(parent) {
  setAccessibleName(tr("Modules and scenarios"));
  setColumnCount(2);
  setHeaderHidden(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(kTitle, QHeaderView::Stretch);
  header()->setSectionResizeMode(kState, QHeaderView::ResizeToContents);
  setStyleSheet("QTreeView::item { padding: 6px 4px; }");
  setIndentation(18);
  connect(this, &QTreeWidget::currentItemChanged, this, &ModuleTree::chosen);
}

void ModuleTree::show_course(const curricula::Curriculum* course, const std::vector<curricula::PastResult>& past,
                             const std::string& hands, bool all_open) {
  const QString key = course == course_ ? chosen_key() : QString();
  {
    const QSignalBlocker quiet(this);
    clear();
    course_ = course;
    all_open_ = all_open;
    progress_.clear();
    if (course_ != nullptr) progress_ = curricula::progress_of(*course_, past, hands);
    if (course_ != nullptr && !course_->goals.empty())
      row_in(invisibleRootItem(), tr("About this course"), kCourseKey)->setForeground(kTitle, theme::faint());
    const bool alone = progress_.size() == 1;  // a course's only module needs no row of its own
    setRootIsDecorated(!alone);
    for (std::size_t m = 0; m < progress_.size(); ++m) {
      const curricula::Module& module = course_->modules[m];
      QTreeWidgetItem* row = invisibleRootItem();
      if (!alone) {
        row = row_in(row, QString("%1  %2").arg(m + 1).arg(course_words(module.title)), module_key(module.id));
        QFont font = row->font(kTitle);
        font.setBold(true);
        row->setFont(kTitle, font);
        row->setText(kState, state(m));
        row->setForeground(kState, progress_[m].mastered            ? theme::within().lighter(130)
                                   : progress_[m].open || all_open_ ? theme::text()
                                                                    : theme::faint());
      }
      for (const std::string& id : module.scenarios)
        add_scenario(row, id, std::any_of(past.begin(), past.end(), [&](const curricula::PastResult& result) {
                       return result.scenario_id == id && result.device_kind == hands && result.passed;
                     }));
      if (!alone) row->setExpanded((progress_[m].open || all_open_) && !progress_[m].mastered);
    }
    QTreeWidgetItem* before = key.isEmpty() ? nullptr : item_of(key);
    setCurrentItem(before != nullptr ? before : next_to_do());
  }
  emit chosen();
}

void ModuleTree::add_scenario(QTreeWidgetItem* to, const std::string& id, bool passed) {
  const curricula::Scenario& scenario = *course_->find(id);
  QTreeWidgetItem* row = row_in(to, course_words(scenario.title), QString::fromStdString(id));
  row->setText(kState, passed ? tr("passed") : QString());
  row->setForeground(kState, theme::within().lighter(130));
  if (!why_closed(scenario).isEmpty()) row->setForeground(kTitle, theme::faint());
}

void ModuleTree::choose(const std::string& scenario_id) {
  if (QTreeWidgetItem* item = item_of(QString::fromStdString(scenario_id))) setCurrentItem(item);
}

QString ModuleTree::chosen_key() const {
  return currentItem() != nullptr ? currentItem()->data(kTitle, kKeyRole).toString() : QString();
}

QTreeWidgetItem* ModuleTree::item_of(const QString& key) const {
  for (QTreeWidgetItemIterator it(const_cast<ModuleTree*>(this)); *it != nullptr; ++it)
    if ((*it)->data(kTitle, kKeyRole).toString() == key) return *it;
  return nullptr;
}

QTreeWidgetItem* ModuleTree::next_to_do() const {
  if (course_ == nullptr) return nullptr;
  for (const curricula::ModuleProgress& module : progress_)
    for (const std::string& id : module.open_scenarios) {
      QTreeWidgetItem* item = item_of(QString::fromStdString(id));
      if (item != nullptr && item->text(kState).isEmpty()) return item;
    }
  return item_of(QString::fromStdString(course_->modules.front().scenarios.front()));
}

const curricula::Scenario* ModuleTree::scenario() const {
  return course_ == nullptr ? nullptr : course_->find(chosen_key().toStdString());
}

const curricula::Module* ModuleTree::module() const {
  for (std::size_t m = 0; m < progress_.size(); ++m)
    if (module_key(course_->modules[m].id) == chosen_key()) return &course_->modules[m];
  return nullptr;
}

const curricula::ModuleProgress& ModuleTree::progress_of(const curricula::Module& module) const {
  return progress_.at(static_cast<std::size_t>(&module - course_->modules.data()));
}

QString ModuleTree::why_closed(const curricula::Scenario& scenario) const {
  return all_open_ ? QString() : gui::why_closed(*course_, progress_, scenario.id);
}

/// Closed by the course's rule, it may still be open to who looks: an instructor, or somebody who only watches.
QString ModuleTree::state(std::size_t module) const {
  const curricula::ModuleProgress& progress = progress_[module];
  return all_open_ && !progress.open && !progress.mastered ? tr("open to you") : state_of(progress);
}

QStringList ModuleTree::states() const {
  QStringList states;
  for (std::size_t m = 0; m < progress_.size(); ++m)
    states << course_words(course_->modules[m].title) + ": " + state(m);
  return states;
}

}  // namespace vallecula::gui

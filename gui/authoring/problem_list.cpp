#include "gui/authoring/problem_list.h"

#include <QHeaderView>

#include "curricula/authoring/field_rules.h"
#include "curricula/schema/schema_text.h"
#include "gui/authoring/field_words.h"

namespace vallecula::gui {

namespace {

constexpr int kField = Qt::UserRole, kLine = Qt::UserRole + 1;
constexpr int kMost = 200;  ///< rows; the rest is counted

}  // namespace

ProblemList::ProblemList(CourseDocument& document, QWidget* parent) : QTreeWidget(parent), document_(document) {
  setAccessibleName(tr("Problems"));
  setHeaderLabels({tr("Line"), tr("Where"), tr("Is"), tr("Allowed")});
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  header()->setSectionResizeMode(QHeaderView::Interactive);
  header()->resizeSection(0, 50);
  header()->resizeSection(1, 380);
  header()->resizeSection(2, 200);
  connect(&document_, &CourseDocument::problems_changed, this, &ProblemList::refresh);
  const auto go = [this](QTreeWidgetItem* item) {
    emit wanted(item->data(0, kField).toString(), item->data(0, kLine).toInt());
  };
  connect(this, &QTreeWidget::itemClicked, this, go);
  connect(this, &QTreeWidget::itemActivated, this, go);
}

QString ProblemList::place_of(const curricula::Problem& problem) const {
  static const std::vector<curricula::FieldRule> course =
      fields_in_words(curricula::curriculum_schema_2(), "curriculum");
  const std::vector<curricula::FieldRule>* rules = &course;
  QStringList words;
  std::string path;
  const curricula::YamlText* text = document_.yaml();
  for (const curricula::YamlStep& step : curricula::yaml_steps(problem.field)) {
    path += step.key.empty() ? "[" + std::to_string(step.index) + "]" : (path.empty() ? "" : ".") + step.key;
    if (!step.key.empty()) {
      const QString name = QString::fromStdString(step.key);
      const curricula::FieldRule* found = nullptr;
      for (const curricula::FieldRule& rule : *rules)
        if (rule.name == name) found = &rule;
      words << (found == nullptr ? curricula::label_of(name) : found->label);  // as the form calls it
      if (found != nullptr) rules = &found->fields;
    } else if (!words.isEmpty()) {
      const curricula::YamlNode* title = text == nullptr ? nullptr : text->find(path + ".title");
      words.last() = title != nullptr && !title->value.empty() ? QString::fromStdString(title->value)
                                                               : QString("%1 %2").arg(words.last()).arg(step.index + 1);
    }
  }
  return words.isEmpty() ? tr("The whole file") : words.join(" > ");
}

void ProblemList::refresh() {
  clear();
  int row = 0;
  for (const curricula::Problem& problem : document_.problems()) {
    if (++row > kMost) {
      new QTreeWidgetItem(this, {"", tr("... and %1 more").arg(document_.problems().size() - kMost)});
      break;
    }
    const bool whole = problem.allowed.empty();
    auto* item =
        new QTreeWidgetItem(this, {problem.line > 0 ? QString::number(problem.line) : QString(),
                                   whole ? QString::fromStdString(problem.message) : place_of(problem),
                                   QString::fromStdString(problem.value), QString::fromStdString(problem.allowed)});
    item->setData(0, kField, QString::fromStdString(problem.field));
    item->setData(0, kLine, problem.line);
    for (int column = 1; column < 4; ++column) item->setToolTip(column, item->text(column));
    item->setToolTip(1, whole ? QString::fromStdString(problem.message)
                              : tr("In the file: %1").arg(QString::fromStdString(problem.field)));
  }
  const bool text_only = document_.problems().size() == 1 && document_.problems()[0].allowed.empty();
  header()->resizeSection(1, text_only ? 800 : 380);
}

}  // namespace vallecula::gui

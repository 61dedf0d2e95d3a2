#include "gui/authoring/authoring_page.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "curricula/authoring/course_edit.h"
#include "gui/authoring/compare_view.h"
#include "gui/authoring/course_form.h"
#include "gui/authoring/course_text.h"
#include "gui/authoring/course_tree.h"
#include "gui/authoring/problem_list.h"
#include "gui/authoring/undo_keys.h"
#include "gui/session/curricula_files.h"
#include "gui/views/elided_label.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

AuthoringPage::AuthoringPage(QWidget* parent) : QWidget(parent) {
  auto* middle = new QSplitter(Qt::Horizontal, this);
  QWidget* head = make_head();
  middle->addWidget(make_left());
  middle->addWidget(make_right());
  middle->setStretchFactor(0, 0);
  middle->setStretchFactor(1, 1);
  middle->setSizes({330, 930});
  problems_ = new ProblemList(document_, this);
  problems_->setMinimumHeight(70);
  auto* lower = new QWidget(this);
  auto* lower_column = new QVBoxLayout(lower);
  lower_column->setContentsMargins(0, 0, 0, 0);
  lower_column->addWidget(state_);
  lower_column->addWidget(problems_, 1);
  auto* all = new QSplitter(Qt::Vertical, this);
  all->addWidget(middle);
  all->addWidget(lower);
  all->setStretchFactor(0, 1);
  all->setSizes({560, 120});
  message_ = new QLabel(this);
  message_->setWordWrap(true);
  message_->setProperty("role", "warning");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(18, 14, 18, 12);
  column->addWidget(head);
  column->addWidget(all, 1);
  column->addWidget(message_);

  connect(tree_, &CourseTree::chosen, this, [this](const QString& part) {
    form_->show_part(part);
    show_state();
  });
  connect(tree_, &CourseTree::refused, this, &AuthoringPage::set_message);
  connect(form_, &CourseForm::refused, this, &AuthoringPage::set_message);
  connect(problems_, &ProblemList::wanted, this, &AuthoringPage::go_to);
  connect(&document_, &CourseDocument::changed, this, &AuthoringPage::show_state);
  connect(&document_, &CourseDocument::problems_changed, this, &AuthoringPage::show_state);
  connect(&document_.undo(), &QUndoStack::indexChanged, this, &AuthoringPage::show_state);
  connect(&document_.undo(), &QUndoStack::cleanChanged, this, &AuthoringPage::show_state);
  (new UndoKeys(this))->watch(this);
}

QToolButton* AuthoringPage::button(const QString& text, const QString& name, const QString& tip, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setText(text);
  made->setObjectName(name);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

QWidget* AuthoringPage::make_head() {
  auto* head = new QWidget(this);
  const auto shortcut = [this](QToolButton* on, const QKeySequence& keys, auto slot) {
    auto* action = new QAction(this);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(action);
    connect(action, &QAction::triggered, this, slot);
    if (on != nullptr) on->setToolTip(on->toolTip() + " (" + keys.toString(QKeySequence::NativeText) + ")");
  };
  auto* back = button(tr("Back"), "back", tr("To the start page"), head);
  connect(back, &QToolButton::clicked, this, [this] {
    if (may_leave()) emit left();
  });
  auto* fresh = button(tr("New"), "new", tr("An empty course, or a copy of one there is"), head);
  fresh->setPopupMode(QToolButton::InstantPopup);
  auto* new_menu = new QMenu(fresh);
  fresh->setMenu(new_menu);
  connect(new_menu, &QMenu::aboutToShow, this, [this, new_menu] {
    new_menu->clear();
    new_menu->addAction(tr("Empty course"), this, [this] {
      if (may_leave()) new_course();
    });
    new_menu->addSection(tr("A copy of"));
    fill_course_menu(new_menu, [this](const std::filesystem::path& file) {
      if (may_leave()) copy_course(file);
    });
  });
  auto* open = button(tr("Open"), "open", tr("A course of your own, a shipped one, or a file you were given"), head);
  open->setPopupMode(QToolButton::InstantPopup);
  auto* open_menu = new QMenu(open);
  open->setMenu(open_menu);
  connect(open_menu, &QMenu::aboutToShow, this, [this, open_menu] {
    open_menu->clear();
    fill_course_menu(open_menu, [this](const std::filesystem::path& file) {
      if (may_leave()) open_file(file);
    });
    open_menu->addSeparator();
    open_menu->addAction(tr("Another file ..."), this, [this] { open_file({}); });
  });
  save_ = new QPushButton(tr("Save"), head);
  save_->setObjectName("save");
  connect(save_, &QPushButton::clicked, this, &AuthoringPage::save);
  auto* copy = button(tr("Save a copy ..."), "share", tr("One file, to hand on or keep elsewhere"), head);
  connect(copy, &QToolButton::clicked, this, &AuthoringPage::save_copy);
  own_ = button(tr("Add to mine"), "own", tr("Keep this file among your own courses, so that the start page offers it"),
                head);
  connect(own_, &QToolButton::clicked, this, [this] { write(free_own_file(id())); });
  undo_ = button(tr("Undo"), "undo", "", head);
  connect(undo_, &QToolButton::clicked, &document_.undo(), &QUndoStack::undo);
  redo_ = button(tr("Redo"), "redo", "", head);
  connect(redo_, &QToolButton::clicked, &document_.undo(), &QUndoStack::redo);
  try_ = new QPushButton(tr("Try this scenario"), head);
  try_->setObjectName("primary");
  try_->setToolTip(tr("Play it as it stands here, saved or not (F5)"));
  connect(try_, &QPushButton::clicked, this, &AuthoringPage::try_scenario);
  shortcut(nullptr, QKeySequence::Save, [this] { save(); });
  shortcut(nullptr, QKeySequence::Undo, [this] { document_.undo().undo(); });
  shortcut(nullptr, QKeySequence::Redo, [this] { document_.undo().redo(); });
  shortcut(nullptr, QKeySequence(Qt::Key_F5), [this] { try_scenario(); });
  name_ = new ElidedLabel(head);
  name_->setObjectName("heading");
  state_ = new QLabel(this);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  for (QWidget* one : {static_cast<QWidget*>(back), static_cast<QWidget*>(fresh), static_cast<QWidget*>(open),
                       static_cast<QWidget*>(save_), static_cast<QWidget*>(copy), static_cast<QWidget*>(own_),
                       static_cast<QWidget*>(undo_), static_cast<QWidget*>(redo_)})
    row->addWidget(one);
  row->addSpacing(10);
  row->addWidget(name_, 1);
  row->addWidget(try_);
  return head;
}

QWidget* AuthoringPage::make_left() {
  auto* left = new QWidget(this);
  tree_ = new CourseTree(document_, left);
  tree_->setToolTip(tr("Drag to another place, or Alt and the arrow keys"));
  auto* scenario = button(tr("Add scenario"), "add-scenario", tr("At the end of the module"), left);
  connect(scenario, &QToolButton::clicked, this, &AuthoringPage::add_scenario);
  auto* module = button(tr("Add module"), "add-module", tr("With one scenario"), left);
  connect(module, &QToolButton::clicked, this, &AuthoringPage::add_module);
  auto* copy = button(tr("Copy"), "copy", tr("The chosen module or scenario once more"), left);
  connect(copy, &QToolButton::clicked, this, &AuthoringPage::copy_part);
  auto* from = button(tr("Copy from ..."), "copy-from", tr("A module or scenario of another course"), left);
  from->setPopupMode(QToolButton::InstantPopup);
  copy_menu_ = new QMenu(from);
  from->setMenu(copy_menu_);
  connect(copy_menu_, &QMenu::aboutToShow, this, &AuthoringPage::fill_copy_menu);
  auto* gone = button(tr("Delete"), "delete", tr("The chosen module or scenario"), left);
  connect(gone, &QToolButton::clicked, this, &AuthoringPage::delete_part);
  auto* up = button(tr("Up"), "up", tr("Earlier in the course (Alt+Up)"), left);
  connect(up, &QToolButton::clicked, tree_, &CourseTree::move_up);
  auto* down = button(tr("Down"), "down", tr("Later in the course (Alt+Down)"), left);
  connect(down, &QToolButton::clicked, tree_, &CourseTree::move_down);
  modules_ = button(tr("Divide into modules"), "modules",
                    tr("This course was written before there were modules: put its scenarios into one"), left);
  connect(modules_, &QToolButton::clicked, this,
          [this] { edit(tr("Divide into modules"), [](const auto& text) { return curricula::with_modules(text); }); });
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tree_, 1);
  column->addWidget(modules_);
  for (const QList<QWidget*>& line :
       {QList<QWidget*>{scenario, module}, QList<QWidget*>{copy, from}, QList<QWidget*>{up, down, gone}}) {
    auto* row = new QHBoxLayout;
    for (QWidget* one : line) {
      one->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
      row->addWidget(one);
    }
    column->addLayout(row);
  }
  return left;
}

QWidget* AuthoringPage::make_right() {
  tabs_ = new QTabWidget(this);
  form_ = new CourseForm(document_, tabs_);
  text_ = new CourseText(document_, tabs_);
  compare_tab_ = new QWidget(tabs_);
  against_ = new QComboBox(compare_tab_);
  against_->setAccessibleName(tr("Compare with"));
  compare_ = new CompareView(compare_tab_);
  auto* column = new QVBoxLayout(compare_tab_);
  column->setContentsMargins(0, 6, 0, 0);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Compare with"), compare_tab_));
  row->addWidget(against_, 1);
  column->addLayout(row);
  column->addWidget(compare_, 1);
  tabs_->addTab(form_, tr("Form"));
  tabs_->addTab(text_, tr("Text"));
  tabs_->addTab(compare_tab_, tr("Compare"));
  connect(against_, qOverload<int>(&QComboBox::activated), this, &AuthoringPage::compare);
  connect(tabs_, &QTabWidget::currentChanged, this, [this](int index) {
    document_.end_merging();
    if (tabs_->widget(index) == compare_tab_) fill_compare();
  });
  return tabs_;
}

void AuthoringPage::go_to(const QString& field, int line) {
  if (tabs_->currentWidget() == text_ || field.isEmpty()) {
    tabs_->setCurrentWidget(text_);
    text_->go_to(line);
    return;
  }
  tabs_->setCurrentWidget(form_);
  const bool inner = field.startsWith("modules[") || field.startsWith("scenarios[");
  tree_->choose(inner ? field.left(field.indexOf(']') + 1) : QString());
  form_->go_to(field);
}

void AuthoringPage::show_state() {
  const std::filesystem::path& file = document_.file();
  const QString where = file.empty() ? tr("not saved yet") : QString::fromStdString(file.filename().string());
  const bool shipped = !file.empty() && is_shipped(file);
  name_->say({where + (document_.modified() ? " *" : "")},
             file.empty() ? QString() : QString::fromStdString(file.string()));
  save_->setText(shipped ? tr("Save as mine") : tr("Save"));
  save_->setToolTip(shipped ? tr("A shipped course stays as it is: this is kept among your own (Ctrl+S)")
                            : QString("Ctrl+S"));
  save_->setEnabled(!document_.read_only() && (document_.modified() || file.empty() || shipped));
  own_->setVisible(!file.empty() && !shipped && !document_.read_only() && file.parent_path() != own_curricula_folder());
  undo_->setEnabled(document_.undo().canUndo());
  undo_->setToolTip(tr("Undo: %1 (Ctrl+Z)").arg(document_.undo().undoText()));
  redo_->setEnabled(document_.undo().canRedo());
  redo_->setToolTip(tr("Redo: %1 (Ctrl+Shift+Z)").arg(document_.undo().redoText()));
  modules_->setVisible(document_.yaml() != nullptr && document_.schema() == 1);
  const std::size_t count = document_.problems().size();
  if (document_.checking()) {
    state_->setText(tr("Checking ..."));
  } else if (count == 0) {
    state_->setText(tr("Nothing is wrong: this course can be practised."));
  } else {
    state_->setText(tr("%n thing(s) to mend; a click leads there:", "", static_cast<int>(count)));
  }
  theme::dress(*state_, count == 0 ? "color: @within@;" : "color: @over@;");
  problems_->setVisible(count > 0);
  const bool scenario = tree_->part().startsWith("scenarios");
  try_->setEnabled(scenario && count == 0 && document_.yaml() != nullptr);
  try_->setToolTip(!scenario    ? tr("Choose a scenario on the left")
                   : count == 0 ? tr("Play it as it stands here, saved or not (F5)")
                                : tr("What is listed below is to be mended first"));
}

void AuthoringPage::set_message(const QString& message) { message_->setText(message); }

}  // namespace vallecula::gui

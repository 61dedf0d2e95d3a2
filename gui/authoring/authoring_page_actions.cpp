// What the buttons of the authoring page do.
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QTabWidget>
#include <stdexcept>

#include "curricula/authoring/course_edit.h"
#include "curricula/authoring/yaml_edit.h"
#include "gui/authoring/authoring_page.h"
#include "gui/authoring/compare_view.h"
#include "gui/authoring/course_form.h"
#include "gui/authoring/course_tree.h"
#include "gui/session/curricula_files.h"
#include "gui/session/files.h"
#include "gui/session/recent_files.h"

namespace vallecula::gui {

namespace fs = std::filesystem;
using curricula::YamlText;

namespace {

QString course_files() { return QCoreApplication::translate("AuthoringPage", "Courses (*.yaml *.yml);;All files (*)"); }

/// What people know a course by; the file's name where it cannot be read.
QString title_of(const fs::path& file) {
  QString title = QString::fromStdString(file.filename().string());
  try {
    const YamlText text(read_file(file));
    if (const auto* given = text.find("title"); given != nullptr && !given->value.empty())
      title = QString::fromStdString(given->value) + "  (" + title + ")";
  } catch (const std::exception&) {
    title = QCoreApplication::translate("AuthoringPage", "%1  (cannot be read)").arg(title);
  }
  return title;
}

/// A copy and what it was made from stand beside each other in lists: its title says which it is.
std::string as_own(const std::string& course) {
  const YamlText text(course);
  const auto* title = text.find("title");
  const std::string mark = " " + QCoreApplication::translate("AuthoringPage", "(my copy)").toStdString();
  if (title == nullptr || title->value.empty() || title->value.find(mark) != std::string::npos) return course;
  return curricula::with_value(text, "title", curricula::yaml_text(title->value + mark));
}

}  // namespace

void AuthoringPage::begin() {
  if (document_.text().isEmpty()) new_course();
  show_state();
}

void AuthoringPage::new_course() {
  set_message("");
  document_.start_new(curricula::empty_course("my-course", tr("My course").toStdString()));
  tree_->choose("");
  form_->show_part(tree_->part());
}

void AuthoringPage::recover(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (!file.empty() && fs::exists(file, error))
    open_file(file);
  else
    new_course();
  document_.set_bytes(text, tr("Go on writing"));
}

void AuthoringPage::copy_course(const fs::path& file) {
  try {
    const YamlText text(read_file(file));
    const auto* given = text.find("id");
    const std::string copied = "my-" + (given == nullptr ? std::string("course") : given->value).substr(0, 55);
    document_.start_new(as_own(curricula::with_value(text, "id", curricula::yaml_text(copied))));
    set_message(tr("A copy of %1, not saved yet.").arg(title_of(file)));
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
    return;
  }
  tree_->choose("");
  form_->show_part(tree_->part());
}

void AuthoringPage::open_file(const fs::path& given) {
  fs::path file = given;
  if (file.empty()) {
    if (!may_leave()) return;
    file = QFileDialog::getOpenFileName(this, tr("Open a course"), folder_to_open(), course_files())
               .toStdString();
    if (file.empty()) return;
    keep_opened(QString::fromStdString(file.string()));
  }
  set_message("");
  try {
    document_.open(file);
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
    if (document_.text().isEmpty()) new_course();
    return;
  }
  if (is_shipped(file))
    set_message(tr("This course came with Vallecula and stays as it is; what you change is saved among your own."));
  if (document_.read_only())
    set_message(
        tr("This file can only be looked at here: what is wrong with it is said below. Nothing in it is changed."));
  if (document_.yaml() == nullptr) tabs_->setCurrentIndex(1);  // the text is what can be worked on
  tree_->choose("");
  form_->show_part(tree_->part());
}

std::string AuthoringPage::id() const {
  const YamlText* text = document_.yaml();
  const auto* given = text == nullptr ? nullptr : text->find("id");
  const bool usable = given != nullptr && !given->value.empty() &&
                      given->value.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  return usable ? given->value : "my-course";
}

void AuthoringPage::refuse_taken_id(const fs::path& file) const {
  const YamlText* text = document_.yaml();
  const auto* given = text == nullptr ? nullptr : text->find("id");
  if (given == nullptr || file.parent_path() != own_curricula_folder()) return;
  const fs::path other = course_with_id(given->value, file);
  if (other.empty()) return;
  throw std::runtime_error(
      tr("It is not saved: %1 has the id '%2' too, and the records would take the two courses for one. Give this one "
         "another id (the course itself on the left, then Id), and save again.")
          .arg(QString::fromStdString(other.filename().string()), QString::fromStdString(given->value))
          .toStdString());
}

bool AuthoringPage::may_overwrite() {
  if (!document_.changed_on_disk()) return true;
  return QMessageBox::question(this, tr("Changed by another program"),
                               tr("%1 was changed by another program since it was opened here. Overwrite it?")
                                   .arg(QString::fromStdString(document_.file().filename().string())),
                               QMessageBox::Yes | QMessageBox::No, QMessageBox::No) == QMessageBox::Yes;
}

bool AuthoringPage::write(const fs::path& file) {
  try {
    refuse_taken_id(file);
    if (file == document_.file() && !may_overwrite()) {
      set_message(tr("It is not saved. Save a copy keeps both; Open shows what the file has now."));
      return false;
    }
    if (file.parent_path() == own_curricula_folder()) fs::create_directories(own_curricula_folder());
    document_.save(file);
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
    return false;
  }
  set_message((document_.problems().empty() ? tr("Saved as %1.")
                                            : tr("Saved as %1. It can be practised once nothing is wrong with it."))
                  .arg(QString::fromStdString(file.filename().string())));
  show_state();
  emit courses_changed();
  return true;
}

bool AuthoringPage::save() {
  if (document_.read_only()) return false;
  const fs::path& file = document_.file();
  if (!file.empty() && !is_shipped(file)) return write(file);
  std::string wanted = id();
  if (!file.empty() && wanted.compare(0, 3, "my-") != 0) wanted = "my-" + wanted.substr(0, 50);
  const fs::path own = free_own_file(wanted);
  if (own.stem() != id()) {
    // Two courses of one id would be taken for one in the records.
    edit(tr("Give it an id of its own"), [&](const YamlText& text) {
      return as_own(curricula::with_value(text, "id", curricula::yaml_text(own.stem().string())));
    });
  }
  return write(own);
}

bool AuthoringPage::save_copy() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save a copy of the course"),
                                                    QString::fromStdString(id()) + ".yaml", course_files());
  if (file.isEmpty()) return false;
  try {
    if (is_shipped(file.toStdString()))
      throw std::runtime_error("the shipped courses' folder stays as it is; choose another one");
    refuse_taken_id(file.toStdString());
    write_file_whole(file.toStdString(), document_.bytes());
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
    return false;
  }
  set_message(
      tr("A copy was saved; whoever gets the file opens it here, or checks it with `vallecula curriculum check`."));
  emit courses_changed();
  return true;
}

void AuthoringPage::discard() {
  if (document_.file().empty()) return new_course();
  try {
    document_.open(document_.file());
  } catch (const std::exception& error) {
    new_course();
    set_message(QString::fromUtf8(error.what()));
  }
}

bool AuthoringPage::may_leave() {
  if (!document_.modified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("The course has changes that are not saved."),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Save) return save();
  if (answer == QMessageBox::Discard) {
    discard();
    return true;
  }
  return false;
}

void AuthoringPage::fill_course_menu(QMenu* menu, const std::function<void(const fs::path&)>& chosen) {
  for (const fs::path& file : curriculum_files())
    menu->addAction((is_shipped(file) ? tr("Shipped: %1") : tr("Mine: %1")).arg(title_of(file)), this,
                    [chosen, file] { chosen(file); });
}

void AuthoringPage::fill_copy_menu() {
  copy_menu_->clear();
  for (const fs::path& file : curriculum_files()) try {
      const YamlText text(read_file(file));
      QMenu* course = copy_menu_->addMenu(title_of(file));
      for (const char* list : {"modules", "scenarios"}) {
        const auto* all = text.find(list);
        if (all == nullptr || (document_.schema() == 1 && std::string(list) == "modules")) continue;
        course->addSection(list == std::string("modules") ? tr("Modules, with their scenarios") : tr("Scenarios"));
        for (std::size_t i = 0; i < all->children.size(); ++i) {
          const auto* title = all->children[i].child("title");
          const QString part = QString("%1[%2]").arg(list).arg(i);
          course->addAction(title == nullptr ? part : QString::fromStdString(title->value), this,
                            [this, file, part] { copy_from(file, part); });
        }
      }
    } catch (const std::exception&) {
      continue;  // a broken file has nothing to copy; Open tells what is wrong with it
    }
}

void AuthoringPage::edit(const QString& what, const std::function<std::string(const YamlText&)>& change) {
  const YamlText* text = document_.yaml();
  if (text == nullptr) return set_message(tr("The text cannot be read as it is: %1").arg(document_.yaml_problem()));
  try {
    document_.end_merging();
    document_.set_bytes(change(*text), what);
    set_message("");
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
  }
}

void AuthoringPage::add_scenario() {
  std::string id;
  edit(tr("Add a scenario"),
       [&](const YamlText& text) { return curricula::with_new_scenario(text, tree_->module(), id); });
  if (!id.empty() && document_.yaml() != nullptr)
    tree_->choose(QString::fromStdString(curricula::path_of(*document_.yaml(), "scenarios", id)));
}

void AuthoringPage::add_module() {
  if (document_.schema() == 1) return set_message(tr("This course has no modules yet: divide it into modules first."));
  std::string id;
  edit(tr("Add a module"), [&](const YamlText& text) { return curricula::with_new_module(text, id); });
  if (!id.empty() && document_.yaml() != nullptr)
    tree_->choose(QString::fromStdString(curricula::path_of(*document_.yaml(), "modules", id)));
}

void AuthoringPage::copy_part() {
  if (tree_->part().isEmpty())
    return set_message(tr("Choose a module or a scenario on the left; New makes a copy of a whole course."));
  copy_from({}, tree_->part());
}

void AuthoringPage::copy_from(const fs::path& file, const QString& part) {
  const bool module = part.startsWith("modules");
  std::string id;
  edit(module ? tr("Copy a module") : tr("Copy a scenario"), [&](const YamlText& text) {
    const YamlText other(file.empty() ? std::string("x: 1\n") : read_file(file));
    const YamlText& from = file.empty() ? text : other;
    const auto* given = from.find((part + ".id").toStdString());
    if (given == nullptr) throw std::runtime_error("it has no id; give it one first");
    return module ? curricula::with_module_copied(text, from, given->value, id)
                  : curricula::with_scenario_copied(text, from, given->value, tree_->module(), SIZE_MAX, id);
  });
  if (!id.empty() && document_.yaml() != nullptr)
    tree_->choose(QString::fromStdString(curricula::path_of(*document_.yaml(), module ? "modules" : "scenarios", id)));
}

void AuthoringPage::delete_part() {
  const QString part = tree_->part();
  if (part.isEmpty()) return set_message(tr("Choose a module or a scenario on the left."));
  const bool module = part.startsWith("modules");
  edit(module ? tr("Delete the module") : tr("Delete the scenario"), [&](const YamlText& text) {
    const auto* given = text.find((part + ".id").toStdString());
    if (given == nullptr) throw std::runtime_error("it has no id; delete it in the text");
    return module ? curricula::without_module(text, given->value) : curricula::without_scenario(text, given->value);
  });
}

void AuthoringPage::try_scenario() {
  const YamlText* text = document_.yaml();
  const auto* scenario = text == nullptr ? nullptr : text->find((tree_->part() + ".id").toStdString());
  if (!tree_->part().startsWith("scenarios") || scenario == nullptr)
    return set_message(tr("Choose a scenario on the left to try it."));
  try {
    // What is only tried is nobody's progress: the records know it as a draft.
    const fs::path file = drafts_.filePath("draft.yaml").toStdString();
    write_file_whole(file, curricula::with_value(*text, "id", curricula::yaml_text("draft")));
    curricula::load_curriculum(file);
    set_message("");
    emit try_wanted(QString::fromStdString(file.string()), QString::fromStdString(scenario->value));
  } catch (const curricula::CurriculumError& error) {
    set_message(tr("It cannot be tried yet: %1").arg(QString::fromStdString(error.problem().message)));
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
  }
}

void AuthoringPage::fill_compare() {
  const QString before = against_->currentData().toString();
  against_->clear();
  std::string own = id();
  if (own.compare(0, 3, "my-") == 0) own = own.substr(3);
  int origin = 0;
  for (const fs::path& file : curriculum_files()) {
    against_->addItem((is_shipped(file) ? tr("Shipped: %1") : tr("Mine: %1")).arg(title_of(file)),
                      QString::fromStdString(file.string()));
    if (is_shipped(file) && file.stem() == own) origin = against_->count() - 1;
  }
  const int again = against_->findData(before);
  against_->setCurrentIndex(again >= 0 ? again : origin);
  compare();
}

void AuthoringPage::compare() {
  try {
    compare_->show_difference(against_->currentText(), read_file(against_->currentData().toString().toStdString()),
                              document_.bytes());
  } catch (const std::exception& error) {
    set_message(QString::fromUtf8(error.what()));
  }
}

}  // namespace vallecula::gui

// Where an educator writes a course: tree, form, text, comparison and problems of one document.
#pragma once

#include <QTemporaryDir>
#include <QWidget>
#include <filesystem>
#include <functional>

#include "gui/authoring/course_document.h"

class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QTabWidget;
class QToolButton;

namespace vallecula::gui {

class CompareView;
class CourseForm;
class CourseText;
class CourseTree;
class ElidedLabel;
class ProblemList;

class AuthoringPage : public QWidget {
  Q_OBJECT
 public:
  explicit AuthoringPage(QWidget* parent = nullptr);
  /// The course that was last looked at, or an empty one.
  void begin();
  /// Any file; what is wrong with it is told, not thrown.
  void open_file(const std::filesystem::path& file);
  void new_course();
  /// What was being written when a program ended: the course's file (empty: it had none) with this text, not saved.
  void recover(const std::filesystem::path& file, const std::string& text);
  /// A copy of it under an id of its own, not saved yet.
  void copy_course(const std::filesystem::path& file);
  void set_message(const QString& message);
  /// Asks whether unsaved changes are to be kept; false: the person wants to stay.
  bool may_leave();

  CourseDocument& document() { return document_; }
  CourseTree& tree() { return *tree_; }
  CourseForm& form() { return *form_; }
  CourseText& text() { return *text_; }

 public slots:
  /// Into the course's file; a shipped one and a new one into the user's own folder.
  bool save();
  bool save_copy();
  void try_scenario();
  void compare();

 signals:
  void left();
  void courses_changed();  ///< a file was written
  /// This file is a copy of what stands here now, under the curriculum id "draft".
  void try_wanted(const QString& file, const QString& scenario);

 private:
  QWidget* make_head();
  QWidget* make_left();
  QWidget* make_right();
  QToolButton* button(const QString& text, const QString& name, const QString& tip, QWidget* parent);
  void fill_course_menu(QMenu* menu, const std::function<void(const std::filesystem::path&)>& chosen);
  void fill_copy_menu();
  void edit(const QString& what, const std::function<std::string(const curricula::YamlText&)>& change);
  void add_scenario();
  void add_module();
  void copy_part();
  void copy_from(const std::filesystem::path& file, const QString& part);
  void delete_part();
  void go_to(const QString& field, int line);
  void show_state();
  void fill_compare();
  bool write(const std::filesystem::path& file);
  /// Throws std::runtime_error with the mend where `file`, among the user's own, would be a second course of its id.
  void refuse_taken_id(const std::filesystem::path& file) const;
  bool may_overwrite();  ///< asks, where another program wrote the file
  void discard();        ///< what is not saved
  std::string id() const;

  CourseDocument document_;
  QTemporaryDir drafts_;
  CourseTree* tree_;
  CourseForm* form_;
  CourseText* text_;
  CompareView* compare_;
  ProblemList* problems_;
  QTabWidget* tabs_;
  QComboBox* against_;
  ElidedLabel* name_;
  QLabel *state_, *message_;
  QPushButton *save_, *try_;
  QToolButton *undo_, *redo_, *own_, *modules_;
  QMenu* copy_menu_;
  QWidget* compare_tab_;
};

}  // namespace vallecula::gui

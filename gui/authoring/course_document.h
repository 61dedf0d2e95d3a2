// The course that is being written: its text, what was done to it and can be undone, its file, and what is wrong with
// it.
#pragma once

#include <QObject>
#include <QPointer>
#include <QThread>
#include <QTimer>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <vector>

#include "curricula/authoring/yaml_text.h"
#include "curricula/scenario.h"

namespace vallecula::gui {

class CourseDocument : public QObject {
  Q_OBJECT
 public:
  explicit CourseDocument(QObject* parent = nullptr);
  ~CourseDocument() override;

  /// Lines end with \n in here; a file's own line ends and byte order mark come back when it is saved.
  const QString& text() const { return text_; }
  std::string bytes() const;
  /// The text with its values' places; null while it is broken (yaml_problem says how).
  const curricula::YamlText* yaml() const;
  const QString& yaml_problem() const { return yaml_problem_; }
  int schema() const;  ///< 1 or 2: whose fields the form offers

  /// One step that can be undone. Steps with the same `merge` (not empty) that follow one another are one.
  void set_text(const QString& text, const QString& what, const QString& merge = {});
  /// The same with what an edit of curricula/authoring gave.
  void set_bytes(const std::string& text, const QString& what, const QString& merge = {});
  /// The next step is one of its own.
  void end_merging() { merging_.clear(); }
  QUndoStack& undo() { return undo_; }

  void start_new(const std::string& text);
  /// Opens whatever it is. What can be read is shown: a file that is too large or no UTF-8 text is cut or marked where
  /// it cannot, and is then read_only(). Throws std::runtime_error when nothing can be read.
  void open(const std::filesystem::path& file);
  /// Written aside and renamed. Throws std::runtime_error; the document stays as it is.
  void save(const std::filesystem::path& file);
  /// file() was written by another program since it was opened or saved here. Throws std::runtime_error: it cannot be read.
  bool changed_on_disk() const;
  const std::filesystem::path& file() const { return file_; }  ///< empty: never saved
  bool modified() const { return !undo_.isClean(); }
  bool read_only() const { return read_only_; }

  /// Of the text as it was when problems_changed came last; found on a thread of their own.
  const std::vector<curricula::Problem>& problems() const { return problems_; }
  bool checking() const { return checking_ || wait_.isActive(); }

 signals:
  void changed();
  void problems_changed();

 private:
  friend class CourseStep;
  void put(const QString& text);
  void load(QString text, const std::filesystem::path& file);
  void check();

  QString text_;
  QUndoStack undo_;
  QString merging_;
  std::filesystem::path file_;
  std::string on_disk_;  ///< of file_, as it was read or written here
  bool crlf_ = false, marked_ = false, read_only_ = false;
  std::string raw_;  ///< of a file that is no UTF-8 text, or the first of one too large: what is wrong is told from it
  mutable std::unique_ptr<curricula::YamlText> yaml_;
  mutable bool parsed_ = false;
  mutable QString yaml_problem_;
  std::vector<curricula::Problem> problems_;
  QTimer wait_;
  QPointer<QThread> worker_;
  bool checking_ = false, stale_ = false;
};

}  // namespace vallecula::gui

// What is being written and not saved yet, kept aside every few seconds: a program that dies does not take it along.
#pragma once

#include <QObject>
#include <QPointer>
#include <QThread>
#include <QTimer>
#include <filesystem>
#include <optional>
#include <string>

namespace vallecula::gui {

class CourseDocument;

class KeptDraft : public QObject {
  Q_OBJECT
 public:
  /// Keeps what is not saved of `document` (which must outlive this) in `folder`, under this process's number, on a
  /// thread of its own; takes it away when all is saved.
  KeptDraft(CourseDocument& document, std::filesystem::path folder, QObject* parent = nullptr);
  ~KeptDraft() override;
  void set_interval(int ms) { wait_.setInterval(ms); }
  void forget();  ///< nothing is to be kept of what stands there now

 private:
  void keep();

  CourseDocument& document_;
  std::filesystem::path file_;
  QTimer wait_;
  QPointer<QThread> worker_;
};

/// A draft that a program left which is no more.
struct LeftDraft {
  std::filesystem::path kept;  ///< its file, to be removed once it is opened or not wanted
  std::filesystem::path from;  ///< the course's own file; empty: never saved
  std::string text;
};
/// The newest; none: nothing was left. Asks the disk: not for the window's thread.
std::optional<LeftDraft> left_draft(const std::filesystem::path& folder);
void remove_draft(const std::filesystem::path& kept);

}  // namespace vallecula::gui

#include "gui/authoring/kept_draft.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "gui/authoring/course_document.h"
#include "gui/pages/background.h"
#include "gui/session/files.h"

namespace vallecula::gui {
namespace {

namespace fs = std::filesystem;

constexpr int kEveryMs = 4000;
constexpr const char* kBefore = "unsaved-";

/// Beside the text: the file that it is a course of.
fs::path from_file(const fs::path& kept) { return kept.string() + ".from"; }

bool runs(long process) { return process > 0 && (kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM); }

}  // namespace

KeptDraft::KeptDraft(CourseDocument& document, fs::path folder, QObject* parent)
    : QObject(parent),
      document_(document),
      file_(std::move(folder) / (kBefore + std::to_string(getpid()) + ".yaml")) {
  wait_.setSingleShot(true);
  wait_.setInterval(kEveryMs);
  connect(&wait_, &QTimer::timeout, this, &KeptDraft::keep);
  // Not begun anew by each key: who types without a pause is kept as well.
  const auto soon = [this] {
    if (!wait_.isActive()) wait_.start();
  };
  connect(&document, &CourseDocument::changed, this, soon);
  connect(&document.undo(), &QUndoStack::cleanChanged, this, soon);
}

KeptDraft::~KeptDraft() {
  if (worker_) worker_->wait();
}

void KeptDraft::keep() {
  if (worker_ && !worker_->isFinished()) return wait_.start();
  const bool unsaved = document_.modified() && !document_.read_only();
  worker_ = run_in_background<bool>(
      this,
      [unsaved, file = file_, text = document_.bytes(), from = document_.file()] {
        if (!unsaved) {
          remove_draft(file);
          return true;
        }
        fs::create_directories(file.parent_path());
        write_file_whole(from_file(file), from.string());
        write_file_whole(file, text);
        return true;
      },
      [](bool) {}, [](const QString&) {});  // a full disk is told when it matters: at Save
}

void KeptDraft::forget() {
  wait_.stop();
  if (worker_) worker_->wait();
  remove_draft(file_);
}

std::optional<LeftDraft> left_draft(const fs::path& folder) {
  std::error_code error;
  std::optional<LeftDraft> newest;
  fs::file_time_type when;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".yaml" || name.rfind(kBefore, 0) != 0) continue;
    if (runs(std::atol(name.c_str() + std::string(kBefore).size()))) continue;
    const auto written = fs::last_write_time(entry.path(), error);
    if (newest && written <= when) continue;
    try {
      LeftDraft found{entry.path(), {}, read_file(entry.path())};
      if (fs::exists(from_file(entry.path()), error)) found.from = read_file(from_file(entry.path()));
      newest = std::move(found);
      when = written;
    } catch (const std::exception&) {
      continue;  // taken away by another program that was quicker
    }
  }
  return newest;
}

void remove_draft(const fs::path& kept) {
  std::error_code error;
  fs::remove(kept, error);
  fs::remove(from_file(kept), error);
}

}  // namespace vallecula::gui

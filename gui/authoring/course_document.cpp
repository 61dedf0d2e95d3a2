#include "gui/authoring/course_document.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "gui/pages/background.h"
#include "gui/session/files.h"

namespace vallecula::gui {

namespace {

constexpr std::size_t kLargest = 1u << 20;  ///< bytes; what is larger is no curriculum
constexpr int kShownOfTooLarge = 64 * 1024;
constexpr int kUndoCharacters = 20 * 1000 * 1000;
constexpr int kWaitMs = 120;  ///< after the last key

}  // namespace

/// The whole text before and after; QString shares what the next step begins with.
class CourseStep : public QUndoCommand {
 public:
  CourseStep(CourseDocument& document, QString after, const QString& what, QString merge)
      : QUndoCommand(what),
        document_(document),
        before_(document.text()),
        after_(std::move(after)),
        merge_(std::move(merge)) {}
  void undo() override {
    document_.end_merging();
    document_.put(before_);
  }
  void redo() override { document_.put(after_); }
  int id() const override { return merge_.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const CourseStep&>(*other);
    if (next.merge_ != merge_ || document_.merging_ != merge_) return false;
    after_ = next.after_;
    return true;
  }

 private:
  CourseDocument& document_;
  QString before_, after_, merge_;
};

CourseDocument::CourseDocument(QObject* parent) : QObject(parent) {
  wait_.setSingleShot(true);
  wait_.setInterval(kWaitMs);
  connect(&wait_, &QTimer::timeout, this, &CourseDocument::check);
}

CourseDocument::~CourseDocument() {
  undo_.disconnect();  // it tells of its own end, when the page is half gone
  if (worker_) worker_->wait();
}

std::string CourseDocument::bytes() const {
  QString text = text_;
  if (crlf_) text.replace('\n', "\r\n");
  return (marked_ ? "\xef\xbb\xbf" : "") + text.toStdString();
}

const curricula::YamlText* CourseDocument::yaml() const {
  if (!parsed_) {
    parsed_ = true;
    yaml_.reset();
    yaml_problem_.clear();
    try {
      if (read_only_) throw curricula::CurriculumError("this file can only be looked at");
      yaml_ = std::make_unique<curricula::YamlText>(text_.toStdString());
    } catch (const std::exception& error) {
      yaml_problem_ = QString::fromUtf8(error.what());
    }
  }
  return yaml_.get();
}

int CourseDocument::schema() const {
  const curricula::YamlNode* given = yaml() != nullptr ? yaml()->find("schema") : nullptr;
  return given != nullptr && given->value == "1" ? 1 : 2;
}

void CourseDocument::set_text(const QString& text, const QString& what, const QString& merge) {
  if (text == text_ || read_only_) return;
  auto* step = new CourseStep(*this, text, what, merge);
  undo_.push(step);  // asks the step before whether it takes this one in
  merging_ = merge;
}

void CourseDocument::set_bytes(const std::string& text, const QString& what, const QString& merge) {
  set_text(QString::fromStdString(text), what, merge);
}

void CourseDocument::put(const QString& text) {
  text_ = text;
  parsed_ = false;
  emit changed();
  wait_.start();
}

void CourseDocument::load(QString text, const std::filesystem::path& file) {
  marked_ = text.startsWith(QChar(0xfeff));
  if (marked_) text.remove(0, 1);
  crlf_ = text.contains("\r\n") && text.count('\n') == text.count("\r\n");
  text.replace("\r\n", "\n");
  file_ = file;
  undo_.clear();
  undo_.setUndoLimit(std::clamp(kUndoCharacters / std::max(1, text.size()), 20, 1000));
  merging_.clear();
  problems_.clear();
  put(text);
  wait_.stop();
  check();
}

void CourseDocument::start_new(const std::string& text) {
  read_only_ = false;
  raw_.clear();
  on_disk_.clear();
  load(QString::fromStdString(text), {});
}

void CourseDocument::open(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file))
    throw std::runtime_error(file.string() + ": is a folder; choose a YAML file in it");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(kLargest + 1, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.is_open() || stream.bad())
    throw std::runtime_error(file.string() + ": cannot be read; check the name and the permissions");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  QString text = QString::fromUtf8(bytes.data(), static_cast<int>(bytes.size()));  // keeps the byte order mark
  if (text.toUtf8().toStdString() != bytes && ("\xef\xbb\xbf" + text.toUtf8().toStdString()) == bytes)
    text.prepend(QChar(0xfeff));
  const bool too_large = bytes.size() > kLargest;
  read_only_ = too_large || text.toUtf8().toStdString() != bytes || text.contains(QChar(0));
  raw_ = read_only_ ? bytes : std::string();
  on_disk_ = bytes;
  if (too_large) text.truncate(kShownOfTooLarge);
  text.replace(QChar(0), QChar(0xfffd));
  load(text, file);
}

void CourseDocument::save(const std::filesystem::path& file) {
  if (read_only_) throw std::runtime_error("this file can only be looked at: it is no text that could be saved again");
  const std::string saved = bytes();
  write_file_whole(file, saved);
  on_disk_ = saved;
  file_ = file;
  undo_.setClean();
}

bool CourseDocument::changed_on_disk() const {
  std::error_code none;
  return !file_.empty() && std::filesystem::exists(file_, none) && read_file(file_) != on_disk_;
}

void CourseDocument::check() {
  if (checking_) {
    stale_ = true;
    return;
  }
  checking_ = true;
  stale_ = false;
  const std::string text = raw_.empty() ? text_.toStdString() : raw_;
  worker_ = run_in_background<std::vector<curricula::Problem>>(
      this, [text] { return curricula::problems_of(text); },
      [this](std::vector<curricula::Problem> problems) {
        checking_ = false;
        if (stale_) return check();  // these are of another text
        problems_ = std::move(problems);
        emit problems_changed();
      },
      [this](const QString& message) {
        checking_ = false;
        if (stale_) return check();
        problems_ = {{0, "", "", "", message.toStdString()}};
        emit problems_changed();
      });
}

}  // namespace vallecula::gui

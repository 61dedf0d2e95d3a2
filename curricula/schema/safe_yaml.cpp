#include "curricula/schema/safe_yaml.h"

#include <yaml-cpp/eventhandler.h>

#include <QByteArray>
#include <QString>
#include <fstream>
#include <sstream>

#include "curricula/scenario.h"

namespace vallecula::curricula {
namespace {

constexpr int kDeepest = 16;

/// Walks the events before any tree is built: the parser's own recursion is cut here, and no alias is ever followed.
class Guard final : public YAML::EventHandler {
 public:
  explicit Guard(const std::string& name) : name_(name) {}
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { refuse_anchor(mark, anchor); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    fail(mark, "an alias (*name) stands here; allowed: the values themselves, written out");
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, const std::string&) override {
    refuse_anchor(mark, anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    enter(mark, anchor);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    enter(mark, anchor);
  }
  void OnMapEnd() override { --depth_; }

 private:
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw CurriculumError(name_ + ":" + std::to_string(mark.line + 1) + ": " + what, {mark.line + 1, "", "", "", what});
  }
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != YAML::NullAnchor)
      fail(mark, "an anchor (&name) stands here; allowed: the values themselves, written out");
  }
  void enter(const YAML::Mark& mark, YAML::anchor_t anchor) {
    refuse_anchor(mark, anchor);
    if (++depth_ > kDeepest)
      fail(mark, "nested more than " + std::to_string(kDeepest) + " deep; allowed: the fields of a curriculum");
  }

  const std::string& name_;
  int depth_ = 0;
};

bool is_utf8_text(const std::string& text) {
  if (text.find('\0') != std::string::npos) return false;
  const bool marked = text.compare(0, 3, "\xef\xbb\xbf") == 0;
  const QByteArray bytes = QByteArray::fromStdString(marked ? text.substr(3) : text);
  return QString::fromUtf8(bytes).toUtf8() == bytes;
}

}  // namespace

std::string read_yaml_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::string name = "curriculum " + file.string() + ": ";
  if (std::filesystem::is_directory(file, error)) throw CurriculumError(name + "is a folder; give a YAML file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw CurriculumError(name + "cannot be opened; check the name and the permission");
  std::string text(kLargestYaml + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) throw CurriculumError(name + "cannot be read");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > kLargestYaml)
    throw CurriculumError(name + "is larger than 1 MB; a curriculum is a few pages of text");
  return text;
}

YAML::Node parse_safely(const std::string& text, const std::string& name) {
  const auto fail = [&name](const std::string& what, int line = 0) {
    const std::string where = line > 0 ? ":" + std::to_string(line) : "";
    throw CurriculumError(name + where + ": " + what, {line, "", "", "", what});
  };
  if (text.size() > kLargestYaml) fail("is larger than 1 MB; a curriculum is a few pages of text");
  if (!is_utf8_text(text)) fail("is not UTF-8 text; save it as UTF-8");
  try {
    Guard guard(name);
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(guard)) fail("the file is empty; allowed: one curriculum", 1);
    if (parser.HandleNextDocument(guard)) fail("holds more than one document ('---'); allowed: one");
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    fail("broken YAML: " + error.msg + "; check indentation, colons and quotes around this line", error.mark.line + 1);
  }
  return {};  // not reached: fail throws
}

}  // namespace vallecula::curricula

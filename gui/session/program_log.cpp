#include "gui/session/program_log.h"

#include <spdlog/async.h>
#include <spdlog/sinks/rotating_file_sink.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <regex>
#include <thread>

#include "gui/session/files.h"

namespace vallecula::gui::program_log {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 256 * 1024, kOlder = 2, kLinesOnTheWay = 512;
constexpr const char* kInstead = "[...]";

/// What lines go to; stays usable for whoever has a copy. The file's name outlives end(): it is still there to be sent.
struct Open {
  fs::path file;
  std::shared_ptr<spdlog::details::thread_pool> pool;
  std::shared_ptr<spdlog::async_logger> logger;
};

struct Kept {
  std::mutex mutex;  ///< of all the rest
  std::vector<std::string> hidden;
  Open open;
};

Kept& kept() {
  static Kept one;
  return one;
}

Open now_open() {
  const std::lock_guard lock(kept().mutex);
  return kept().open;
}

bool of_a_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || (static_cast<unsigned char>(c) & 0x80u) != 0; }

/// Where it stands by itself: a person called "Al" does not blot out "trial".
void blot_out(std::string& text, const std::string& words) {
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at)) {
    const std::size_t end = at + words.size();
    const bool within = (at > 0 && of_a_word(text[at - 1]) && of_a_word(words.front())) ||
                        (end < text.size() && of_a_word(text[end]) && of_a_word(words.back()));
    if (within) {
      at = end;
      continue;
    }
    text.replace(at, words.size(), kInstead);
    at += std::string(kInstead).size();
  }
}

/// "NAME.patient" is called as its patient is: it goes from the last quote, colon or line's end on, for a name may hold
/// blanks.
void blot_out_packages(std::string& text) {
  const std::string ending = ".patient";
  for (std::size_t at = text.find(ending); at != std::string::npos; at = text.find(ending, at)) {
    const std::size_t mark = text.find_last_of("'\":\n", at);
    std::size_t from = mark == std::string::npos ? 0 : mark + 1;
    while (from < at && text[from] == ' ') ++from;
    text.replace(from, at + ending.size() - from, kInstead);
    at = from;
  }
}

}  // namespace

bool begin(const fs::path& folder) {
  end();
  Kept& one = kept();
  {
    const std::lock_guard lock(one.mutex);
    one.hidden.clear();
    one.open = {};
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') hide(std::string(home));
  hide(folder.parent_path().string());
  try {
    fs::create_directories(folder);
    Open fresh;
    fresh.file = folder / "vallecula.log";
    auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(fresh.file.string(), kMostBytes, kOlder);
    fresh.pool = std::make_shared<spdlog::details::thread_pool>(kLinesOnTheWay, 1);
    fresh.logger = std::make_shared<spdlog::async_logger>("program", sink, fresh.pool, spdlog::async_overflow_policy::overrun_oldest);
    fresh.logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %v");
    fresh.logger->flush_on(spdlog::level::info);
    const std::lock_guard lock(one.mutex);
    one.open = fresh;
  } catch (const std::exception&) {
    return false;
  }
  return true;
}

void end() {
  Open last = now_open();
  {
    const std::lock_guard lock(kept().mutex);
    kept().open.logger.reset();
    kept().open.pool.reset();
  }
  last.logger.reset();
  last.pool.reset();  // joins its thread once the lines on their way are written
}

void hide(const std::string& words) {
  if (words.empty()) return;
  Kept& one = kept();
  const std::lock_guard lock(one.mutex);
  if (std::find(one.hidden.begin(), one.hidden.end(), words) != one.hidden.end()) return;
  one.hidden.push_back(words);
  // The longest first: a folder's name before a name that is part of it.
  std::stable_sort(one.hidden.begin(), one.hidden.end(),
                   [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
}

void hide(const fs::path& path) {
  hide(path.string());
  hide(path.filename().string());
  hide(path.stem().string());
}

std::string without_identity(const std::string& text) {
  std::string clean = text;
  {
    Kept& one = kept();
    const std::lock_guard lock(one.mutex);
    for (const std::string& words : one.hidden) blot_out(clean, words);
  }
  // What follows a hidden folder goes with it; what begins like a path is one up to the next quote, colon or end, for
  // folders' names may hold blanks, commas and brackets.
  static const std::regex path(R"((^|[\s'"(=])(file:/+|~?/|[A-Za-z]:\\|\[\.\.\.\]/)[^'":\n]*)");
  clean = std::regex_replace(clean, path, std::string("$1") + kInstead);
  blot_out_packages(clean);
  return clean;
}

void note(const std::string& line) {
  if (const Open open = now_open(); open.logger) open.logger->info(without_identity(line));
}

void save(const fs::path& to, const std::vector<std::string>& head) {
  const Open open = now_open();
  if (open.logger) open.logger->flush();
  for (int i = 0; i < 100 && open.pool && open.pool->queue_size() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::string all;
  for (const std::string& line : head) all += without_identity(line) + "\n";
  all += "\n";
  for (std::size_t older = kOlder + 1; !open.file.empty() && older-- > 0;) {
    const fs::path file =
        older == 0 ? open.file : open.file.parent_path() / ("vallecula." + std::to_string(older) + ".log");
    std::error_code error;
    // Once more: a name may have become known after its line was written.
    if (fs::exists(file, error)) all += without_identity(read_file(file));
  }
  write_file_whole(to, all);
}

}  // namespace vallecula::gui::program_log

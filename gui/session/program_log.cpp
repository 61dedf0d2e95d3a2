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

struct Kept {
  std::mutex mutex;  ///< of what is hidden
  std::vector<std::string> hidden;
  fs::path file;
  std::shared_ptr<spdlog::details::thread_pool> pool;
  std::shared_ptr<spdlog::async_logger> logger;
};

Kept& kept() {
  static Kept one;
  return one;
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

}  // namespace

bool begin(const fs::path& folder) {
  end();
  Kept& one = kept();
  {
    const std::lock_guard lock(one.mutex);
    one.hidden.clear();
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') hide(std::string(home));
  hide(folder.parent_path().string());
  try {
    fs::create_directories(folder);
    one.file = folder / "vallecula.log";
    auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(one.file.string(), kMostBytes, kOlder);
    one.pool = std::make_shared<spdlog::details::thread_pool>(kLinesOnTheWay, 1);
    one.logger = std::make_shared<spdlog::async_logger>("program", sink, one.pool, spdlog::async_overflow_policy::overrun_oldest);
  } catch (const std::exception&) {
    end();
    return false;
  }
  one.logger->set_pattern("%Y-%m-%d %H:%M:%S.%e %v");
  one.logger->flush_on(spdlog::level::info);
  return true;
}

void end() {
  kept().logger.reset();
  kept().pool.reset();  // joins its thread once the lines on their way are written
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
  // What follows a hidden folder goes with it; what begins like a path is one up to the next quote, colon or end: folders' names may hold blanks.
  static const std::regex path(R"((^|[\s'"(=])(~?/|[A-Za-z]:\\|\[\.\.\.\]/)[^'":;,()\n]*)");
  return std::regex_replace(clean, path, std::string("$1") + kInstead);
}

void note(const std::string& line) {
  if (kept().logger) kept().logger->info(without_identity(line));
}

void save(const fs::path& to, const std::vector<std::string>& head) {
  const Kept& one = kept();
  if (one.logger) one.logger->flush();
  for (int i = 0; i < 100 && one.pool && one.pool->queue_size() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::string all;
  for (const std::string& line : head) all += without_identity(line) + "\n";
  all += "\n";
  for (std::size_t older = kOlder + 1; older-- > 0;) {
    const fs::path file =
        older == 0 ? one.file : one.file.parent_path() / ("vallecula." + std::to_string(older) + ".log");
    std::error_code error;
    // Once more: a name may have become known after its line was written.
    if (fs::exists(file, error)) all += without_identity(read_file(file));
  }
  write_file_whole(to, all);
}

}  // namespace vallecula::gui::program_log

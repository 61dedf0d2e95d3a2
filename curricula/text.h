// A text in one or more languages. What a trainee reads is Markdown.
#pragma once

#include <map>
#include <string>
#include <utility>

namespace vallecula::curricula {

class Text {
 public:
  Text() = default;
  Text(std::string english) : by_language_{{"en", std::move(english)}} {}  // NOLINT: English alone is the usual case
  Text(const char* english) : Text(std::string(english)) {}                // NOLINT
  /// By language code, "de" or "de-CH"; holds "en".
  explicit Text(std::map<std::string, std::string> by_language) : by_language_(std::move(by_language)) {}

  /// In that language, else in it without its country, else in English; empty when there is none.
  std::string in(const std::string& language) const {
    for (const std::string& code : {language, language.substr(0, 2), std::string("en")}) {
      const auto found = by_language_.find(code);
      if (found != by_language_.end()) return found->second;
    }
    return "";
  }
  const std::map<std::string, std::string>& by_language() const { return by_language_; }

 private:
  std::map<std::string, std::string> by_language_;
};

}  // namespace vallecula::curricula

// A small learning record store on this computer, with the faults that real ones and the way to them have.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace vallecula::curricula::testing {

/// Keeps what the rules allow, all of a POST or nothing, as the xAPI demands: known ids with the same content are
/// accepted and kept once, with another content answered 409, offences against xAPI answered 400.
class SmallLrs {
 public:
  enum class Does {
    answers,
    server_error,     ///< 503
    too_many,         ///< 429
    not_let_in,       ///< 401
    elsewhere,        ///< 302 to another computer
    garbage,          ///< 200 and a page for a person
    hangs,            ///< takes the request and says nothing
    keeps_and_hangs,  ///< keeps the statements, and its answer never comes
    closes_half_way,  ///< keeps them, and the connection ends within the answer
  };

  SmallLrs();
  ~SmallLrs();
  SmallLrs(const SmallLrs&) = delete;
  SmallLrs& operator=(const SmallLrs&) = delete;

  std::string address() const;  ///< with a user's key "key" and secret "s3cret"
  void does(Does what) { does_ = what; }
  /// Statements in which this text is are answered 400 from now on; empty: none.
  void refuse(const std::string& text);
  std::map<std::string, std::string> kept() const;  ///< statements by id
  int posts() const { return posts_; }
  /// What was wrong with requests: method, path, headers, statements against the rules.
  std::vector<std::string> offences() const;

 private:
  void serve();
  void answer(int connection);
  std::string store(const std::string& body);  ///< the whole answer

  int listener_ = -1, port_ = 0;
  std::atomic<bool> over_{false};
  std::atomic<Does> does_{Does::answers};
  std::atomic<int> posts_{0};
  mutable std::mutex mutex_;
  std::string refused_text_;
  std::map<std::string, std::string> kept_;
  std::vector<std::string> offences_;
  std::vector<int> hanging_;
  std::thread thread_;
};

}  // namespace vallecula::curricula::testing

// The learning record store that statements are delivered to: its setting, and one exchange with it.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "curricula/export/xapi.h"

namespace vallecula::curricula {

struct LrsSettings {
  std::string address;      ///< of the xAPI, without "/statements"
  std::string key, secret;  ///< HTTP Basic; in no message and no log
  double timeout_s = 30.0;  ///< of one exchange, from its begin to its end
};
/// Refuses what is no address, one with a user or a question mark in it, one without key or secret, and http to any
/// computer but this one: the statements and the secret would be readable on the way. Throws RecordsError.
LrsSettings checked(LrsSettings settings);

enum class LrsAnswer {
  taken,       ///< it has every one of them
  conflict,    ///< 409: it has one of these ids with something else in it
  refused,     ///< 4xx: what was sent is not to its liking, and will not be next time
  too_large,   ///< 413
  unusable,    ///< the setting is wrong: it lets nobody in (401, 403), there is no xAPI (404, another place, another page)
  not_now      ///< no connection, nothing in time, 5xx, 408, 429: later
};

/// Needs a QCoreApplication, and belongs to the thread that made it.
class LrsClient {
 public:
  explicit LrsClient(const LrsSettings& settings);  ///< checked; throws RecordsError
  ~LrsClient();
  LrsClient(const LrsClient&) = delete;
  LrsClient& operator=(const LrsClient&) = delete;

  struct Answer {
    LrsAnswer answer = LrsAnswer::not_now;
    std::string reason;  ///< for a person, with the mend; empty: taken
  };
  /// One POST. Taken is only what the store itself names in its answer. `stop` ends it early (not_now).
  Answer post(const std::vector<XapiStatement>& statements, const std::atomic<bool>* stop = nullptr);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vallecula::curricula

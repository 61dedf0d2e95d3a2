// Trials as xAPI statements (1.0.3), in the shape cmi5 (quartz) gives them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "curricula/records/records.h"

namespace vallecula::curricula {

/// Whose system the trainees' numbers belong to.
struct XapiSource {
  std::string home_page;  ///< of every actor's account
};
/// `home_page`: an address (https://...) that stands for these records; empty: one made of their own random id, the
/// same for all stations that share them. Throws RecordsError, also for what is no address.
XapiSource xapi_source(Records& records, const std::string& home_page = {});

/// What a learning management system gave when it launched a trial (cmi5 8.1, 10).
struct Cmi5Launch {
  std::string actor;             ///< JSON, as in the launch URL
  std::string registration;      ///< UUID
  std::string activity_id;       ///< IRI
  std::string context_template;  ///< JSON, of LMS.LaunchData; it has the session id
  std::optional<double> mastery_score;
  bool judged = true;            ///< launchMode Normal
  std::set<std::string> recorded;  ///< verbs that this registration has already: "completed", "passed"
};
/// {"actor": {...}, "registration": "...", "activityId": "...", "launchData": {...}, "recorded": [...]}; launchData is the
/// LMS.LaunchData document as the system gave it. Throws RecordsError naming what is missing.
Cmi5Launch read_cmi5_launch(const std::string& json);

struct XapiStatement {
  std::string id;    ///< UUID (version 5) of trial and verb: a trial sent twice has the same
  std::string json;  ///< one line
};

/// A trial is a session: initialized; completed, unless it was cut off; passed or failed; terminated. Only passed and
/// failed have a score (the points, of 100) and a success, only completed has a completion; all but initialized have the
/// trial time as duration. No name and no researchers' figure is in any.
/// Without a launch a trial is a registration of its own, and nothing claims to be "cmi5 defined" (which needs a launch):
/// the cmi5 category is left out. With one, actor, activity, registration and context are the system's, and where it gave
/// a mastery score, that decides between passed and failed.
std::vector<XapiStatement> statements_of(const RecordRow& trial, const XapiSource& source,
                                         const std::optional<Cmi5Launch>& launch = std::nullopt);

/// A JSON array, one statement a line.
std::string json_array(const std::vector<XapiStatement>& statements);

}  // namespace vallecula::curricula

// What is sent to a learning record store, and what of it is there.
#pragma once

#include "curricula/export/lrs.h"

namespace vallecula::curricula {

/// The records themselves are the queue: a trial is waiting until the store has named its statements as received, and is
/// so from the moment that it has its row. Nothing is to be written when a trial ends, so nothing can be lost then.
struct Waiting {
  int waiting = 0, refused = 0;  ///< trials
  std::string last_refusal;      ///< its reason
};
Waiting waiting_statements(Records& records);

struct Delivery {
  int sent = 0, refused = 0;  ///< trials
  int left = 0;
  bool again_later = false;  ///< the store could not be reached, or had no time: the rest may go later
  std::string problem;       ///< why the rest was left; empty: nothing is left
};
/// Sends what waits, oldest first, until nothing is left or the store cannot be used. A statement that the store refuses
/// is kept aside with the reason, and its trial's others are sent; a store that refuses every one of them (up to 20
/// trials) cannot be used, and all wait. May be killed at any time: what was sent without its
/// answer is sent again under the same ids, of which a store keeps one. Throws RecordsError when the records cannot be
/// used, or the setting cannot.
Delivery send_waiting(Records& records, const LrsSettings& settings, const XapiSource& source,
                      const std::atomic<bool>* stop = nullptr);

/// Those that were refused wait again.
void send_refused_again(Records& records);
/// All of them wait again: for another store.
void send_all_again(Records& records);

/// How long one waits after so many failures in a row: 2 s, doubled with each further one, 10 min at most.
double pause_after_s(int failures);

}  // namespace vallecula::curricula

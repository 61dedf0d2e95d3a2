// PINs: their hash, and how long one waits after wrong ones (private to the library).
#pragma once

#include <string>

namespace vallecula::curricula {

constexpr std::size_t kShortestPin = 4, kLongestPin = 64;  ///< bytes of UTF-8
constexpr int kFreeWrongPins = 3;                          ///< the first that makes one wait
constexpr long long kFirstWaitMs = 5'000, kLongestWaitMs = 15 * 60'000;

/// Argon2id with a salt of its own, as libsodium's crypto_pwhash_str writes it (interactive limits: 64 MiB). Throws
/// RecordsError for a PIN too short or too long.
std::string hash_pin(const std::string& pin);
bool pin_matches(const std::string& hash, const std::string& pin);

/// 0 below kFreeWrongPins, then 5 s, doubled with each further one, 15 min at most: ten thousand PINs take a hundred
/// days.
long long wait_after_ms(int wrong_pins);

/// A wait as it stands in a person's row.
struct PinWait {
  long long wait_ms = 0, from_ms = 0;
};
/// What is left of it. A clock that went back before the wait's begin starts it anew (from_ms becomes now_ms, and is to
/// be kept): never shorter, and never longer than the wait itself.
long long remaining_ms(PinWait& wait, long long now_ms);

}  // namespace vallecula::curricula

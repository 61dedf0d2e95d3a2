#include "curricula/records/pin.h"

#include <sodium.h>

#include <algorithm>
#include <array>

#include "curricula/records/location.h"

namespace vallecula::curricula {

std::string hash_pin(const std::string& pin) {
  if (pin.size() < kShortestPin || pin.size() > kLongestPin)
    throw RecordsError("a PIN has 4 to 64 characters; choose another");
  if (sodium_init() < 0) throw RecordsError("records: libsodium cannot be initialised; reinstall libsodium23");
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  if (crypto_pwhash_str(hash.data(), pin.data(), pin.size(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                        crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0)
    throw RecordsError("records: there is no memory for the PIN's hash (64 MB); close other programs and try again");
  return hash.data();
}

bool pin_matches(const std::string& hash, const std::string& pin) {
  if (pin.size() > kLongestPin || hash.size() >= crypto_pwhash_STRBYTES) return false;
  if (sodium_init() < 0) throw RecordsError("records: libsodium cannot be initialised; reinstall libsodium23");
  std::array<char, crypto_pwhash_STRBYTES> padded{};  // libsodium reads so many bytes
  std::copy(hash.begin(), hash.end(), padded.begin());
  return crypto_pwhash_str_verify(padded.data(), pin.data(), pin.size()) == 0;
}

long long wait_after_ms(int wrong_pins) {
  if (wrong_pins < kFreeWrongPins) return 0;
  const int doublings = std::min(wrong_pins - kFreeWrongPins, 20);
  return std::min(kFirstWaitMs << doublings, kLongestWaitMs);
}

long long remaining_ms(PinWait& wait, long long now_ms) {
  if (wait.wait_ms <= 0) return 0;
  if (now_ms < wait.from_ms) wait.from_ms = now_ms;
  return std::max(0LL, wait.wait_ms - (now_ms - wait.from_ms));
}

}  // namespace vallecula::curricula

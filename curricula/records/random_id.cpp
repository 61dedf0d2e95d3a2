#include "curricula/records/random_id.h"

#include <sodium.h>

#include <array>

#include "curricula/records/location.h"

namespace vallecula::curricula {

std::string random_id() {
  if (sodium_init() < 0) throw RecordsError("records: libsodium cannot be initialised; reinstall libsodium23");
  std::array<unsigned char, 16> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  std::array<char, 2 * bytes.size() + 1> text{};
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  return text.data();
}

}  // namespace vallecula::curricula

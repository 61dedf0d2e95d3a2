#include "pipeline/dicom/whole_file.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

namespace vallecula::pipeline {
namespace {

constexpr std::uint32_t kUndefined = 0xffffffffU;

class Walker {
 public:
  explicit Walker(const std::string& bytes) : bytes_(bytes) {}

  std::string fault() {
    if (bytes_.size() < 132 || bytes_.compare(128, 4, "DICM") != 0) return "no DICOM file";
    std::size_t at = 132;
    std::string syntax;
    // The meta group is always explicit little endian.
    while (at + 4 <= bytes_.size() && number(at, 2) == 2) {
      const auto element = number(at + 2, 2);
      std::size_t value = 0;
      std::uint32_t length = 0;
      if (!header(at, true, value, length) || length == kUndefined || value + length > bytes_.size()) return kCut;
      if (element == 0x10) syntax = std::string(bytes_, value, length);
      at = value + length;
    }
    while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
    if (syntax.empty()) return kCut;
    if (syntax == "1.2.840.10008.1.2.1.99") return {};  // deflated
    big_ = syntax == "1.2.840.10008.1.2.2";
    const bool is_explicit = syntax != "1.2.840.10008.1.2";
    if (at >= bytes_.size()) return kCut;
    return elements(at, bytes_.size(), is_explicit, false, 0) ? std::string() : std::string(kCut);
  }

 private:
  static constexpr const char* kCut = "the file is cut short or damaged";

  std::uint32_t number(std::size_t at, int n) const {
    std::uint32_t v = 0;
    for (int i = 0; i < n; ++i) {
      const auto byte = static_cast<std::uint8_t>(bytes_[at + (big_ ? n - 1 - i : i)]);
      v |= static_cast<std::uint32_t>(byte) << (8 * i);
    }
    return v;
  }

  /// Reads tag, representation and length at `at`; where the value begins goes to `value`.
  bool header(std::size_t at, bool is_explicit, std::size_t& value, std::uint32_t& length) const {
    if (at + 8 > bytes_.size()) return false;
    if (!is_explicit || number(at, 2) == 0xfffe) {
      length = number(at + 4, 4);
      value = at + 8;
      return true;
    }
    const std::string vr(bytes_, at + 4, 2);
    static const std::string kKnown =
        "AE AS AT CS DA DS DT FL FD IS LO LT OB OD OF OL OV OW PN SH SL SQ SS ST SV TM UC UI UL UN UR US UT UV ";
    if (kKnown.find(vr + " ") == std::string::npos) return false;
    static const std::string kLong = "OB OW OF OD OL OV SQ UN UC UR UT SV UV ";
    if (kLong.find(vr + " ") == std::string::npos) {
      length = number(at + 6, 2);
      value = at + 8;
      return true;
    }
    if (at + 12 > bytes_.size()) return false;
    length = number(at + 8, 4);
    value = at + 12;
    return true;
  }

  /// Elements from `at` to `end`; with `delimited` up to an item delimiter, past which `at` is left.
  bool elements(std::size_t& at, std::size_t end, bool is_explicit, bool delimited, int depth) {
    if (depth > 32) return false;
    while (at < end) {
      std::size_t value = 0;
      std::uint32_t length = 0;
      if (!header(at, is_explicit, value, length)) return false;
      const auto group = number(at, 2);
      const auto element = number(at + 2, 2);
      if (delimited && group == 0xfffe && element == 0xe00d) {
        at = value;
        return true;
      }
      if (length == kUndefined) {
        const bool pixels = group == 0x7fe0 && element == 0x0010;
        at = value;
        if (!items(at, end, is_explicit, pixels, depth + 1)) return false;
        continue;
      }
      if (value + length > end) return false;
      at = value + length;
    }
    return !delimited && at == end;
  }

  /// Items of a sequence (or fragments of encapsulated pixels) of undefined length, up to and past its delimiter.
  bool items(std::size_t& at, std::size_t end, bool is_explicit, bool fragments, int depth) {
    for (;;) {
      if (at + 8 > end || number(at, 2) != 0xfffe) return false;
      const auto element = number(at + 2, 2);
      const auto length = number(at + 4, 4);
      at += 8;
      if (element == 0xe0dd) return true;
      if (element != 0xe000) return false;
      if (length != kUndefined) {
        if (at + length > end) return false;
        at += length;
      } else if (fragments || !elements(at, end, is_explicit, true, depth + 1)) {
        return false;
      }
    }
  }

  const std::string& bytes_;
  bool big_ = false;
};

}  // namespace

std::string fault_of_dicom_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return "the file cannot be opened";
  std::ostringstream all;
  all << in.rdbuf();
  const auto bytes = all.str();
  return Walker(bytes).fault();
}

}  // namespace vallecula::pipeline

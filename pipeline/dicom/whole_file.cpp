#include "pipeline/dicom/whole_file.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>

#include "pipeline/dicom/limits.h"

namespace vallecula::pipeline {
namespace {

constexpr std::uint32_t kUndefined = 0xffffffffU;
constexpr const char* kCut = "it is cut short or damaged";
constexpr int kDeepest = 32;

std::string trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.remove_suffix(1);
  return std::string(text);
}

bool known_representation(std::string_view vr) {
  static const std::string kKnown =
      "AE AS AT CS DA DS DT FL FD IS LO LT OB OD OF OL OV OW PN SH SL SQ SS ST SV TM UC UI UL UN UR US UT UV ";
  return kKnown.find(std::string(vr) + " ") != std::string::npos;
}

class Walker {
 public:
  Walker(std::string_view bytes, DicomCheck& check) : bytes_(bytes), check_(check) {}

  void run() {
    std::size_t at = 132;
    if (bytes_.size() < 132 || bytes_.compare(128, 4, "DICM") != 0) {
      if (!begins_like_a_data_set()) return;
      at = 0;
    }
    check_.dicom = true;
    std::string syntax;
    // The meta group is always explicit little endian.
    while (at + 4 <= bytes_.size() && number(at, 2) == 2) {
      const auto element = number(at + 2, 2);
      std::size_t value = 0;
      std::uint32_t length = 0;
      if (!header(at, true, value, length) || length == kUndefined || length > bytes_.size() - value) {
        check_.fault = kCut;
        return;
      }
      if (element == 0x10) syntax = trimmed(bytes_.substr(value, length));
      at = value + length;
    }
    if (at >= bytes_.size()) {
      check_.fault = kCut;
      return;
    }
    if (syntax.empty()) {  // a data set without its meta group says by its first element how it is written
      if (at + 6 > bytes_.size())
        check_.fault = kCut;
      else
        walk(at, known_representation(bytes_.substr(at + 4, 2)));
    } else if (syntax == "1.2.840.10008.1.2.1.99") {
      unpack(at);
      if (!check_.fault.empty()) return;
      bytes_ = unpacked_;
      walk(0, true);
    } else {
      big_ = syntax == "1.2.840.10008.1.2.2";
      walk(at, syntax != "1.2.840.10008.1.2");
    }
  }

 private:
  /// Files of some archives lack the preamble: they begin with an element of group 2 or 8, little endian.
  bool begins_like_a_data_set() const {
    if (bytes_.size() < 16) return false;
    const auto group = number(0, 2);
    if ((group != 2 && group != 8) || number(2, 2) > 0x70) return false;
    const bool is_explicit = known_representation(bytes_.substr(4, 2));
    return is_explicit || (group == 8 && number(4, 4) < 4096 && number(4, 4) % 2 == 0);
  }

  void walk(std::size_t at, bool is_explicit) {
    if (!elements(at, bytes_.size(), is_explicit, false, 0)) check_.fault = kCut;
  }

  void unpack(std::size_t at) {
    z_stream stream{};
    if (inflateInit2(&stream, -15) != Z_OK) throw std::bad_alloc();
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes_.data() + at));
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes_.size() - at, 0xffffffffU));
    int state = Z_OK;
    while (state == Z_OK && unpacked_.size() < kMostInflatedBytes) {
      const auto done = unpacked_.size();
      unpacked_.resize(std::max<std::size_t>(2 * done, 1 << 20));
      stream.next_out = reinterpret_cast<Bytef*>(unpacked_.data() + done);
      stream.avail_out = static_cast<uInt>(unpacked_.size() - done);
      state = inflate(&stream, Z_NO_FLUSH);
      unpacked_.resize(unpacked_.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (state == Z_OK)
      check_.fault = "it unpacks to more than 1 GB";
    else if (state != Z_STREAM_END)
      check_.fault = kCut;
  }

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
    const auto vr = bytes_.substr(at + 4, 2);
    if (!known_representation(vr)) return false;
    static const std::string kLong = "OB OW OF OD OL OV SQ UN UC UR UT SV UV ";
    if (kLong.find(std::string(vr) + " ") == std::string::npos) {
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
    if (depth > kDeepest) return false;
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
      if (group == 0xfffe) return false;  // an item where an element belongs
      if (length == kUndefined) {
        const bool pixels = group == 0x7fe0 && element == 0x0010;
        const bool unknown = is_explicit && bytes_.compare(at + 4, 2, "UN") == 0;  // holds implicit items (PS3.5 6.2.2)
        at = value;
        if (!items(at, end, is_explicit && !unknown, pixels, true, depth + 1)) return false;
        continue;
      }
      if (value > end || length > end - value) return false;
      if (depth == 0 && group == 0x0008 && element == 0x0060) check_.modality = trimmed(bytes_.substr(value, length));
      if (depth == 0 && group == 0x0020 && element == 0x000e) check_.series = trimmed(bytes_.substr(value, length));
      if (is_sequence(at, is_explicit, value, length)) {
        // The library believes the lengths in there, and allocates by them.
        std::size_t inside = value;
        if (!items(inside, value + length, is_explicit, false, false, depth + 1)) return false;
      }
      if (depth == 0 && group == 0x7fe0 && element == 0x0010) check_.pixel_bytes = length;
      at = value + length;
    }
    return !delimited && at == end;
  }

  /// A sequence of stated length; without representations it is known by the item it begins with.
  bool is_sequence(std::size_t at, bool is_explicit, std::size_t value, std::uint32_t length) const {
    if (length < 8 || number(at, 2) == 0x7fe0) return false;
    if (is_explicit && number(at, 2) != 0xfffe) return bytes_.compare(at + 4, 2, "SQ") == 0;
    return number(value, 2) == 0xfffe && number(value + 2, 2) == 0xe000;
  }

  /// Items of a sequence (or fragments of encapsulated pixels): up to and past their delimiter, or up to `end`.
  bool items(std::size_t& at, std::size_t end, bool is_explicit, bool fragments, bool delimited, int depth) {
    while (delimited || at < end) {
      if (at > end || end - at < 8 || number(at, 2) != 0xfffe) return false;
      const auto element = number(at + 2, 2);
      const auto length = number(at + 4, 4);
      at += 8;
      if (element == 0xe0dd) return delimited || at == end;
      if (element != 0xe000) return false;
      if (length != kUndefined) {
        if (length > end - at) return false;
        std::size_t inside = at;
        if (!fragments && !elements(inside, at + length, is_explicit, false, depth + 1)) return false;
        at += length;
      } else if (fragments || !elements(at, end, is_explicit, true, depth + 1)) {
        return false;
      }
    }
    return true;
  }

  std::string_view bytes_;
  DicomCheck& check_;
  std::string unpacked_;
  bool big_ = false;
};

}  // namespace

DicomCheck check_dicom(std::string_view bytes) {
  DicomCheck check;
  Walker(bytes, check).run();
  return check;
}

}  // namespace vallecula::pipeline

// What passes between the program and its reading helper: three pieces of memory without a name, same machine, same
// build.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "pipeline/dicom/read_place.h"

namespace vallecula::pipeline::ct_exchange {

/// The helper's file descriptors.
constexpr int kLetters = 3;  ///< the request, then the answer in its place
constexpr int kControl = 4;  ///< Control
constexpr int kVoxels = 5;   ///< int16 HU, or uint16 sets of labels

struct Control {
  std::atomic<std::uint32_t> beat;        ///< rises while work gets done
  std::atomic<std::uint32_t> millionths;  ///< done
  char file[256];                         ///< name of the file at hand, as a person is told it
};

/// What kind of thing a request asks for: its first byte.
constexpr char kSeries = 's';  ///< a ReadRequest follows
constexpr char kLabels = 'l';  ///< a DICOM segmentation's path follows (exchange/label_exchange.h)

/// A letter that makes no sense.
class Damaged : public std::runtime_error {
 public:
  Damaged() : std::runtime_error("damaged") {}
};

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const std::string& value) {
    put(static_cast<std::uint64_t>(value.size()));
    text_ += value;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The other side may have gone mad before it died: nothing it wrote is believed without a check.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}
  template <class T>
  void take(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    need(sizeof value);
    std::memcpy(&value, text_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  void take(std::string& value) {
    const auto n = count(text_.size());
    need(n);
    value = text_.substr(at_, n);
    at_ += n;
  }
  std::size_t count(std::size_t most) {
    std::uint64_t n = 0;
    take(n);
    if (n > most) throw Damaged();
    return static_cast<std::size_t>(n);
  }

 private:
  void need(std::size_t n) const {
    if (n > text_.size() - at_) throw Damaged();
  }
  const std::string& text_;
  std::size_t at_ = 0;
};

std::string packed(const ReadRequest& request);
/// The rest of a request after its kind.
ReadRequest unpacked_request(Reader& rest);
std::string packed(const ReadAnswer& answer);
std::string packed_error(const std::string& message);
/// Throws SeriesError when the answer is one, Damaged when it makes no sense.
ReadAnswer unpacked_answer(const std::string& text);

/// A whole descriptor, read from its beginning.
std::string read_all(int descriptor);
/// In place of whatever it held. False when it cannot be written.
bool write_all(int descriptor, const std::string& text);

}  // namespace vallecula::pipeline::ct_exchange

#include "pipeline/exchange/voxel_stream.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

#include "pipeline/dicom/file_list.h"
#include "pipeline/package/label_map.h"

namespace vallecula::pipeline {
namespace {

constexpr const char* kGzipMark = "\x1f\x8b";

/// Bytes of a file from a place on, packed or plain.
class ByteSource {
 public:
  ByteSource(const std::filesystem::path& file, std::uint64_t at, bool gzip) : file_(file), gzip_(gzip) {
    fd_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd_ < 0 || ::lseek(fd_, static_cast<off_t>(at), SEEK_SET) < 0) {
      if (fd_ >= 0) ::close(fd_);
      fail_label_file(file, "cannot be opened");
    }
    if (!gzip_) return;
    packed_ = ::gzdopen(fd_, "rb");
    if (packed_ == nullptr) {
      ::close(fd_);
      fail_label_file(file, "zlib did not start");
    }
    ::gzbuffer(packed_, 1U << 17);
    // zlib hands plain bytes through; a file that says gzip and is not is damaged.
    if (::gzdirect(packed_) != 0) {
      ::gzclose(packed_);
      fail_label_file(file, "the voxel data is not the gzip its header promises; write the file again");
    }
  }
  ~ByteSource() {
    if (packed_ != nullptr) {
      ::gzclose(packed_);
    } else {
      ::close(fd_);
    }
  }
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// As many as there are, up to `count`.
  std::size_t read(void* into, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
      const auto part = static_cast<unsigned>(std::min<std::size_t>(count - done, 1U << 24));
      auto* to = static_cast<char*>(into) + done;
      const long got = gzip_ ? ::gzread(packed_, to, part) : static_cast<long>(::read(fd_, to, part));
      if (got <= 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  const std::filesystem::path& file_;
  bool gzip_;
  int fd_ = -1;
  gzFile packed_ = nullptr;
};

template <class T>
void convert(std::vector<char>& bytes, std::size_t n, bool swapped, std::vector<double>& out) {
  for (std::size_t i = 0; i < n; ++i) {
    char* at = bytes.data() + i * sizeof(T);
    if (swapped) std::reverse(at, at + sizeof(T));
    T value;
    std::memcpy(&value, at, sizeof(T));
    out[i] = static_cast<double>(value);
  }
}

void convert(Element element, std::vector<char>& bytes, std::size_t n, bool swapped, std::vector<double>& out) {
  switch (element) {
    case Element::u8:
      return convert<std::uint8_t>(bytes, n, false, out);
    case Element::i8:
      return convert<std::int8_t>(bytes, n, false, out);
    case Element::u16:
      return convert<std::uint16_t>(bytes, n, swapped, out);
    case Element::i16:
      return convert<std::int16_t>(bytes, n, swapped, out);
    case Element::u32:
      return convert<std::uint32_t>(bytes, n, swapped, out);
    case Element::i32:
      return convert<std::int32_t>(bytes, n, swapped, out);
    case Element::u64:
      return convert<std::uint64_t>(bytes, n, swapped, out);
    case Element::i64:
      return convert<std::int64_t>(bytes, n, swapped, out);
    case Element::f32:
      return convert<float>(bytes, n, swapped, out);
    case Element::f64:
      return convert<double>(bytes, n, swapped, out);
  }
}

}  // namespace

int bytes_of(Element element) {
  switch (element) {
    case Element::u8:
    case Element::i8:
      return 1;
    case Element::u16:
    case Element::i16:
      return 2;
    case Element::u32:
    case Element::i32:
    case Element::f32:
      return 4;
    default:
      return 8;
  }
}

void fail_label_file(const std::filesystem::path& file, const std::string& what) {
  throw LabelMapError("label map " + told_name(file) + ": " + what);
}

void check_placement(const Placement& place, int layers, const std::filesystem::path& file) {
  // Two bytes a voxel: half a gigabyte at most. The largest scans have a third of it.
  constexpr double kMostVoxels = 268435456.0;
  double count = 1.0;
  for (const int n : place.size) {
    if (n < 1 || n > 4096) fail_label_file(file, "a size of " + std::to_string(n) + " voxels; expected 1 to 4096");
    count *= n;
  }
  if (count > kMostVoxels) fail_label_file(file, "more than 268 million voxels; crop it to the head");
  if (layers < 1 || layers > 64)
    fail_label_file(file, std::to_string(layers) + " layers of segments; expected 1 to 64");
  for (const auto& step : place.step) {
    const double mm = norm(step);
    if (!(mm > 1e-3 && mm < 100.0)) fail_label_file(file, "voxels that are not between 0.001 and 100 mm large");
  }
  const auto s = place.spacing();
  if (!(place.voxel_mm3() > 0.01 * s[0] * s[1] * s[2])) fail_label_file(file, "its axes span no volume");
  for (const double v : place.origin) {
    if (!(std::abs(v) < 1e5)) fail_label_file(file, "its origin is not a place near a patient");
  }
}

void check_enough_bytes(const std::filesystem::path& file, const VoxelLayout& layout, std::size_t count) {
  std::error_code failed;
  const auto there = static_cast<double>(std::filesystem::file_size(file, failed));
  const double wanted = static_cast<double>(layout.skip) + static_cast<double>(count) * bytes_of(layout.element);
  constexpr double kMostPacking = 1032.0;  // deflate's own limit
  const double most = (there - static_cast<double>(layout.at)) * (layout.gzip ? kMostPacking : 1.0);
  if (failed || most < wanted) fail_label_file(file, "the voxel data is cut short; write the file again");
}

void read_voxels(const std::filesystem::path& file, const VoxelLayout& layout, std::size_t count,
                 const std::function<void(const double*, std::size_t)>& take) {
  ByteSource source(file, layout.at, layout.gzip);
  constexpr std::size_t kRun = 65536;
  const auto width = static_cast<std::size_t>(bytes_of(layout.element));
  std::vector<char> bytes(kRun * width);
  std::vector<double> values(kRun);
  for (std::uint64_t skip = layout.skip; skip > 0;) {
    const auto got = source.read(bytes.data(), static_cast<std::size_t>(std::min<std::uint64_t>(skip, bytes.size())));
    if (got == 0) fail_label_file(file, "the voxel data is cut short or damaged; write the file again");
    skip -= got;
  }
  while (count > 0) {
    const auto n = std::min(count, kRun);
    if (source.read(bytes.data(), n * width) != n * width)
      fail_label_file(file, "the voxel data is cut short or damaged; write the file again");
    convert(layout.element, bytes, n, layout.big_endian, values);
    take(values.data(), n);
    count -= n;
  }
}

bool is_gzip(const std::filesystem::path& file) {
  std::array<char, 2> mark{};
  std::ifstream in(file, std::ios::binary);
  return in.read(mark.data(), mark.size()) && std::string(mark.data(), mark.size()) == kGzipMark;
}

std::string first_bytes(const std::filesystem::path& file, std::size_t count) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) fail_label_file(file, "cannot be opened");
  std::string bytes(count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.rfind(kGzipMark, 0) != 0) return bytes;
  bytes.assign(count, '\0');
  ByteSource source(file, 0, true);
  bytes.resize(source.read(bytes.data(), count));
  return bytes;
}

}  // namespace vallecula::pipeline

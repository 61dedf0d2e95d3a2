#include "pipeline/dicom/volume_file.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "pipeline/dicom/picture_reader.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {
namespace {

constexpr const char* kCutShort = "its voxels are cut short or damaged; copy the file again";

bool is_gzip(std::string_view bytes) {
  return bytes.size() > 2 && static_cast<unsigned char>(bytes[0]) == 0x1f &&
         static_cast<unsigned char>(bytes[1]) == 0x8b;
}

/// Bytes one after the other, unpacked where need be.
class Source {
 public:
  Source(std::string_view bytes, bool packed) : bytes_(bytes), packed_(packed) {
    if (packed_ && inflateInit2(&stream_, 15 + 32) != Z_OK) throw std::bad_alloc();  // gzip or zlib, by its first bytes
  }
  ~Source() {
    if (packed_) inflateEnd(&stream_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  /// How many bytes were there, up to `count`.
  std::size_t take(char* to, std::size_t count) {
    if (!packed_) {
      const auto n = std::min(count, bytes_.size() - at_);
      std::memcpy(to, bytes_.data() + at_, n);
      at_ += n;
      return n;
    }
    std::size_t done = 0;
    while (done < count) {
      const auto room = static_cast<uInt>(std::min<std::size_t>(count - done, 1U << 30));
      const auto feed = static_cast<uInt>(std::min<std::size_t>(bytes_.size() - at_, 1U << 30));
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes_.data() + at_));
      stream_.avail_in = feed;
      stream_.next_out = reinterpret_cast<Bytef*>(to + done);
      stream_.avail_out = room;
      const int state = inflate(&stream_, Z_NO_FLUSH);
      at_ += feed - stream_.avail_in;
      const auto got = room - stream_.avail_out;
      done += got;
      if (state != Z_OK || (got == 0 && feed == stream_.avail_in)) break;
    }
    return done;
  }

 private:
  std::string_view bytes_;
  bool packed_;
  std::size_t at_ = 0;
  z_stream stream_{};
};

template <class T>
std::size_t convert(const VolumeHeader& header, std::vector<char>& raw, std::size_t count, std::int16_t* hu) {
  std::size_t clamped = 0;
  for (std::size_t i = 0; i < count; ++i) {
    char* word = raw.data() + i * sizeof(T);
    if (header.big_endian) std::reverse(word, word + sizeof(T));
    T value;
    std::memcpy(&value, word, sizeof(T));
    const double exact = header.slope * static_cast<double>(value) + header.intercept;
    if (std::isnan(exact)) {
      hu[i] = -1024;
      continue;
    }
    hu[i] = rounded_hu(static_cast<double>(value), header.slope, header.intercept);
    clamped += exact > 32767.5 || exact < -32768.5 ? 1 : 0;
  }
  return clamped;
}

}  // namespace

std::optional<VolumeHeader> volume_header(std::string_view bytes) {
  if (is_nrrd(bytes)) return nrrd_header(bytes);
  if (is_gzip(bytes)) {
    std::string head(348, '\0');
    Source source(bytes, true);
    head.resize(source.take(head.data(), head.size()));
    if (!is_nifti(head)) return {};
    auto header = nifti_header(head);
    header.whole_file_packed = true;
    return header;
  }
  if (is_nifti(bytes)) return nifti_header(bytes);
  if (is_meta_image(bytes)) return meta_image_header(bytes);
  return {};
}

std::size_t read_voxels(const VolumeHeader& header, std::string_view data, std::int16_t* hu,
                        const std::function<void(double)>& beat) {
  const std::size_t count = header.geometry.count();
  const std::size_t word = bytes_of(header.type);
  std::size_t skip = header.data_at;
  if (header.data_at_end) {
    if (header.packed || data.size() < count * word) throw SeriesError(kCutShort);
    skip = data.size() - count * word;
  }
  if (!header.whole_file_packed) {
    if (skip > data.size()) throw SeriesError(kCutShort);
    data.remove_prefix(skip);
    if (!header.packed && data.size() < count * word) throw SeriesError(kCutShort);
    skip = 0;
  }
  Source source(data, header.packed || header.whole_file_packed);
  std::vector<char> raw(std::size_t{1} << 20);
  while (skip > 0) {
    const auto got = source.take(raw.data(), std::min(skip, raw.size()));
    if (got == 0) throw SeriesError(kCutShort);
    skip -= got;
  }
  std::size_t clamped = 0;
  for (std::size_t done = 0; done < count;) {
    const std::size_t now = std::min(count - done, raw.size() / word);
    if (source.take(raw.data(), now * word) != now * word) throw SeriesError(kCutShort);
    switch (header.type) {
      case VoxelType::int8:
        clamped += convert<std::int8_t>(header, raw, now, hu + done);
        break;
      case VoxelType::uint8:
        clamped += convert<std::uint8_t>(header, raw, now, hu + done);
        break;
      case VoxelType::int16:
        clamped += convert<std::int16_t>(header, raw, now, hu + done);
        break;
      case VoxelType::uint16:
        clamped += convert<std::uint16_t>(header, raw, now, hu + done);
        break;
      case VoxelType::int32:
        clamped += convert<std::int32_t>(header, raw, now, hu + done);
        break;
      case VoxelType::uint32:
        clamped += convert<std::uint32_t>(header, raw, now, hu + done);
        break;
      case VoxelType::float32:
        clamped += convert<float>(header, raw, now, hu + done);
        break;
      case VoxelType::float64:
        clamped += convert<double>(header, raw, now, hu + done);
        break;
    }
    done += now;
    if (beat) beat(static_cast<double>(done) / static_cast<double>(count));
  }
  return clamped;
}

}  // namespace vallecula::pipeline

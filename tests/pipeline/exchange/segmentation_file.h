// A DICOM segmentation written byte by byte, so that the reader is not tested against the library it reads with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace vallecula::pipeline::test {

struct SegmentationFrame {
  int segment = 1;
  std::string position;            ///< "x\\y\\z"
  std::vector<std::uint8_t> ones;  ///< rows * columns, 0 or 1
};

struct SegmentationFile {
  std::string modality = "SEG";
  std::string type = "BINARY";
  std::vector<std::array<std::string, 2>> segments;  ///< label and SNOMED code, numbered from 1
  std::string orientation = "1\\0\\0\\0\\1\\0";
  std::string spacing = "1\\1";
  std::string thickness = "1";
  bool open_lengths = false;  ///< sequences and items end at their delimiters, as most programs write them
  int rows = 0;
  int columns = 0;
  std::vector<SegmentationFrame> frames;
};

inline std::string bytes_of(std::uint32_t v, int n) {
  std::string t;
  for (int i = 0; i < n; ++i) t += static_cast<char>((v >> (8 * i)) & 0xff);
  return t;
}

inline std::string element(int group, int id, const std::string& vr, std::string value) {
  if (value.size() % 2 != 0) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
  const bool long_form = vr == "OB" || vr == "SQ";
  const auto size = static_cast<std::uint32_t>(value.size());
  return bytes_of(group, 2) + bytes_of(id, 2) + vr +
         (long_form ? std::string(2, '\0') + bytes_of(size, 4) : bytes_of(size, 2)) + value;
}

/// A sequence of items, each the elements in it.
inline std::string sequence(int group, int id, const std::vector<std::string>& items, bool open_lengths) {
  const std::string open(4, '\xff');
  std::string value;
  for (const auto& in : items) {
    const auto size = bytes_of(static_cast<std::uint32_t>(in.size()), 4);
    value += bytes_of(0xfffe, 2) + bytes_of(0xe000, 2) + (open_lengths ? open : size) + in;
    if (open_lengths) value += bytes_of(0xfffe, 2) + bytes_of(0xe00d, 2) + bytes_of(0, 4);
  }
  if (!open_lengths) return element(group, id, "SQ", value);
  return bytes_of(group, 2) + bytes_of(id, 2) + "SQ" + std::string(2, '\0') + open + value + bytes_of(0xfffe, 2) +
         bytes_of(0xe0dd, 2) + bytes_of(0, 4);
}

inline void write_segmentation(const SegmentationFile& s, const std::filesystem::path& file) {
  const std::string uid = "1.2.840.10008.5.1.4.1.1.66.4";
  const auto meta = element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", uid) +
                    element(2, 3, "UI", "1.2.3.4") + element(2, 0x10, "UI", "1.2.840.10008.1.2.1") +
                    element(2, 0x12, "UI", "1.2.3.99");
  std::string out = std::string(128, '\0') + "DICM" +
                    element(2, 0, "UL", bytes_of(static_cast<std::uint32_t>(meta.size()), 4)) + meta;
  out += element(8, 0x16, "UI", uid) + element(8, 0x18, "UI", "1.2.3.4") + element(8, 0x60, "CS", s.modality);
  out += element(0x10, 0x10, "PN", "Doe^Jane");
  out += element(0x28, 2, "US", bytes_of(1, 2)) + element(0x28, 4, "CS", "MONOCHROME2");
  out += element(0x28, 8, "IS", std::to_string(s.frames.size()));
  out += element(0x28, 0x10, "US", bytes_of(s.rows, 2)) + element(0x28, 0x11, "US", bytes_of(s.columns, 2));
  out += element(0x28, 0x100, "US", bytes_of(1, 2)) + element(0x28, 0x101, "US", bytes_of(1, 2)) +
         element(0x28, 0x102, "US", bytes_of(0, 2)) + element(0x28, 0x103, "US", bytes_of(0, 2));
  const auto list = [&](int group, int id, const std::vector<std::string>& items) {
    return sequence(group, id, items, s.open_lengths);
  };
  std::vector<std::string> segments;
  for (std::size_t i = 0; i < s.segments.size(); ++i) {
    const auto code = element(8, 0x100, "SH", s.segments[i][1]) + element(8, 0x102, "SH", "SCT");
    segments.push_back(element(0x62, 4, "US", bytes_of(static_cast<std::uint32_t>(i + 1), 2)) +
                       element(0x62, 5, "LO", s.segments[i][0]) + list(0x62, 0xf, {code}));
  }
  out += element(0x62, 1, "CS", s.type) + list(0x62, 2, segments);
  out += list(0x5200, 0x9229,
              {list(0x20, 0x9116, {element(0x20, 0x37, "DS", s.orientation)}) +
               list(0x28, 0x9110, {element(0x18, 0x50, "DS", s.thickness) + element(0x28, 0x30, "DS", s.spacing)})});
  std::vector<std::string> frames;
  std::vector<std::uint8_t> bits;
  std::size_t n = 0;
  for (const auto& frame : s.frames) {
    frames.push_back(list(0x20, 0x9113, {element(0x20, 0x32, "DS", frame.position)}) +
                     list(0x62, 0xa, {element(0x62, 0xb, "US", bytes_of(frame.segment, 2))}));
    for (const auto one : frame.ones) {
      if (n % 8 == 0) bits.push_back(0);
      bits.back() = static_cast<std::uint8_t>(bits.back() | one << (n % 8));
      ++n;
    }
  }
  out += list(0x5200, 0x9230, frames);
  out += element(0x7fe0, 0x10, "OB", std::string(bits.begin(), bits.end()));
  std::ofstream(file, std::ios::binary) << out;
}

}  // namespace vallecula::pipeline::test

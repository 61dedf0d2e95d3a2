// Writes DICOM files byte by byte, so that the reader is not tested against the library it reads with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace vallecula::pipeline::test {

/// Elements in the order of their tags: (group << 16 | element) -> representation, value. Explicit little endian.
using Elements = std::map<std::uint32_t, std::pair<std::string, std::string>>;

inline std::string bytes_of(std::uint32_t v, int bytes) {
  std::string t;
  for (int i = 0; i < bytes; ++i) t += static_cast<char>((v >> (8 * i)) & 0xff);
  return t;
}

inline std::string written(const Elements& elements) {
  std::string out;
  for (auto [tag, element] : elements) {
    auto& [vr, value] = element;
    if (value.size() % 2 != 0) value += vr == "UI" || vr == "OB" ? '\0' : ' ';
    const bool is_long = vr == "OW" || vr == "OB" || vr == "SQ" || vr == "UN";
    out += bytes_of(tag >> 16, 2) + bytes_of(tag & 0xffff, 2) + vr;
    if (is_long) out += std::string(2, '\0');
    out += bytes_of(static_cast<std::uint32_t>(value.size()), is_long ? 4 : 2) + value;
  }
  return out;
}

/// A sequence's value: items of stated length.
inline std::string items(const std::vector<Elements>& contents) {
  std::string out;
  for (const auto& c : contents) {
    const auto inside = written(c);
    out += bytes_of(0xe000fffe, 4) + bytes_of(static_cast<std::uint32_t>(inside.size()), 4) + inside;
  }
  return out;
}

inline std::string with_meta(const std::string& data_set, const std::string& sop_class = "1.2.840.10008.5.1.4.1.1.2") {
  const auto meta = written({{0x00020001, {"OB", std::string("\0\1", 2)}},
                             {0x00020002, {"UI", sop_class}},
                             {0x00020003, {"UI", "1.2.3.4.1"}},
                             {0x00020010, {"UI", "1.2.840.10008.1.2.1"}},
                             {0x00020012, {"UI", "1.2.3.99"}}});
  return std::string(128, '\0') + "DICM" +
         written({{0x00020000, {"UL", bytes_of(static_cast<std::uint32_t>(meta.size()), 4)}}}) + meta + data_set;
}

/// What a test may want to say, or leave out (empty strings are not written).
struct DicomSlice {
  std::string modality = "CT";
  std::string series = "1.2.3.4.5";
  std::string position = "0\\0\\0";
  std::string orientation = "1\\0\\0\\0\\1\\0";
  std::string spacing = "1\\1";  ///< between rows, between columns
  std::string slope = "1";
  std::string intercept = "-1024";
  std::string instance = "1";
  int columns = 0;
  int rows = 0;
  bool is_signed = false;
  int padding = -1;                   ///< stored value, -1: none
  std::vector<std::uint16_t> stored;  ///< raw bits
  Elements extra;                     ///< added, or in place of the above
};

inline Elements elements_of(const DicomSlice& s) {
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
  Elements e = {{0x00080016, {"UI", ct}},
                {0x00080018, {"UI", "1.2.3.4." + s.instance}},
                {0x00100010, {"PN", "Doe^Jane"}},
                {0x00100020, {"LO", "SECRET-ID-77"}},
                {0x0020000d, {"UI", "1.2.3.9"}},
                {0x0020000e, {"UI", s.series}},
                {0x00200013, {"IS", "1"}},
                {0x00280002, {"US", bytes_of(1, 2)}},
                {0x00280004, {"CS", "MONOCHROME2"}},
                {0x00280010, {"US", bytes_of(static_cast<std::uint32_t>(s.rows), 2)}},
                {0x00280011, {"US", bytes_of(static_cast<std::uint32_t>(s.columns), 2)}},
                {0x00280100, {"US", bytes_of(16, 2)}},
                {0x00280101, {"US", bytes_of(16, 2)}},
                {0x00280102, {"US", bytes_of(15, 2)}},
                {0x00280103, {"US", bytes_of(s.is_signed ? 1 : 0, 2)}},
                {0x7fe00010, {"OW", std::string(reinterpret_cast<const char*>(s.stored.data()), s.stored.size() * 2)}}};
  if (s.padding >= 0) e[0x00280120] = {s.is_signed ? "SS" : "US", bytes_of(static_cast<std::uint32_t>(s.padding), 2)};
  const auto text = [&](std::uint32_t tag, const char* vr, const std::string& value) {
    if (!value.empty()) e[tag] = {vr, value};
  };
  text(0x00080060, "CS", s.modality);
  text(0x00200032, "DS", s.position);
  text(0x00200037, "DS", s.orientation);
  text(0x00280030, "DS", s.spacing);
  text(0x00281052, "DS", s.intercept);
  text(0x00281053, "DS", s.slope);
  for (const auto& [tag, element] : s.extra) e[tag] = element;
  return e;
}

inline std::string dicom_bytes(const DicomSlice& s) { return with_meta(written(elements_of(s))); }

inline void write_bytes(const std::string& bytes, const std::filesystem::path& file) {
  std::ofstream(file, std::ios::binary) << bytes;
}

inline void write_dicom(const DicomSlice& s, const std::filesystem::path& file) { write_bytes(dicom_bytes(s), file); }

inline std::string decimal_string(const std::vector<double>& values) {
  std::ostringstream t;
  t.precision(10);
  for (std::size_t i = 0; i < values.size(); ++i) t << (i > 0 ? "\\" : "") << values[i];
  return t.str();
}

/// The slices as one Enhanced CT, a frame each in the given order: position and rescale of each frame its own.
inline std::string enhanced_bytes(const std::vector<DicomSlice>& slices) {
  std::vector<Elements> frames;
  std::string pixels;
  for (const auto& s : slices) {
    frames.push_back(
        {{0x00209113, {"SQ", items({{{0x00200032, {"DS", s.position}}}})}},
         {0x00289145, {"SQ", items({{{0x00281052, {"DS", s.intercept}}, {0x00281053, {"DS", s.slope}}}})}}});
    for (const auto v : s.stored) pixels += bytes_of(v, 2);
  }
  auto d = slices.front();
  d.extra[0x00280008] = {"IS", std::to_string(slices.size())};
  d.extra[0x52009229] = {"SQ", items({{{0x00209116, {"SQ", items({{{0x00200037, {"DS", d.orientation}}}})}},
                                       {0x00289110, {"SQ", items({{{0x00280030, {"DS", d.spacing}}}})}}}})};
  d.extra[0x52009230] = {"SQ", items(frames)};
  d.extra[0x7fe00010] = {"OW", pixels};
  for (auto* own : {&d.position, &d.orientation, &d.spacing, &d.slope, &d.intercept}) own->clear();
  return with_meta(written(elements_of(d)), "1.2.840.10008.5.1.4.1.1.2.1");
}

}  // namespace vallecula::pipeline::test

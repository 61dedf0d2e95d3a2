// Writes DICOM files byte by byte, so that the reader is not tested against the library it reads with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace vallecula::pipeline::test {

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
};

inline void write_dicom(const DicomSlice& s, const std::filesystem::path& file) {
  std::string out(128, '\0');
  out += "DICM";
  const auto number = [](std::uint32_t v, int bytes) {
    std::string t;
    for (int i = 0; i < bytes; ++i) t += static_cast<char>((v >> (8 * i)) & 0xff);
    return t;
  };
  const auto element = [&](int group, int id, const char* vr, std::string value) {
    if (value.size() % 2 != 0) value += std::string(vr) == "UI" ? '\0' : ' ';
    std::string t = number(group, 2) + number(id, 2) + vr;
    const bool long_form = std::string(vr) == "OW" || std::string(vr) == "OB";
    t += long_form ? std::string(2, '\0') + number(static_cast<std::uint32_t>(value.size()), 4)
                   : number(static_cast<std::uint32_t>(value.size()), 2);
    return t + value;
  };
  const auto text = [&](int group, int id, const char* vr, const std::string& value) {
    return value.empty() ? std::string() : element(group, id, vr, value);
  };
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
  const auto instance = "1.2.3.4." + s.instance;
  const auto meta = element(2, 1, "OB", std::string("\0\1", 2)) + element(2, 2, "UI", ct) +
                    element(2, 3, "UI", instance) + element(2, 0x10, "UI", "1.2.840.10008.1.2.1") +
                    element(2, 0x12, "UI", "1.2.3.99");
  out += element(2, 0, "UL", number(static_cast<std::uint32_t>(meta.size()), 4)) + meta;
  out += element(8, 0x16, "UI", ct) + element(8, 0x18, "UI", instance) + text(8, 0x60, "CS", s.modality);
  out += element(0x10, 0x10, "PN", "Doe^Jane") + element(0x10, 0x20, "LO", "SECRET-ID-77");
  out += element(0x20, 0xd, "UI", "1.2.3.9") + element(0x20, 0xe, "UI", s.series) + element(0x20, 0x13, "IS", "1");
  out += text(0x20, 0x32, "DS", s.position) + text(0x20, 0x37, "DS", s.orientation);
  out += element(0x28, 2, "US", number(1, 2)) + element(0x28, 4, "CS", "MONOCHROME2");
  out += element(0x28, 0x10, "US", number(s.rows, 2)) + element(0x28, 0x11, "US", number(s.columns, 2));
  out += text(0x28, 0x30, "DS", s.spacing);
  out += element(0x28, 0x100, "US", number(16, 2)) + element(0x28, 0x101, "US", number(16, 2)) +
         element(0x28, 0x102, "US", number(15, 2));
  out += element(0x28, 0x103, "US", number(s.is_signed ? 1 : 0, 2));
  if (s.padding >= 0) out += element(0x28, 0x120, s.is_signed ? "SS" : "US", number(s.padding, 2));
  out += text(0x28, 0x1052, "DS", s.intercept) + text(0x28, 0x1053, "DS", s.slope);
  std::string pixels(reinterpret_cast<const char*>(s.stored.data()), s.stored.size() * 2);
  out += element(0x7fe0, 0x10, "OW", pixels);
  std::ofstream(file, std::ios::binary) << out;
}

inline std::string decimal_string(const std::vector<double>& values) {
  std::ostringstream t;
  t.precision(10);
  for (std::size_t i = 0; i < values.size(); ++i) t << (i > 0 ? "\\" : "") << values[i];
  return t.str();
}

}  // namespace vallecula::pipeline::test

#include "pipeline/exchange/nrrd_file.h"

#include <fstream>
#include <sstream>
#include <vector>

namespace vallecula::pipeline {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "(a,b,c)" at the front of `text`, which is consumed.
Vector3 take_vector(std::istringstream& text, const std::filesystem::path& file) {
  Vector3 v{};
  char open = 0;
  char comma = 0;
  char second = 0;
  char close = 0;
  if (!(text >> open >> v[0] >> comma >> v[1] >> second >> v[2] >> close) || open != '(' || comma != ',' ||
      second != ',' || close != ')') {
    fail_label_file(file, "a vector of the header cannot be read; expected (x,y,z)");
  }
  return v;
}

Element element_of(const std::string& type, const std::filesystem::path& file) {
  static const std::map<std::string, Element> kNames = {{"signed char", Element::i8},
                                                        {"int8", Element::i8},
                                                        {"int8_t", Element::i8},
                                                        {"uchar", Element::u8},
                                                        {"unsigned char", Element::u8},
                                                        {"uint8", Element::u8},
                                                        {"uint8_t", Element::u8},
                                                        {"short", Element::i16},
                                                        {"short int", Element::i16},
                                                        {"signed short", Element::i16},
                                                        {"signed short int", Element::i16},
                                                        {"int16", Element::i16},
                                                        {"int16_t", Element::i16},
                                                        {"ushort", Element::u16},
                                                        {"unsigned short", Element::u16},
                                                        {"unsigned short int", Element::u16},
                                                        {"uint16", Element::u16},
                                                        {"uint16_t", Element::u16},
                                                        {"int", Element::i32},
                                                        {"signed int", Element::i32},
                                                        {"int32", Element::i32},
                                                        {"int32_t", Element::i32},
                                                        {"uint", Element::u32},
                                                        {"unsigned int", Element::u32},
                                                        {"uint32", Element::u32},
                                                        {"uint32_t", Element::u32},
                                                        {"longlong", Element::i64},
                                                        {"long long", Element::i64},
                                                        {"long long int", Element::i64},
                                                        {"signed long long", Element::i64},
                                                        {"int64", Element::i64},
                                                        {"int64_t", Element::i64},
                                                        {"ulonglong", Element::u64},
                                                        {"unsigned long long", Element::u64},
                                                        {"uint64", Element::u64},
                                                        {"uint64_t", Element::u64},
                                                        {"float", Element::f32},
                                                        {"double", Element::f64}};
  const auto found = kNames.find(type);
  if (found == kNames.end()) fail_label_file(file, "voxels of type \"" + type + "\"; expected whole numbers");
  return found->second;
}

/// The signs that turn the file's x and y into LPS.
Vector3 signs_to_lps(const std::string& space, const std::filesystem::path& file) {
  if (space == "left-posterior-superior" || space == "LPS") return {1.0, 1.0, 1.0};
  if (space == "right-anterior-superior" || space == "RAS") return {-1.0, -1.0, 1.0};
  if (space == "left-anterior-superior" || space == "LAS") return {1.0, -1.0, 1.0};
  fail_label_file(file, "space \"" + space + "\"; expected left-posterior-superior or right-anterior-superior");
}

}  // namespace

NrrdHeader read_nrrd_header(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail_label_file(file, "cannot be opened");
  std::string line;
  std::getline(in, line);
  if (line.rfind("NRRD000", 0) != 0) fail_label_file(file, "this is not an NRRD file");
  NrrdHeader header;
  constexpr std::size_t kMostBytes = 1U << 24;
  while (std::getline(in, line) && static_cast<std::size_t>(in.tellg()) < kMostBytes) {
    line = trimmed(line);
    if (line.empty()) {
      header.data_at = static_cast<std::uint64_t>(in.tellg());
      return header;
    }
    if (line[0] == '#') continue;
    const auto key = line.find(":=");
    const auto field = line.find(": ");
    if (key != std::string::npos && (field == std::string::npos || key < field)) {
      header.keys[trimmed(line.substr(0, key))] = trimmed(line.substr(key + 2));
    } else if (field != std::string::npos) {
      header.fields[trimmed(line.substr(0, field))] = trimmed(line.substr(field + 2));
    }
  }
  fail_label_file(file, "the header has no end; the file is cut short");
}

NrrdVoxels nrrd_voxels(const NrrdHeader& header, const std::filesystem::path& file) {
  const auto has = [&](const char* name) { return header.fields.count(name) != 0; };
  const auto field = [&](const char* name) {
    if (!has(name)) fail_label_file(file, std::string("the field \"") + name + "\" is missing");
    return header.fields.at(name);
  };
  if (has("data file") || has("datafile"))
    fail_label_file(file, "its voxels are in another file; save it as one .nrrd");
  for (const auto* skip : {"line skip", "byte skip", "lineskip", "byteskip"}) {
    if (has(skip) && header.fields.at(skip) != "0") fail_label_file(file, "skipped lines or bytes are not read");
  }
  NrrdVoxels out;
  const auto dimension = field("dimension");
  if (dimension != "3" && dimension != "4")
    fail_label_file(file, "dimension " + dimension + "; expected 3, or 4 with the segments' layers first");
  out.layout.element = element_of(field("type"), file);
  out.layout.at = header.data_at;
  if (bytes_of(out.layout.element) > 1) {
    const auto endian = field("endian");
    if (endian != "little" && endian != "big") fail_label_file(file, "endian \"" + endian + "\"");
    out.layout.big_endian = endian == "big";
  }
  const auto encoding = field("encoding");
  out.layout.gzip = encoding == "gzip" || encoding == "gz";
  if (!out.layout.gzip && encoding != "raw")
    fail_label_file(file, "encoding \"" + encoding + "\"; expected raw or gzip");

  std::istringstream sizes(field("sizes"));
  if (dimension == "4" && !(sizes >> out.layers)) fail_label_file(file, "\"sizes\" cannot be read");
  for (int& n : out.place.size) {
    if (!(sizes >> n)) fail_label_file(file, "\"sizes\" cannot be read");
  }
  const auto signs = signs_to_lps(field("space"), file);
  std::istringstream directions(field("space directions"));
  if (dimension == "4") {
    std::string none;
    directions >> none;
    if (none != "none") fail_label_file(file, "the layers of segments are not the first axis; save it with 3D Slicer");
  }
  for (auto& step : out.place.step) {
    step = take_vector(directions, file);
    for (int a = 0; a < 3; ++a) step[a] *= signs[a];
  }
  std::istringstream origin(field("space origin"));
  out.place.origin = take_vector(origin, file);
  for (int a = 0; a < 3; ++a) out.place.origin[a] *= signs[a];
  check_placement(out.place, out.layers, file);
  return out;
}

}  // namespace vallecula::pipeline

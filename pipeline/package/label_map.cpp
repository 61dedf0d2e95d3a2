#include "pipeline/package/label_map.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace vallecula::pipeline {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw LabelMapError("label map " + file.filename().string() + ": " + what);
}

std::string extent_of(const Labels& labels, std::uint8_t value) {
  std::array<int, 3> low = labels.grid.size;
  std::array<int, 3> high{-1, -1, -1};
  for (int z = 0; z < labels.grid.size[2]; ++z) {
    for (int y = 0; y < labels.grid.size[1]; ++y) {
      for (int x = 0; x < labels.grid.size[0]; ++x) {
        if (labels.at(x, y, z) != value) continue;
        const std::array<int, 3> c{x, y, z};
        for (int a = 0; a < 3; ++a) {
          low[a] = std::min(low[a], c[a]);
          high[a] = std::max(high[a], c[a]);
        }
      }
    }
  }
  if (high[0] < 0) return {};
  std::ostringstream text;
  text << low[0] << ' ' << high[0] << ' ' << low[1] << ' ' << high[1] << ' ' << low[2] << ' ' << high[2];
  return text.str();
}

std::vector<std::uint8_t> deflate_gzip(const std::vector<std::uint8_t>& data, const std::filesystem::path& file) {
  z_stream stream{};
  if (deflateInit2(&stream, 4, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK) fail(file, "zlib did not start");
  std::vector<std::uint8_t> out(deflateBound(&stream, data.size()));
  stream.next_in = const_cast<Bytef*>(data.data());
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  const int state = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (state != Z_STREAM_END) fail(file, "compression failed");
  return out;
}

std::vector<std::uint8_t> inflate_gzip(const std::string& data, std::size_t expected,
                                       const std::filesystem::path& file) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK) fail(file, "zlib did not start");
  std::vector<std::uint8_t> out(expected);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  const int state = inflate(&stream, Z_FINISH);
  const bool whole = stream.total_out == expected && (state == Z_STREAM_END || state == Z_BUF_ERROR);
  inflateEnd(&stream);
  if (!whole) fail(file, "the voxel data is cut short or damaged; write the file again");
  return out;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// "(a,b,c)" at the front of `text`, which is consumed.
std::array<double, 3> take_vector(std::istringstream& text, const std::filesystem::path& file) {
  std::array<double, 3> v{};
  char open = 0;
  char comma = 0;
  char close = 0;
  if (!(text >> open >> v[0] >> comma >> v[1] >> comma >> v[2] >> close) || open != '(' || close != ')') {
    fail(file, "a vector of the header cannot be read; expected (x,y,z)");
  }
  return v;
}

struct Header {
  std::map<std::string, std::string> fields;
  std::map<std::string, std::string> keys;
};

Header read_header(std::istream& in, const std::filesystem::path& file) {
  std::string line;
  std::getline(in, line);
  if (line.rfind("NRRD000", 0) != 0) fail(file, "this is not an NRRD file");
  Header header;
  while (std::getline(in, line)) {
    line = trimmed(line);
    if (line.empty()) return header;
    if (line[0] == '#') continue;
    const auto key = line.find(":=");
    const auto field = line.find(": ");
    if (key != std::string::npos && (field == std::string::npos || key < field)) {
      header.keys[trimmed(line.substr(0, key))] = trimmed(line.substr(key + 2));
    } else if (field != std::string::npos) {
      header.fields[trimmed(line.substr(0, field))] = trimmed(line.substr(field + 2));
    }
  }
  fail(file, "the header has no end; the file is cut short");
}

Grid grid_of(const Header& header, const std::filesystem::path& file) {
  const auto field = [&](const char* name) {
    const auto found = header.fields.find(name);
    if (found == header.fields.end()) fail(file, std::string("the field \"") + name + "\" is missing");
    return found->second;
  };
  if (field("dimension") != "3") fail(file, "expected dimension 3");
  const auto type = field("type");
  if (type != "uint8" && type != "unsigned char" && type != "uchar" && type != "uint8_t") {
    fail(file, "voxels of type \"" + type + "\"; expected unsigned char");
  }
  const auto space = field("space");
  if (space != "left-posterior-superior" && space != "LPS") {
    fail(file, "space \"" + space + "\"; expected left-posterior-superior");
  }
  Grid grid;
  std::istringstream sizes(field("sizes"));
  for (int& n : grid.size) {
    if (!(sizes >> n) || n < 1 || n > 4096) fail(file, "\"sizes\" cannot be read");
  }
  std::istringstream directions(field("space directions"));
  for (int a = 0; a < 3; ++a) {
    const auto v = take_vector(directions, file);
    for (int b = 0; b < 3; ++b) {
      if (a != b && std::abs(v[b]) > 1e-6) fail(file, "the grid is not aligned with the patient axes");
    }
    if (!(v[a] > 0.0)) fail(file, "an axis runs backwards; expected axes to left, posterior, superior");
    grid.spacing[a] = v[a];
  }
  std::istringstream origin(field("space origin"));
  grid.origin = take_vector(origin, file);
  return grid;
}

}  // namespace

void write_label_map(const Labels& labels, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  if (!out) fail(file, "cannot be created; is the folder writable?");
  const auto& g = labels.grid;
  out << "NRRD0004\n# Labels of a patient package; opens in 3D Slicer as a segmentation\n"
      << "type: unsigned char\ndimension: 3\nspace: left-posterior-superior\n"
      << "sizes: " << g.size[0] << ' ' << g.size[1] << ' ' << g.size[2] << '\n';
  out.precision(12);
  out << "space directions: (" << g.spacing[0] << ",0,0) (0," << g.spacing[1] << ",0) (0,0," << g.spacing[2] << ")\n"
      << "kinds: domain domain domain\nencoding: gzip\n"
      << "space origin: (" << g.origin[0] << ',' << g.origin[1] << ',' << g.origin[2] << ")\n";
  int segment = 0;
  for (const auto& label : kLabelNames) {
    const auto extent = extent_of(labels, label.value);
    if (extent.empty()) continue;
    const auto key = "Segment" + std::to_string(segment++) + "_";
    out << key << "ID:=Segment_" << static_cast<int>(label.value) << '\n'
        << key << "Name:=" << label.name << '\n'
        << key << "LabelValue:=" << static_cast<int>(label.value) << '\n'
        << key << "Layer:=0\n"
        << key << "Color:=" << label.rgb[0] << ' ' << label.rgb[1] << ' ' << label.rgb[2] << '\n'
        << key << "Extent:=" << extent << '\n';
  }
  out << '\n';
  const auto packed = deflate_gzip(labels.voxels, file);
  out.write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
  out.close();
  if (!out) fail(file, "cannot be written; is the disk full?");
}

Labels read_label_map(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(file, "cannot be opened");
  const auto header = read_header(in, file);
  Labels labels(grid_of(header, file));
  std::ostringstream rest;
  rest << in.rdbuf();
  const auto data = rest.str();
  const auto encoding = header.fields.count("encoding") ? header.fields.at("encoding") : std::string();
  if (encoding == "raw") {
    if (data.size() < labels.voxels.size()) fail(file, "the voxel data is cut short; write the file again");
    std::copy_n(data.begin(), labels.voxels.size(), labels.voxels.begin());
  } else if (encoding == "gzip" || encoding == "gz") {
    labels.voxels = inflate_gzip(data, labels.voxels.size(), file);
  } else {
    fail(file, "encoding \"" + encoding + "\"; expected raw or gzip");
  }

  // A segmentation edited elsewhere may number its segments otherwise: the names decide.
  std::array<std::uint8_t, 256> to{};
  for (int v = 0; v < 256; ++v) to[v] = static_cast<std::uint8_t>(v);
  for (const auto& [key, name] : header.keys) {
    const auto end = key.find("_Name");
    if (key.rfind("Segment", 0) != 0 || end == std::string::npos) continue;
    const auto value = header.keys.find(key.substr(0, end) + "_LabelValue");
    if (value == header.keys.end()) continue;
    for (const auto& label : kLabelNames) {
      const int from = std::atoi(value->second.c_str());
      if (name == label.name && from > 0 && from < 256) to[from] = label.value;
    }
  }
  for (auto& v : labels.voxels) v = to[v];
  return labels;
}

}  // namespace vallecula::pipeline

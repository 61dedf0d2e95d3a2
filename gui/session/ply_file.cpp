#include "gui/session/ply_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace vallecula::gui {

namespace {

using engine::TriangleMesh;
using engine::Vec3;

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error(what); }

struct Property {
  std::string name, type, count_type;  ///< count_type: of a list; else empty
};
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

/// Numbers off the front of the data, one after another, as the header says they are written.
class Numbers {
 public:
  Numbers(const std::string& bytes, std::size_t from, const std::string& format)
      : at_(bytes.data() + from), end_(bytes.data() + bytes.size()), text_(format == "ascii") {
    if (!text_ && format != "binary_little_endian" && format != "binary_big_endian")
      refuse("its format '" + format.substr(0, 40) + "' is unknown");
    swap_ = (format == "binary_big_endian") == (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  }

  double next(const std::string& type) {
    if (text_) return next_word();
    if (type == "char" || type == "int8") return take<std::int8_t>();
    if (type == "uchar" || type == "uint8") return take<std::uint8_t>();
    if (type == "short" || type == "int16") return take<std::int16_t>();
    if (type == "ushort" || type == "uint16") return take<std::uint16_t>();
    if (type == "int" || type == "int32") return take<std::int32_t>();
    if (type == "uint" || type == "uint32") return take<std::uint32_t>();
    if (type == "float" || type == "float32") return take<float>();
    if (type == "double" || type == "float64") return take<double>();
    refuse("its type '" + type.substr(0, 40) + "' is unknown");
  }
  /// Bytes left: no more elements than that can follow.
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  double next_word() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t')) ++at_;
    if (at_ == end_) refuse("it is cut off");
    double value = 0.0;
    const auto [after, error] = std::from_chars(at_, end_, value);
    if (error == std::errc::invalid_argument) refuse("it has a word where a number must stand");
    at_ = after;
    return value;
  }
  template <class Number>
  Number take() {
    if (left() < sizeof(Number)) refuse("it is cut off");
    char bytes[sizeof(Number)];
    std::memcpy(bytes, at_, sizeof bytes);
    at_ += sizeof bytes;
    if (swap_) std::reverse(bytes, bytes + sizeof bytes);
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  const char* at_;
  const char* end_;
  bool text_, swap_ = false;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  std::size_t bytes = 0;
};

Header read_header(const std::string& bytes) {
  Header header;
  std::size_t at = 0;
  for (bool first = true;; first = false) {
    const std::size_t newline = bytes.find('\n', at);
    if (newline == std::string::npos || (first && bytes.compare(0, 3, "ply") != 0)) refuse("it is no PLY file");
    std::istringstream words(bytes.substr(at, newline - at));
    at = newline + 1;
    std::string keyword;
    words >> keyword;
    if (keyword == "end_header") break;
    if (keyword == "format") words >> header.format;
    if (keyword == "element") {
      Element element;
      words >> element.name >> element.count;
      if (!words) refuse("its header says no number of '" + element.name.substr(0, 40) + "'");
      header.elements.push_back(element);
    }
    if (keyword == "property" && !header.elements.empty()) {
      Property property;
      words >> property.type;
      if (property.type == "list") words >> property.count_type >> property.type;
      words >> property.name;
      header.elements.back().properties.push_back(property);
    }
  }
  header.bytes = at;
  return header;
}

template <class Number>
void put(std::string& out, Number value) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the file is little-endian");
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &value, sizeof bytes);
  out.append(bytes, sizeof bytes);
}

}  // namespace

TriangleMesh mesh_from_ply(const std::string& bytes) {
  const Header header = read_header(bytes);
  Numbers numbers(bytes, header.bytes, header.format);
  TriangleMesh mesh;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.count > numbers.left()) refuse("it is cut off");
    for (std::size_t i = 0; i < element.count; ++i) {
      Vec3 point = Vec3::Constant(std::nan(""));
      std::vector<int> face;
      for (const Property& property : element.properties) {
        const bool list = !property.count_type.empty();
        const double count = list ? numbers.next(property.count_type) : 1.0;
        if (!(count >= 0) || count > static_cast<double>(numbers.left())) refuse("it is cut off");
        const bool corners = list && (property.name == "vertex_indices" || property.name == "vertex_index");
        for (int k = 0; k < static_cast<int>(count); ++k) {
          const double value = numbers.next(property.type);
          if (corners) face.push_back(value >= 0 && value < 2e9 ? static_cast<int>(value) : -1);
          if (!list && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
            point[property.name[0] - 'x'] = value;
        }
      }
      if (element.name == "vertex") mesh.points.push_back(point);
      if (element.name != "face") continue;
      for (std::size_t k = 2; k < face.size(); ++k) mesh.triangles.push_back({face[0], face[k - 1], face[k]});
    }
  }
  for (const auto& t : mesh.triangles)
    for (const int v : t)
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.points.size())
        refuse("a face names a point that does not exist; it is damaged");
  return mesh;
}

std::string mesh_to_ply(const TriangleMesh& mesh, const std::string& comment) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment " + comment + "\nelement vertex " +
                      std::to_string(mesh.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) put(bytes, p[axis]);
  for (const auto& t : mesh.triangles) {
    put(bytes, std::uint8_t{3});
    for (const int v : t) put(bytes, static_cast<std::int32_t>(v));
  }
  return bytes;
}

}  // namespace vallecula::gui

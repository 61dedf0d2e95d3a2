#include "gui/lab/tool_shape.h"

#include <stdexcept>

#include "engine/tool/shapes.h"
#include "gui/lab/number_text.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;

constexpr double kLargest = 1.0;  // m
constexpr int kSphereRings = 6;   // 32,768 triangles: 0.03 % of the radius off at most

double metres(const std::string& word, const std::string& what) {
  const std::optional<double> value = number_in(word);
  if (!value || !(*value > 0) || !(*value < kLargest))
    throw std::invalid_argument("--tool " + what + ": '" + word + "' is not a length in metres above 0 and below 1");
  return *value;
}

/// `box:LxWxH` and the like: the three lengths.
Vec3 size_in(const std::string& what) {
  const std::size_t colon = what.find(':'), first = what.find('x', colon),
                    second = first == std::string::npos ? first : what.find('x', first + 1);
  if (second == std::string::npos)
    throw std::invalid_argument("--tool " + what + ": write " + what.substr(0, colon) +
                                ":LxWxH in metres, for instance " + what.substr(0, colon) + ":0.06x0.01x0.003");
  return {metres(what.substr(colon + 1, first - colon - 1), what),
          metres(what.substr(first + 1, second - first - 1), what), metres(what.substr(second + 1), what)};
}

}  // namespace

ToolMesh tool_shape(const std::string& what, double unit_m) {
  if (what.rfind("sphere:", 0) == 0) return {engine::sphere_surface(metres(what.substr(7), what), kSphereRings), {}};
  if (what.rfind("box:", 0) == 0) return {engine::box_surface(Vec3::Zero(), size_in(what)), {}};
  if (what.rfind("paddle:", 0) == 0) return {engine::paddle_surface(size_in(what)), {}};
  if (what.find('.') == std::string::npos)
    throw std::invalid_argument("--tool " + what +
                                ": give box:LxWxH, paddle:LxWxH, sphere:R, or a file .stl, .obj or .ply");
  return read_tool_mesh(what, unit_m, "--length-unit");
}

}  // namespace vallecula::gui

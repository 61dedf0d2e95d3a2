#include "device/trajectory.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>
#include <string_view>

#include "device/rotation.h"

namespace vallecula::device {
namespace {

constexpr std::size_t kMaxRows = 1000000;

/// Weighted harmonic mean of the neighbouring slopes, zero at a turning point: keeps the cubic monotone between
/// keyframes.
double monotone_slope(double left_slope, double right_slope, double left_s, double right_s) {
  if (!(left_slope * right_slope > 0.0)) return 0.0;
  const double a = 2.0 * right_s + left_s, b = right_s + 2.0 * left_s;
  return (a + b) / (a / left_slope + b / right_slope);
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlank = " \t\r";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// std::from_chars: the decimal point stays a point whatever the user's locale.
bool parse_number(std::string_view text, double& value) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

std::vector<std::string_view> columns(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0;;) {
    const auto comma = line.find(',', from);
    fields.push_back(line.substr(from, comma == std::string_view::npos ? comma : comma - from));
    if (comma == std::string_view::npos) return fields;
    from = comma + 1;
  }
}

bool names_columns(std::string_view line) {
  double ignored = 0.0;
  const auto fields = columns(line);
  return std::none_of(fields.begin(), fields.end(), [&](std::string_view f) { return parse_number(f, ignored); }) &&
         trimmed(fields.front()).find_first_of("tT") == 0;
}

}  // namespace

Trajectory::Trajectory(std::vector<Keyframe> keyframes) : keyframes_(std::move(keyframes)) {
  if (keyframes_.empty()) throw DeviceError("trajectory: no keyframe given; give at least one");
  for (std::size_t i = 0; i < keyframes_.size(); ++i) {
    Keyframe& k = keyframes_[i];
    const std::string which = "trajectory: keyframe " + std::to_string(i + 1);
    if (!std::isfinite(k.time_s) || !finite(k.position_m))
      throw DeviceError(which + " has a number that is not finite");
    if (i > 0 && !(k.time_s > keyframes_[i - 1].time_s)) {
      throw DeviceError(which + ": time " + std::to_string(k.time_s) + " s is not later than the one before (" +
                        std::to_string(keyframes_[i - 1].time_s) + " s)");
    }
    const double norm = std::sqrt(dot(k.rotation_wxyz, k.rotation_wxyz));
    if (!(std::abs(norm - 1.0) <= 0.01)) {
      throw DeviceError(which + ": rotation has length " + std::to_string(norm) +
                        "; a unit quaternion (w first) is needed");
    }
    k.rotation_wxyz = normalised(k.rotation_wxyz);
  }
  velocities_.assign(keyframes_.size(), {0, 0, 0});
  for (std::size_t i = 1; i + 1 < keyframes_.size(); ++i) {
    const double left_s = keyframes_[i].time_s - keyframes_[i - 1].time_s;
    const double right_s = keyframes_[i + 1].time_s - keyframes_[i].time_s;
    for (int axis = 0; axis < 3; ++axis) {
      const double left = (keyframes_[i].position_m[axis] - keyframes_[i - 1].position_m[axis]) / left_s;
      const double right = (keyframes_[i + 1].position_m[axis] - keyframes_[i].position_m[axis]) / right_s;
      velocities_[i][axis] = monotone_slope(left, right, left_s, right_s);
    }
  }
}

Keyframe Trajectory::at(double time_s) const noexcept {
  Keyframe pose = keyframes_.front();
  if (time_s >= end_s()) pose = keyframes_.back();
  if (!(time_s > start_s()) || time_s >= end_s()) {
    pose.time_s = time_s;
    return pose;
  }
  const auto next = std::upper_bound(keyframes_.begin(), keyframes_.end(), time_s,
                                     [](double t, const Keyframe& k) { return t < k.time_s; });
  const std::size_t i = static_cast<std::size_t>(next - keyframes_.begin()) - 1;
  const Keyframe &a = keyframes_[i], &b = keyframes_[i + 1];
  const double span_s = b.time_s - a.time_s, u = (time_s - a.time_s) / span_s;
  // Cubic Hermite basis.
  const double h00 = (1.0 + 2.0 * u) * (1.0 - u) * (1.0 - u), h10 = u * (1.0 - u) * (1.0 - u);
  const double h01 = u * u * (3.0 - 2.0 * u), h11 = u * u * (u - 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    pose.position_m[axis] = h00 * a.position_m[axis] + h10 * span_s * velocities_[i][axis] + h01 * b.position_m[axis] +
                            h11 * span_s * velocities_[i + 1][axis];
  }
  pose.rotation_wxyz = slerp(a.rotation_wxyz, b.rotation_wxyz, u);
  pose.time_s = time_s;
  return pose;
}

std::vector<Keyframe> read_trajectory_csv(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw DeviceError("trajectory " + file.string() + ": is a folder; give a CSV file t,x,y,z[,qw,qx,qy,qz]");
  }
  std::ifstream in(file);
  if (!in) throw DeviceError("trajectory " + file.string() + ": cannot be opened; check the name and the permission");
  return read_trajectory_csv(in, file.string());
}

std::vector<Keyframe> read_trajectory_csv(std::istream& in, const std::string& name) {
  std::vector<Keyframe> rows;
  std::size_t width = 0;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string where = "trajectory " + name + ", line " + std::to_string(number) + ": ";
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#') continue;
    if (rows.empty() && width == 0 && names_columns(text)) {
      width = columns(text).size();
      continue;
    }
    const auto fields = columns(text);
    if (fields.size() != 4 && fields.size() != 8) {
      throw DeviceError(where + std::to_string(fields.size()) + " columns; expected t,x,y,z or t,x,y,z,qw,qx,qy,qz");
    }
    if (width != 0 && fields.size() != width) {
      throw DeviceError(where + std::to_string(fields.size()) + " columns, but the lines before have " +
                        std::to_string(width));
    }
    width = fields.size();
    std::array<double, 8> v{0, 0, 0, 0, 1, 0, 0, 0};
    for (std::size_t c = 0; c < fields.size(); ++c) {
      if (!parse_number(fields[c], v[c])) {
        throw DeviceError(where + "column " + std::to_string(c + 1) + " is '" + std::string(fields[c].substr(0, 40)) +
                          "'; expected a finite number (s and m, decimal point)");
      }
    }
    if (!rows.empty() && !(v[0] > rows.back().time_s)) {
      throw DeviceError(where + "time " + std::string(trimmed(fields[0])) + " s is not later than the line before");
    }
    const double norm = std::sqrt(v[4] * v[4] + v[5] * v[5] + v[6] * v[6] + v[7] * v[7]);
    if (!(std::abs(norm - 1.0) <= 0.01)) {
      throw DeviceError(where + "rotation has length " + std::to_string(norm) +
                        "; expected a unit quaternion, w first");
    }
    if (rows.size() == kMaxRows) throw DeviceError(where + "more than " + std::to_string(kMaxRows) + " rows");
    rows.push_back({v[0], {v[1], v[2], v[3]}, {v[4], v[5], v[6], v[7]}});
  }
  if (in.bad()) throw DeviceError("trajectory " + name + ": could not be read to its end");
  if (rows.empty()) {
    throw DeviceError("trajectory " + name + ": holds no rows; expected t,x,y,z[,qw,qx,qy,qz] in s and m");
  }
  return rows;
}

}  // namespace vallecula::device

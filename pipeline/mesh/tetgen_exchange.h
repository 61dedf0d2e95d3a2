// What passes between the program and its TetGen helper: two small binary files in memory, same machine,
// same build.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace vallecula::pipeline {

/// A closed surface and the points wanted inside it.
struct TetgenInput {
  std::string switches;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<double, 3>> inner_points;
};

struct TetgenOutput {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 4>> tets;
};

/// Exit codes of the helper; a signal instead of a code means that TetGen itself died.
enum HelperExit : int {
  kHelperDone = 0,
  kHelperUsage = 2,
  kHelperUnreadable = 3,
  kHelperIntersects = 4,
  kHelperEmpty = 5,
  kHelperFailed = 6
};

namespace exchange {

template <class T>
void put(std::ostream& out, const std::vector<T>& values) {
  const auto n = static_cast<std::uint64_t>(values.size());
  out.write(reinterpret_cast<const char*>(&n), sizeof n);
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(n * sizeof(T)));
}

template <class T>
bool take(std::istream& in, std::vector<T>& values) {
  constexpr std::uint64_t kMost = 50'000'000;
  std::uint64_t n = 0;
  if (!in.read(reinterpret_cast<char*>(&n), sizeof n) || n > kMost) return false;
  values.resize(n);
  return static_cast<bool>(
      in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(n * sizeof(T))));
}

inline bool write(const TetgenInput& input, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  put(out, std::vector<char>(input.switches.begin(), input.switches.end()));
  put(out, input.points);
  put(out, input.triangles);
  put(out, input.inner_points);
  out.close();
  return static_cast<bool>(out);
}

inline bool read(const std::string& file, TetgenInput& input) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> switches;
  if (!take(in, switches) || !take(in, input.points) || !take(in, input.triangles) || !take(in, input.inner_points))
    return false;
  input.switches.assign(switches.begin(), switches.end());
  return true;
}

inline bool write(const TetgenOutput& output, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  put(out, output.points);
  put(out, output.tets);
  out.close();
  return static_cast<bool>(out);
}

inline bool read(const std::string& file, TetgenOutput& output) {
  std::ifstream in(file, std::ios::binary);
  return take(in, output.points) && take(in, output.tets);
}

}  // namespace exchange
}  // namespace vallecula::pipeline

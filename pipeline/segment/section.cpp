#include "pipeline/segment/section.h"

namespace vallecula::pipeline {

std::array<Vector3, 2> across(const Vector3& normal) {
  Vector3 u = unit(cross({0.0, 0.0, 1.0}, normal));
  if (norm(u) < 0.5) u = {1.0, 0.0, 0.0};
  if (std::abs(normal[0]) < 0.9) u = unit(Vector3{1.0, 0.0, 0.0} - normal[0] * normal);
  return {u, cross(normal, u)};
}

Section section_of(const Volume<float>& field, const Vector3& at, const Vector3& normal, double step_mm,
                   double reach_mm) {
  Section out;
  out.normal = normal;
  const auto [u, v] = across(normal);
  const int n = static_cast<int>(std::ceil(reach_mm / step_mm));
  const int side = 2 * n + 1;
  std::vector<std::uint8_t> state(static_cast<std::size_t>(side) * side, 0);  // 1: visited
  const auto point = [&](int i, int j) { return at + ((i - n) * step_mm) * u + ((j - n) * step_mm) * v; };
  if (!(value_at(field, at) > 0.0)) return out;
  std::vector<std::array<int, 2>> piece{{n, n}};
  state[static_cast<std::size_t>(n) * side + n] = 1;
  Vector3 sum{};
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const auto [i, j] = piece[k];
    if (i == 0 || j == 0 || i == side - 1 || j == side - 1) return out;
    sum = sum + point(i, j);
    constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const auto& d : kSteps) {
      auto& s = state[static_cast<std::size_t>(j + d[1]) * side + i + d[0]];
      if (s != 0) continue;
      s = 1;
      if (value_at(field, point(i + d[0], j + d[1])) > 0.0) piece.push_back({i + d[0], j + d[1]});
    }
  }
  out.found = true;
  out.centre = (1.0 / static_cast<double>(piece.size())) * sum;
  out.area_mm2 = static_cast<double>(piece.size()) * step_mm * step_mm;
  return out;
}

std::vector<Vector3> outline_of(const Volume<float>& field, const Section& section, int corners, double reach_mm) {
  const auto [u, v] = across(section.normal);
  std::vector<Vector3> out;
  constexpr double kStep = 0.1;
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners;
    const auto direction = std::cos(angle) * u + std::sin(angle) * v;
    double r = 0.0;
    while (r < reach_mm && value_at(field, section.centre + (r + kStep) * direction) > 0.0) r += kStep;
    double low = r;
    double high = r + kStep;
    for (int i = 0; i < 12; ++i) {
      const double mid = 0.5 * (low + high);
      (value_at(field, section.centre + mid * direction) > 0.0 ? low : high) = mid;
    }
    out.push_back(section.centre + low * direction);
  }
  return out;
}

}  // namespace vallecula::pipeline

#include "pipeline/dicom/stack.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "pipeline/dicom/limits.h"

namespace vallecula::pipeline {
namespace {

std::string decimal(double value, const char* format = "%.3f") {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  std::string out = text;
  if (out.find('.') != std::string::npos) {
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
  }
  return out;
}

Vector3 normal_of(const Picture& p) {
  auto n = cross(p.row, p.column);
  const double l = norm(n);
  for (double& v : n) v /= l;
  return n;
}

int main_axis(const Vector3& v) {
  int axis = 0;
  for (int a = 1; a < 3; ++a) {
    if (std::abs(v[a]) > std::abs(v[axis])) axis = a;
  }
  return axis;
}

/// "between z = -12 and z = -5 mm"
std::string between(const Vector3& a, const Vector3& b, const Vector3& normal) {
  const int axis = main_axis(normal);
  const std::string letter(1, "xyz"[axis]);
  return "between " + letter + " = " + decimal(a[axis], "%.1f") + " and " + letter + " = " + decimal(b[axis], "%.1f") +
         " mm";
}

/// The slices on an even ladder: how many rungs each gap spans. Empty when no even ladder fits.
std::vector<int> ladder(const std::vector<double>& at, double usual) {
  std::vector<int> rungs(at.size(), 0);
  for (std::size_t k = 1; k < at.size(); ++k) {
    const double span = (at[k] - at[k - 1]) / usual;
    if (span > 1e6) return {};
    rungs[k] = rungs[k - 1] + std::max(1, static_cast<int>(std::lround(span)));
  }
  const double spacing = (at.back() - at.front()) / rungs.back();
  const double tolerance = std::min(kNearlyEvenMm, 0.25 * usual);
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (std::abs(at[k] - at.front() - spacing * rungs[k]) > tolerance) return {};
  }
  return rungs;
}

struct Gap {
  double widest = 0.0;
  std::size_t after = 0;
  double narrowest = 1e30;
};

Gap gap_of(const std::vector<double>& at) {
  Gap gap;
  for (std::size_t k = 1; k < at.size(); ++k) {
    const double d = at[k] - at[k - 1];
    if (d > gap.widest) {
      gap.widest = d;
      gap.after = k - 1;
    }
    gap.narrowest = std::min(gap.narrowest, d);
  }
  return gap;
}

double lower_quartile(const std::vector<double>& at) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < at.size(); ++k) gaps.push_back(at[k] - at[k - 1]);
  const auto quartile = gaps.begin() + static_cast<std::ptrdiff_t>((gaps.size() - 1) / 4);
  std::nth_element(gaps.begin(), quartile, gaps.end());
  return *quartile;
}

}  // namespace

bool StackPlan::interpolated() const {
  return sources.size() != places.size() ||
         std::any_of(sources.begin(), sources.end(), [](const auto& s) { return s.second != 0.0; });
}

std::string millimetres_text(double value) { return decimal(value) + " mm"; }
std::string degrees_text(double value) { return decimal(value, "%.1f") + " degrees"; }

double place_of(const Picture& picture, const Picture& first) { return dot(normal_of(first), picture.position); }

std::string orientation_words(const CtGeometry& g) {
  auto normal = cross(g.step[0], g.step[1]);
  const double l = norm(normal);
  if (!(l > 0.0)) return {};
  const int axis = main_axis(normal);
  const double off = std::acos(std::min(1.0, std::abs(normal[axis]) / l)) * 180.0 / 3.14159265358979324;
  const std::string words = axis == 2 ? "axial" : axis == 1 ? "coronal" : "sagittal";
  return off < 0.1 ? words : words + ", " + degrees_text(off) + " off";
}

StackPlan plan_stack(const std::vector<Picture>& pictures) {
  StackPlan plan;
  const Picture& first = pictures.front();
  const auto normal = normal_of(first);
  std::vector<std::size_t> order(pictures.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> along(pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) along[i] = dot(normal, pictures[i].position);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return along[a] < along[b]; });
  std::vector<double> at;  // along the normal, of each place
  for (const auto i : order) {
    if (at.empty() || along[i] - at.back() > kSamePlaceMm) {
      plan.places.emplace_back();
      at.push_back(along[i]);
    }
    plan.places.back().push_back(i);
  }
  const auto position = [&](std::size_t place) { return pictures[plan.places[place].front()].position; };
  auto& g = plan.geometry;
  g.size = {first.columns, first.rows, static_cast<int>(at.size())};
  g.origin = position(0);
  for (int a = 0; a < 3; ++a) {
    g.step[0][a] = first.row[a] * first.spacing[0];
    g.step[1][a] = first.column[a] * first.spacing[1];
    g.step[2][a] = normal[a];
  }
  for (std::size_t k = 0; k < at.size(); ++k) plan.sources.emplace_back(static_cast<int>(k), 0.0);
  if (at.size() < 2) {
    plan.fault = "is a single slice; name the folder that holds the whole series";
    return plan;
  }

  const double extent = at.back() - at.front();
  Vector3 along_stack{};  // for each mm along the normal
  for (int a = 0; a < 3; ++a) along_stack[a] = (position(at.size() - 1)[a] - position(0)[a]) / extent;
  double sideways = 0.0;
  for (std::size_t place = 0; place < at.size(); ++place) {
    for (const auto i : plan.places[place]) {
      Vector3 off{};
      for (int a = 0; a < 3; ++a)
        off[a] = pictures[i].position[a] - position(0)[a] - along_stack[a] * (along[i] - at.front());
      sideways = std::max(sideways, norm(off));
    }
  }
  if (sideways > kNearlyEvenMm) {
    plan.fault = "its slices are shifted sideways against each other by up to " + millimetres_text(sideways) +
                 "; export the series as one reconstruction";
    return plan;
  }

  const Gap gap = gap_of(at);
  const double usual = lower_quartile(at);
  const auto where = [&](std::size_t after) { return between(position(after), position(after + 1), normal); };
  const bool hole = gap.widest > 1.5 * usual;
  if (hole && gap.widest > kCoarsestSliceMm) {
    plan.fault = "slices are missing: a gap of " + millimetres_text(gap.widest) + " " + where(gap.after) +
                 ", where the others lie " + millimetres_text(usual) + " apart and at most " +
                 millimetres_text(kCoarsestSliceMm) + " can be bridged; export the whole series again";
    return plan;
  }
  const auto rungs = ladder(at, usual);
  const bool even = !rungs.empty();
  const double spacing = even ? extent / rungs.back() : usual;
  const double steps = even ? rungs.back() : std::floor(extent / spacing + kExactMm);
  if (static_cast<double>(first.columns) * first.rows * (steps + 1) > static_cast<double>(kMostVoxels)) {
    plan.fault = "is larger than any CT this program reads; export the head and neck alone";
    return plan;
  }
  for (int a = 0; a < 3; ++a) g.step[2][a] = along_stack[a] * spacing;
  g.size[2] = static_cast<int>(steps) + 1;
  plan.sources.clear();
  double uneven = 0.0;
  std::size_t place = 0;
  // Each slice of the volume from the two that lie about its place, where they truly lie.
  for (int k = 0; k < g.size[2]; ++k) {
    const double wanted = at.front() + spacing * k;
    while (place + 1 < at.size() && at[place + 1] <= wanted + kExactMm) ++place;
    const double off = wanted - at[place];
    const bool between_two = std::abs(off) > kExactMm && place + 1 < at.size();
    plan.sources.emplace_back(static_cast<int>(place), between_two ? off / (at[place + 1] - at[place]) : 0.0);
  }
  if (even) {
    for (std::size_t i = 0; i < at.size(); ++i)
      uneven = std::max(uneven, std::abs(at[i] - at.front() - spacing * rungs[i]));
  }
  if (!even) {
    plan.notes.push_back("the slices lie unevenly (" + decimal(gap.narrowest) + " to " + millimetres_text(gap.widest) +
                         " apart) and were interpolated onto an even spacing of " + millimetres_text(spacing));
  } else if (g.size[2] > static_cast<int>(at.size())) {
    plan.notes.push_back(std::to_string(g.size[2] - static_cast<int>(at.size())) +
                         " slices are missing and were interpolated; the widest gap is " +
                         millimetres_text(gap.widest) + ", " + where(gap.after));
  }
  if (uneven > kExactMm) {
    plan.notes.push_back("slice positions deviate by up to " + millimetres_text(uneven) +
                         " from even spacing; the slices were resampled onto it");
  }
  if (sideways > kExactMm) {
    plan.notes.push_back("the slices are shifted sideways against each other by up to " + millimetres_text(sideways) +
                         " and were left so");
  }
  return plan;
}

}  // namespace vallecula::pipeline

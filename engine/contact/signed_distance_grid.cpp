#include "engine/contact/signed_distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "engine/mesh/triangle_bvh.h"

namespace vallecula::engine {

namespace {

constexpr int kFineParts = 3;  // a refined cell's edge
constexpr int kFineSamples = kFineParts + 1;
constexpr int kFinePerCell = kFineSamples * kFineSamples * kFineSamples;
constexpr std::size_t kMostFineCells = 400'000;  // a kilobyte each; the blades have up to some 60,000
constexpr double kNearSurface = 0.0003;          // m; cells beyond are not refined

/// Calls work(first, workers) on every worker: each takes every workers-th piece.
template <class Work>
void share_out(Work work) {
  const int workers = std::clamp<int>(static_cast<int>(std::thread::hardware_concurrency()), 1, 4);
  std::vector<std::thread> threads;
  for (int w = 1; w < workers; ++w) threads.emplace_back(work, w, workers);
  work(0, workers);
  for (auto& t : threads) t.join();
}

/// Distance and gradient at p; distance infinity where no triangle is within `band`. `hit`: that of a point beside it,
/// or none, and p's own afterwards.
F4 exact_value(const TriangleBvh& bvh, const Vec3& p, double band, TriangleBvh::Hit& hit) {
  const double known = hit.triangle >= 0 ? (p - hit.point).norm() : std::numeric_limits<double>::infinity();
  const double d = bvh.signed_distance(p, band, &hit, known);
  if (hit.triangle < 0) return F4{0, 0, 0, std::numeric_limits<float>::infinity()};
  // On the surface itself the way to it has no direction: the face's normal is it.
  F4 value = from_vec3(std::abs(d) > 1e-9 ? Vec3((p - hit.point) / d) : bvh.triangle_normal(hit.triangle));
  value[3] = static_cast<float>(d);
  return value;
}

F4 trilinear(const Float4* v, std::size_t dy, std::size_t dz, const float f[3]) {
  const F4 fx = splat(f[0]), fy = splat(f[1]), fz = splat(f[2]);
  const F4 x00 = v[0].v + fx * (v[1].v - v[0].v), x10 = v[dy].v + fx * (v[dy + 1].v - v[dy].v);
  const F4 x01 = v[dz].v + fx * (v[dz + 1].v - v[dz].v), x11 = v[dz + dy].v + fx * (v[dz + dy + 1].v - v[dz + dy].v);
  const F4 y0 = x00 + fy * (x10 - x00), y1 = x01 + fy * (x11 - x01);
  return y0 + fz * (y1 - y0);
}

}  // namespace

SignedDistanceGrid::SignedDistanceGrid(const TriangleMesh& mesh, const Vec3& low, const Vec3& high, double spacing,
                                       double band, const std::vector<std::uint8_t>& triangle_class, double tolerance)
    : low_(low), spacing_(spacing), inverse_spacing_(1.0 / spacing), band_(band) {
  constexpr double kMostCells = 2e7;  // 320 MB: a larger grid means wrong units, not a finer tool
  double cells = 1;
  for (int a = 0; a < 3; ++a) {
    const double n = std::ceil((high[a] - low[a]) / spacing) + 1;
    if (!(n >= 2) || !(n < 1e5)) throw std::invalid_argument("distance field: the box is empty or too large");
    size_[a] = static_cast<int>(n);
    cells *= n;
  }
  if (cells > kMostCells) throw std::invalid_argument("distance field: more than 20 million samples; check the units");
  const TriangleBvh bvh(mesh);
  constexpr float kUnknown = std::numeric_limits<float>::infinity();
  values_.assign(static_cast<std::size_t>(cells), Float4{F4{0, 0, 0, kUnknown}});
  if (!triangle_class.empty()) classes_.assign(values_.size(), kNoClass);

  // Only samples within the band of some triangle are worth an exact query: mark them by the triangles' boxes.
  for (const auto& tri : mesh.triangles) {
    Vec3 box_low = mesh.points[tri[0]], box_high = box_low;
    for (int v : tri) {
      box_low = box_low.cwiseMin(mesh.points[v]);
      box_high = box_high.cwiseMax(mesh.points[v]);
    }
    int from[3], to[3];
    for (int a = 0; a < 3; ++a) {
      from[a] = std::max(0, static_cast<int>(std::floor((box_low[a] - band - low_[a]) * inverse_spacing_)));
      to[a] = std::min(size_[a] - 1, static_cast<int>(std::ceil((box_high[a] + band - low_[a]) * inverse_spacing_)));
    }
    for (int k = from[2]; k <= to[2]; ++k)
      for (int j = from[1]; j <= to[1]; ++j)
        for (int i = from[0]; i <= to[0]; ++i) values_[index(i, j, k)].v[3] = 0.0f;
  }
  const auto fill_slices = [&](int first, int step) {
    for (int k = first; k < size_[2]; k += step)
      for (int j = 0; j < size_[1]; ++j) {
        TriangleBvh::Hit hit;
        for (int i = 0; i < size_[0]; ++i) {
          F4& value = values_[index(i, j, k)].v;
          if (value[3] == kUnknown) continue;
          value = exact_value(bvh, low_ + spacing_ * Vec3(i, j, k), band, hit);
          if (hit.triangle < 0) continue;
          if (!classes_.empty()) classes_[index(i, j, k)] = triangle_class[hit.triangle];
        }
      }
  };
  share_out(fill_slices);

  // Beyond the band only the side matters; it is that of the next known sample along x (the band is wider than a cell,
  // so a line cannot change sides without passing known samples). Lines without any are filled from their neighbours.
  const auto spread = [&](int axis) {
    int n[3] = {size_[0], size_[1], size_[2]};
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    int at[3];
    for (at[u] = 0; at[u] < n[u]; ++at[u])
      for (at[v] = 0; at[v] < n[v]; ++at[v])
        for (int direction = 0; direction < 2; ++direction) {
          float known = kUnknown;
          for (int s = 0; s < n[axis]; ++s) {
            at[axis] = direction == 0 ? s : n[axis] - 1 - s;
            F4& node = values_[index(at[0], at[1], at[2])].v;
            const float value = node[3];
            if (value != kUnknown) {
              known = value;
            } else if (known != kUnknown) {
              node[3] = static_cast<float>(known < 0 ? -band : band);
            }
          }
        }
  };
  for (int axis = 0; axis < 3; ++axis) spread(axis);
  for (Float4& node : values_)
    if (node.v[3] == kUnknown) node.v[3] = static_cast<float>(band);
  if (std::isfinite(tolerance)) refine(bvh, tolerance);
}

bool SignedDistanceGrid::bent(std::size_t cell, double tolerance) const {
  constexpr double kRounding = 1e-6;  // m; of a sample, as a float
  const double far = kNearSurface + std::sqrt(0.75) * spacing_;
  // No corner is nearer to the surface than one is by more than the cell's diagonal.
  if (std::abs(double(values_[cell].v[3])) > far + std::sqrt(3.0) * spacing_ + kRounding) return false;
  const std::size_t dy = size_[0], dz = static_cast<std::size_t>(size_[0]) * size_[1];
  F4 corners[8];
  double nearest = band_;
  for (int c = 0; c < 8; ++c) {
    corners[c] = values_[cell + (c & 1) + (c >> 1 & 1) * dy + (c >> 2) * dz].v;
    nearest = std::min(nearest, std::abs(double(corners[c][3])));
  }
  if (nearest > far) return false;
  // At the middles of the cell, its faces and its edges: what is interpolated there, and what each corner's own
  // distance and gradient make of it. All agree where the field is flat.
  for (int middle = 0; middle < 27; ++middle) {
    const Vec3 at = 0.5 * Vec3(middle % 3, middle / 3 % 3, middle / 9);
    double sum = 0.0, low = band_, high = -band_;
    int count = 0;
    for (int c = 0; c < 8; ++c) {
      const Vec3 way = at - Vec3(c & 1, c >> 1 & 1, c >> 2);
      if (way.cwiseAbs().maxCoeff() > 0.5) continue;  // not of this face or edge
      const double guess = corners[c][3] + spacing_ * to_vec3(corners[c]).dot(way);
      low = std::min(low, guess);
      high = std::max(high, guess);
      sum += corners[c][3];
      ++count;
    }
    if (std::max(high, sum / count) - std::min(low, sum / count) > tolerance) return true;
  }
  return false;
}

void SignedDistanceGrid::refine(const TriangleBvh& bvh, double tolerance) {
  refined_.assign(values_.size(), -1);
  std::vector<std::array<int, 3>> cells;
  for (int k = 0; k + 1 < size_[2]; ++k)
    for (int j = 0; j + 1 < size_[1]; ++j)
      for (int i = 0; i + 1 < size_[0]; ++i)
        if (bent(index(i, j, k), tolerance)) {
          refined_[index(i, j, k)] = static_cast<std::int32_t>(cells.size());
          cells.push_back({i, j, k});
        }
  if (cells.size() > kMostFineCells)
    throw std::invalid_argument("the tool's surface is too rough: " + std::to_string(cells.size()) +
                                " cells of its distance field are bent (at most " + std::to_string(kMostFineCells) +
                                " fit); smooth or simplify it");
  fine_values_.resize(cells.size() * kFinePerCell);
  share_out([&](int first, int step) {
    for (std::size_t c = first; c < cells.size(); c += step) {
      TriangleBvh::Hit hit;
      for (int n = 0; n < kFinePerCell; ++n) {
        const int at[3] = {n % kFineSamples, n / kFineSamples % kFineSamples, n / (kFineSamples * kFineSamples)};
        // On a face shared with a cell that is not refined the sample is what that cell interpolates there, so that the
        // field has no step.
        int from[3], to[3];
        for (int a = 0; a < 3; ++a) {
          from[a] = std::max(0, cells[c][a] - (at[a] == 0 ? 1 : 0));
          to[a] = std::min(size_[a] - 2, cells[c][a] + (at[a] == kFineParts ? 1 : 0));
        }
        bool all_refined = true;
        for (int k = from[2]; k <= to[2]; ++k)
          for (int j = from[1]; j <= to[1]; ++j)
            for (int i = from[0]; i <= to[0]; ++i) all_refined = all_refined && refined_[index(i, j, k)] >= 0;
        F4& value = fine_values_[c * kFinePerCell + n].v;
        const float f[3] = {float(at[0]) / kFineParts, float(at[1]) / kFineParts, float(at[2]) / kFineParts};
        const std::size_t cell = index(cells[c][0], cells[c][1], cells[c][2]);
        value = trilinear(values_.data() + cell, size_[0], static_cast<std::size_t>(size_[0]) * size_[1], f);
        if (!all_refined) continue;
        Vec3 p = low_;
        for (int a = 0; a < 3; ++a) p[a] += spacing_ / kFineParts * (kFineParts * cells[c][a] + at[a]);
        const F4 exact = exact_value(bvh, p, band_, hit);
        if (hit.triangle >= 0) value = exact;
      }
    }
  });
}

bool SignedDistanceGrid::locate(const Vec3& p, int cell[3], float frac[3]) const noexcept {
  for (int a = 0; a < 3; ++a) {
    const double s = (p[a] - low_[a]) * inverse_spacing_;
    if (!(s >= 0) || !(s < size_[a] - 1)) return false;
    cell[a] = static_cast<int>(s);
    frac[a] = static_cast<float>(s - cell[a]);
  }
  return true;
}

F4 SignedDistanceGrid::interpolate(const int c[3], const float f[3]) const noexcept {
  const std::size_t cell = index(c[0], c[1], c[2]);
  const std::int32_t refined = refined_.empty() ? -1 : refined_[cell];
  if (refined < 0) return trilinear(values_.data() + cell, size_[0], static_cast<std::size_t>(size_[0]) * size_[1], f);
  std::size_t at = static_cast<std::size_t>(refined) * kFinePerCell;
  float g[3];
  for (int a = 0, stride = 1; a < 3; ++a, stride *= kFineSamples) {
    const float s = f[a] * kFineParts;
    const int part = std::min(kFineParts - 1, static_cast<int>(s));
    g[a] = s - static_cast<float>(part);
    at += part * stride;
  }
  return trilinear(fine_values_.data() + at, kFineSamples, kFineSamples * kFineSamples, g);
}

SignedDistanceGrid::Sample SignedDistanceGrid::sample(const Vec3& p) const noexcept {
  int c[3];
  float f[3];
  if (!locate(p, c, f)) return {band_, Vec3::Zero()};
  const F4 v = interpolate(c, f);
  const Vec3 gradient = to_vec3(v);
  const double length = gradient.norm();
  return {v[3], length > 1e-3 ? Vec3(gradient / length) : Vec3::Zero()};
}

double SignedDistanceGrid::distance(const Vec3& p) const noexcept {
  int c[3];
  float f[3];
  return locate(p, c, f) ? interpolate(c, f)[3] : band_;
}

std::uint8_t SignedDistanceGrid::class_at(const Vec3& p) const noexcept {
  int c[3];
  float f[3];
  if (classes_.empty() || !locate(p, c, f)) return kNoClass;
  return classes_[index(c[0] + (f[0] > 0.5), c[1] + (f[1] > 0.5), c[2] + (f[2] > 0.5))];
}

bool SignedDistanceGrid::covers(const Vec3& p) const noexcept {
  int c[3];
  float f[3];
  return locate(p, c, f);
}

std::size_t SignedDistanceGrid::bytes() const noexcept {
  return (values_.size() + fine_values_.size()) * sizeof(Float4) + refined_.size() * sizeof(std::int32_t) +
         classes_.size();
}

}  // namespace vallecula::engine

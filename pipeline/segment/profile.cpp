#include "pipeline/segment/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/manikin/manikin.h"
#include "pipeline/parallel.h"
#include "pipeline/segment/upright.h"

namespace vallecula::pipeline {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr std::array<double, 5> kAside{-6.0, -3.0, 0.0, 3.0, 6.0};  ///< mm from the plane of symmetry, at term size

struct Pixel {
  double y = 0.0;  ///< mm from the middle, at term size
  double z = 0.0;
  double grey = 0.0;
};

/// The design's head above the larynx, and the air about it.
std::vector<Pixel> design_profile() {
  constexpr double kPixel = 4.0;
  constexpr double kMiddleY = 52.0;
  constexpr double kMiddleZ = 14.0;
  const Manikin infant(3.2, 0);
  std::vector<Pixel> out;
  for (double z = -62.0; z <= 86.0; z += kPixel) {
    for (double y = -18.0; y <= 122.0; y += kPixel) {
      double sum = 0.0;
      for (const double x : kAside) {
        for (const double dy : {-1.0, 1.0}) {
          for (const double dz : {-1.0, 1.0}) sum += grey_of(infant.hounsfield_at({x, y + dy, z + dz}));
        }
      }
      out.push_back({y - kMiddleY, z - kMiddleZ, sum / (4.0 * kAside.size())});
    }
  }
  return out;
}

/// The patient's plane of symmetry as a picture; below zero where nothing was scanned.
struct Picture {
  int side = 0;
  double pixel = 0.0;  ///< mm at term size; the middle pixel is the head's middle
  std::vector<float> grey;
  double at(double y, double z) const {
    const double u = y / pixel + 0.5 * (side - 1);
    const double v = z / pixel + 0.5 * (side - 1);
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    if (i < 0 || j < 0 || i + 1 >= side || j + 1 >= side) return 0.0;
    const float* g = grey.data() + static_cast<std::size_t>(j) * side + i;
    if (g[0] < 0.0F || g[1] < 0.0F || g[side] < 0.0F || g[side + 1] < 0.0F) return -1.0;
    const double fu = u - i;
    const double fv = v - j;
    return (1.0 - fv) * ((1.0 - fu) * g[0] + fu * g[1]) + fv * ((1.0 - fu) * g[side] + fu * g[side + 1]);
  }
};

Picture picture_of(const Hounsfield& hu, const Mask& body, const Transform& straight_to_scan, const Point& middle,
                   double scale) {
  Picture out;
  out.pixel = 2.0;
  out.side = 161;
  out.grey.assign(static_cast<std::size_t>(out.side) * out.side, 0.0F);
  const auto& g = hu.grid;
  parallel_for(out.side, [&](int j) {
    for (int i = 0; i < out.side; ++i) {
      double sum = 0.0;
      bool known = true;
      for (const double x : kAside) {
        const Point p{middle[0] + x * scale, middle[1] + (i - 0.5 * (out.side - 1)) * out.pixel * scale,
                      middle[2] + (j - 0.5 * (out.side - 1)) * out.pixel * scale};
        const auto c = g.nearest(moved(straight_to_scan, p));
        known = known && c[2] >= 0 && c[2] < g.size[2];
        if (!known || !g.contains(c[0], c[1], c[2])) continue;
        const auto v = g.index(c[0], c[1], c[2]);
        if (body.voxels[v] != 0) sum += grey_of(hu.voxels[v]);
      }
      out.grey[static_cast<std::size_t>(j) * out.side + i] = known ? static_cast<float>(sum / kAside.size()) : -1.0F;
    }
  });
  return out;
}

struct Fit {
  double nod = 0.0;  ///< degrees
  double y = 0.0;    ///< mm at term size
  double z = 0.0;
  double size = 1.0;
  double cost = std::numeric_limits<double>::infinity();
};

/// Mean square difference, none above 0.36: the neck's posture, a cap on the head or an open mouth count little.
double cost_of(const std::vector<Pixel>& design, const Picture& picture, const Fit& fit) {
  const double c = std::cos(fit.nod * kDegree) * fit.size;
  const double s = std::sin(fit.nod * kDegree) * fit.size;
  double sum = 0.0;
  double known = 0.0;
  for (const auto& px : design) {
    const double v = picture.at(c * px.y - s * px.z + fit.y, s * px.y + c * px.z + fit.z);
    if (v < 0.0) continue;
    sum += std::min((v - px.grey) * (v - px.grey), 0.36);
    known += 1.0;
  }
  return known > 0.55 * static_cast<double>(design.size()) ? sum / known : 1.0;
}

Fit refined(const std::vector<Pixel>& design, const Picture& picture, Fit fit) {
  double degrees = 4.0;
  double mm = 3.0;
  double size = 0.05;
  while (degrees > 0.4) {
    bool better = false;
    for (int a = 0; a < 4; ++a) {
      for (const double sign : {1.0, -1.0}) {
        auto next = fit;
        if (a == 0) next.nod += sign * degrees;
        if (a == 1) next.y += sign * mm;
        if (a == 2) next.z += sign * mm;
        if (a == 3) next.size = std::clamp(next.size + sign * size, 0.8, 1.25);
        next.cost = cost_of(design, picture, next);
        if (next.cost >= fit.cost) continue;
        fit = next;
        better = true;
      }
    }
    if (better) continue;
    degrees *= 0.5;
    mm *= 0.5;
    size *= 0.5;
  }
  return fit;
}

}  // namespace

Nod nod_of(const Hounsfield& hu, const Mask& body, const Transform& straight_to_scan, const Point& middle,
           const Frame& frame) {
  static const auto design = design_profile();
  const auto picture = picture_of(hu, body, straight_to_scan, middle, frame.scale);
  std::vector<Fit> fits;
  for (double nod = -50.0; nod <= 50.0; nod += 5.0) fits.push_back({nod});
  parallel_for(static_cast<int>(fits.size()), [&](int k) {
    Fit best = fits[k];
    for (const double size : {0.88, 1.0, 1.12}) {
      for (double z = -35.0; z <= 35.0; z += 5.0) {
        for (double y = -35.0; y <= 35.0; y += 5.0) {
          Fit fit{fits[k].nod, y, z, size};
          fit.cost = cost_of(design, picture, fit);
          if (fit.cost < best.cost) best = fit;
        }
      }
    }
    fits[k] = best;
  });
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.cost < b.cost; });
  Fit best;
  for (int k = 0; k < 3; ++k) {
    const auto fit = refined(design, picture, fits[k]);
    if (fit.cost < best.cost) best = fit;
  }
  return {best.nod, best.cost};
}

}  // namespace vallecula::pipeline

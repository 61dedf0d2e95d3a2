#include "pipeline/manikin/field.h"

#include <limits>

namespace vallecula::pipeline::manikin {

double ellipsoid(const Vec& p, const Vec& c, const Vec& r) {
  const Vec q{(p.x - c.x) / r.x, (p.y - c.y) / r.y, (p.z - c.z) / r.z};
  const double k0 = norm(q);
  const double k1 = norm({q.x / r.x, q.y / r.y, q.z / r.z});
  if (k1 < 1e-9) return -std::min({r.x, r.y, r.z});
  return std::max(k0 * (k0 - 1.0) / k1, -std::min({r.x, r.y, r.z}));
}

double tilted_ellipsoid(const Vec& p, const Vec& c, const Vec& r, double tilt) {
  const double cs = std::cos(tilt);
  const double sn = std::sin(tilt);
  const double y = p.y - c.y;
  const double z = p.z - c.z;
  return ellipsoid({p.x - c.x, cs * y - sn * z, sn * y + cs * z}, {0.0, 0.0, 0.0}, r);
}

namespace {

/// Nearest point of a triangle as weights of its corners (Ericson, Real-Time Collision Detection, 5.1.5).
Vec nearest_weights(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const Vec ab = b - a;
  const Vec ac = c - a;
  const Vec ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Vec bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  const Vec cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

template <class P, class Combine>
std::vector<P> through_curve(const std::vector<P>& points, bool closed, int per_span, Combine&& combine) {
  const int n = static_cast<int>(points.size());
  const int spans = closed ? n : n - 1;
  const auto at = [&](int i) { return closed ? points[((i % n) + n) % n] : points[std::clamp(i, 0, n - 1)]; };
  std::vector<P> result;
  for (int s = 0; s < spans; ++s)
    for (int k = 0; k < per_span; ++k)
      result.push_back(combine(at(s - 1), at(s), at(s + 1), at(s + 2), static_cast<double>(k) / per_span));
  if (!closed) result.push_back(points.back());
  return result;
}

/// Catmull-Rom with centripetal knots (Barry and Goldman's pyramid): no loops or overshoot at uneven spacing.
Vec catmull_rom(const Vec& p0, const Vec& p1, const Vec& p2, const Vec& p3, double t) {
  const auto knot = [](const Vec& a, const Vec& b) { return std::max(std::sqrt(norm(b - a)), 1e-4); };
  const double t1 = knot(p0, p1);
  const double t2 = t1 + knot(p1, p2);
  const double t3 = t2 + knot(p2, p3);
  const double x = t1 + t * (t2 - t1);
  const Vec a1 = ((t1 - x) / t1) * p0 + (x / t1) * p1;
  const Vec a2 = ((t2 - x) / (t2 - t1)) * p1 + ((x - t1) / (t2 - t1)) * p2;
  const Vec a3 = ((t3 - x) / (t3 - t2)) * p2 + ((x - t2) / (t3 - t2)) * p3;
  const Vec b1 = ((t2 - x) / t2) * a1 + (x / t2) * a2;
  const Vec b2 = ((t3 - x) / (t3 - t1)) * a2 + ((x - t1) / (t3 - t1)) * a3;
  return ((t2 - x) / (t2 - t1)) * b1 + ((x - t1) / (t2 - t1)) * b2;
}

double segment_distance(const Flat& p, const Flat& a, const Flat& b, double* along = nullptr) {
  const double du = b.u - a.u;
  const double dv = b.v - a.v;
  const double length2 = du * du + dv * dv;
  const double t = length2 > 0.0 ? std::clamp(((p.u - a.u) * du + (p.v - a.v) * dv) / length2, 0.0, 1.0) : 0.0;
  if (along != nullptr) *along = t;
  const double eu = p.u - a.u - t * du;
  const double ev = p.v - a.v - t * dv;
  return std::sqrt(eu * eu + ev * ev);
}

void bounds(const std::vector<Flat>& points, double margin, Flat& low, Flat& high) {
  low = high = points.front();
  for (const auto& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  low = {low.u - margin, low.v - margin};
  high = {high.u + margin, high.v + margin};
}

}  // namespace

double triangle_distance(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const Vec w = nearest_weights(p, a, b, c);
  return norm(p - (w.x * a + w.y * b + w.z * c));
}

std::vector<Flat> curve(const std::vector<Flat>& through, bool closed, int per_span) {
  return through_curve(through, closed, per_span,
                       [](const Flat& a, const Flat& b, const Flat& c, const Flat& d, double t) {
                         const Vec r = catmull_rom({a.u, a.v, 0}, {b.u, b.v, 0}, {c.u, c.v, 0}, {d.u, d.v, 0}, t);
                         return Flat{r.x, r.y};
                       });
}

std::vector<Vec> curve(const std::vector<Vec>& through, int per_span) {
  return through_curve(through, false, per_span, catmull_rom);
}

double Sampled::operator()(double u, double v) const {
  const Flat top = high();
  const double cu = std::clamp(u, low_.u, top.u);
  const double cv = std::clamp(v, low_.v, top.v);
  const double gu = (cu - low_.u) / cell_;
  const double gv = (cv - low_.v) / cell_;
  const int i = std::min(static_cast<int>(gu), columns_ - 2);
  const int j = std::min(static_cast<int>(gv), rows_ - 2);
  const double fu = gu - i;
  const double fv = gv - j;
  const float* row = &values_[static_cast<std::size_t>(j) * columns_ + i];
  const double value =
      (1 - fv) * ((1 - fu) * row[0] + fu * row[1]) + fv * ((1 - fu) * row[columns_] + fu * row[columns_ + 1]);
  if (!distance_ || (cu == u && cv == v)) return value;
  return std::max(value, 0.0) + std::hypot(u - cu, v - cv);
}

Sampled outline(const std::vector<Flat>& through, double margin, double cell) {
  const auto points = curve(through, true);
  Flat low;
  Flat high;
  bounds(points, margin, low, high);
  struct Edge {
    double u, v, du, dv, inverse;  // start, extent, one over the squared length
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
    const double du = points[i].u - points[j].u;
    const double dv = points[i].v - points[j].v;
    edges.push_back({points[j].u, points[j].v, du, dv, 1.0 / std::max(du * du + dv * dv, 1e-12)});
  }
  return Sampled(low, high, cell, true, [&](const Flat& p) {
    double best = std::numeric_limits<double>::max();
    bool inside = false;
    for (const auto& e : edges) {
      const double u = p.u - e.u;
      const double v = p.v - e.v;
      const double t = std::min(std::max((u * e.du + v * e.dv) * e.inverse, 0.0), 1.0);
      const double eu = u - t * e.du;
      const double ev = v - t * e.dv;
      best = std::min(best, eu * eu + ev * ev);
      if ((e.v > p.v) != (e.v + e.dv > p.v) && u < e.du * v / e.dv) inside = !inside;
    }
    return inside ? -std::sqrt(best) : std::sqrt(best);
  });
}

Sampled stroke(const std::vector<Flat>& through, const std::vector<double>& radius, double margin, double cell) {
  constexpr int kPerSpan = 8;
  const auto points = curve(through, false, kPerSpan);
  const auto radius_at = [&](std::size_t i) {
    const std::size_t span = std::min(i / kPerSpan, radius.size() - 2);
    const double t = (static_cast<double>(i) - static_cast<double>(span * kPerSpan)) / kPerSpan;
    return (1 - t) * radius[span] + t * radius[span + 1];
  };
  Flat low;
  Flat high;
  bounds(points, margin, low, high);
  return Sampled(low, high, cell, true, [&](const Flat& p) {
    double best = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      double t = 0.0;
      const double d = segment_distance(p, points[i], points[i + 1], &t);
      best = std::min(best, d - ((1 - t) * radius_at(i) + t * radius_at(i + 1)));
    }
    return best;
  });
}

Sampled widths(const std::vector<WidthPoint>& points, const Sampled& region) {
  // Thin plate spline (Duchon): sum of c_i r_i^2 log r_i plus a plane, through every point.
  const std::size_t n = points.size();
  const std::size_t size = n + 3;
  const auto kernel = [](const Flat& a, const Flat& b) {
    const double r2 = (a.u - b.u) * (a.u - b.u) + (a.v - b.v) * (a.v - b.v);
    return r2 > 0.0 ? 0.5 * r2 * std::log(r2) : 0.0;
  };
  std::vector<std::vector<double>> m(size, std::vector<double>(size + 1, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = kernel(points[i].at, points[j].at);
    m[i][i] += 0.5;  // a little smoothing
    const double plane[3] = {1.0, points[i].at.u, points[i].at.v};
    for (std::size_t k = 0; k < 3; ++k) m[i][n + k] = m[n + k][i] = plane[k];
    m[i][size] = points[i].width;
  }
  for (std::size_t c = 0; c < size; ++c) {  // Gauss and Jordan with row exchange; the systems have some twenty rows
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < size; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    std::swap(m[c], m[pivot]);
    for (std::size_t r = 0; r < size; ++r) {
      if (r == c) continue;
      const double f = m[r][c] / m[c][c];
      for (std::size_t k = c; k <= size; ++k) m[r][k] -= f * m[c][k];
    }
  }
  double least = points.front().width;
  double most = least;
  for (const auto& p : points) {
    least = std::min(least, p.width);
    most = std::max(most, p.width);
  }
  return Sampled(region.low(), region.high(), 0.8, false, [&](const Flat& p) {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += m[i][size] / m[i][i] * kernel(p, points[i].at);
    const double plane[3] = {1.0, p.u, p.v};
    for (std::size_t k = 0; k < 3; ++k) sum += m[n + k][size] / m[n + k][n + k] * plane[k];
    return std::clamp(sum, 0.9 * least, 1.05 * most);
  });
}

Tube::Tube(const std::vector<Vec>& through, const std::vector<double>& radius, bool mirrored, int per_span)
    : points_(curve(through, per_span)), mirrored_(mirrored) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t span = std::min(i / per_span, radius.size() - 2);
    const double t = (static_cast<double>(i) - static_cast<double>(span * per_span)) / per_span;
    radius_.push_back((1 - t) * radius[span] + t * radius[span + 1]);
  }
  low_ = {1e9, 1e9, 1e9};
  high_ = {-1e9, -1e9, -1e9};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double r = radius_[i];
    const Vec& p = points_[i];
    low_ = {std::min(low_.x, p.x - r), std::min(low_.y, p.y - r), std::min(low_.z, p.z - r)};
    high_ = {std::max(high_.x, p.x + r), std::max(high_.y, p.y + r), std::max(high_.z, p.z + r)};
  }
  if (mirrored) low_.x = -high_.x;
}

double Tube::operator()(const Vec& p) const {
  const Vec q{mirrored_ ? std::abs(p.x) : p.x, p.y, p.z};
  const double far = norm({std::max({low_.x - q.x, q.x - high_.x, 0.0}), std::max({low_.y - q.y, q.y - high_.y, 0.0}),
                           std::max({low_.z - q.z, q.z - high_.z, 0.0})});
  if (far > 6.0) return far;  // beyond any blending: the distance to the box is enough
  double best = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Vec e = points_[i + 1] - points_[i];
    const Vec d = q - points_[i];
    const double length2 = dot(e, e);
    const double t = length2 > 0.0 ? std::clamp(dot(d, e) / length2, 0.0, 1.0) : 0.0;
    best = std::min(best, norm(d - t * e) - ((1 - t) * radius_[i] + t * radius_[i + 1]));
  }
  return best;
}

Plate::Plate(const std::vector<Vec>& top, const std::vector<Vec>& bottom, const std::vector<double>& top_radius,
             const std::vector<double>& bottom_radius) {
  constexpr int kPerSpan = 3;
  const auto t = curve(top, kPerSpan);
  const auto b = curve(bottom, kPerSpan);
  const auto radius_at = [](const std::vector<double>& r, std::size_t i) {
    const std::size_t span = std::min(i / kPerSpan, r.size() - 2);
    const double f = (static_cast<double>(i) - static_cast<double>(span * kPerSpan)) / kPerSpan;
    return (1 - f) * r[span] + f * r[span + 1];
  };
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double ti = radius_at(top_radius, i);
    const double tj = radius_at(top_radius, i + 1);
    const double bi = radius_at(bottom_radius, i);
    const double bj = radius_at(bottom_radius, i + 1);
    facets_.push_back({t[i], t[i + 1], b[i], ti, tj, bi});
    facets_.push_back({t[i + 1], b[i + 1], b[i], tj, bj, bi});
  }
}

double Plate::operator()(const Vec& p) const {
  const Vec q{std::abs(p.x), p.y, p.z};
  double best = std::numeric_limits<double>::max();
  for (const auto& f : facets_) {
    const Vec w = nearest_weights(q, f.a, f.b, f.c);
    const double d = norm(q - (w.x * f.a + w.y * f.b + w.z * f.c)) - (w.x * f.ra + w.y * f.rb + w.z * f.rc);
    best = std::min(best, d);
  }
  return best;
}

}  // namespace vallecula::pipeline::manikin

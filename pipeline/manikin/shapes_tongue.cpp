// Tongue and epiglottis, at rest and lifted.
#include "pipeline/manikin/shapes.h"

namespace vallecula::pipeline::manikin {
namespace {

struct TonguePoint {
  Flat at;
  double lift;  ///< share of the lift
  double jaw;   ///< share of the jaw's turn
  double bulk;  ///< share of the seed's bulk
};

// Dorsum from tip to vallecula, then below the vallecula's floor to the epiglottis' base and the anterior commissure,
// and back along the underside.
constexpr TonguePoint kTongue[] = {
    {{6.5, -19.4}, 0.00, 1.0, 0.0},  {{11.0, -17.0}, 0.35, 0.9, 0.7}, {{17.0, -18.0}, 0.75, 0.7, 1.0},
    {{22.5, -20.5}, 1.00, 0.5, 0.8}, {{26.0, -24.0}, 1.00, 0.3, 0.3}, {{28.5, -28.0}, 1.00, 0.1, 0.0},
    {{29.8, -32.0}, 0.95, 0.0, 0.0}, {{29.5, -36.5}, 0.75, 0.0, 0.0}, {{28.5, -41.3}, 0.40, 0.0, 0.0},
    {{29.3, -43.6}, 0.30, 0.0, 0.0}, {{28.7, -46.2}, 0.25, 0.0, 0.0}, {{27.6, -48.0}, 0.20, 0.0, 0.0},
    {{25.6, -46.4}, 0.00, 0.0, 0.0}, {{24.2, -42.8}, 0.00, 0.0, 0.0}, {{22.4, -39.9}, 0.00, 0.1, 0.0},
    {{17.0, -38.0}, 0.00, 0.5, 0.0}, {{12.0, -33.2}, 0.00, 0.8, 0.0}, {{9.4, -27.6}, 0.00, 1.0, 0.0},
    {{7.7, -22.6}, 0.00, 1.0, 0.0}};

Flat moved(const Flat& p, double by) { return {p.u + by * kLiftDirection.u, p.v + by * kLiftDirection.v}; }

// Epiglottis: its laryngeal face from the base to the tip.
constexpr Flat kEpiglottis[] = {{29.0, -46.0}, {30.6, -41.5}, {33.6, -38.0}, {36.5, -34.8}};
constexpr double kEpiglottisHalfThickness = 0.95;
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// Where a point of the epiglottis at rest goes: grown and turned about its base, which follows a fifth of the lift.
Flat on_epiglottis(const Variation& v, double lift, const Flat& p) {
  const double turn = (v.epiglottis_turn + 6.0 * lift) * kDegree;  // forward is counter-clockwise in (y, z)
  const Flat base = kEpiglottis[0];
  const double u = (p.u - base.u) * v.epiglottis_length;
  const double w = (p.v - base.v) * v.epiglottis_length;
  return moved({base.u + std::cos(turn) * u - std::sin(turn) * w, base.v + std::sin(turn) * u + std::cos(turn) * w},
               0.2 * lift);
}

}  // namespace

Shape tongue_shape(const Variation& v, double lift) {
  std::vector<Flat> points;
  std::vector<WidthPoint> width;
  for (const auto& t : kTongue) {
    Flat p = with_jaw(v, t.at, t.jaw);
    p.v += t.bulk * v.tongue_bulk;
    points.push_back(moved(p, t.lift * lift));
  }
  const auto add = [&](Flat at, double half, double share, double jaw) {
    width.push_back({moved(with_jaw(v, at, jaw), share * lift), half * v.tongue_width});
  };
  add({6.5, -19.0}, 6.8, 0.0, 1.0);
  add({9.5, -19.0}, 8.6, 0.2, 1.0);
  add({13.0, -18.5}, 10.8, 0.5, 0.9);
  add({17.0, -19.0}, 12.6, 0.75, 0.7);
  add({22.5, -21.5}, 13.9, 1.0, 0.5);
  add({27.0, -26.0}, 13.4, 1.0, 0.2);
  add({29.5, -31.0}, 12.8, 1.0, 0.0);
  add({29.5, -35.5}, 10.0, 0.8, 0.0);
  add({28.5, -40.5}, 7.0, 0.4, 0.0);
  add({27.5, -46.5}, 4.0, 0.2, 0.0);
  add({9.5, -26.0}, 6.2, 0.0, 1.0);
  add({14.0, -28.0}, 10.0, 0.0, 0.8);
  add({21.0, -30.0}, 12.4, 0.5, 0.3);
  add({13.0, -33.0}, 6.8, 0.0, 0.8);
  add({18.0, -37.5}, 7.0, 0.0, 0.4);
  add({23.0, -40.5}, 6.0, 0.0, 0.0);
  add({23.0, -36.0}, 9.5, 0.3, 0.1);

  auto profile = outline(points);
  auto half = widths(width, profile);
  // Median glossoepiglottic fold: a low bridge over the middle of the vallecula, which makes two pits of it.
  const Flat front = moved({27.6, -41.6}, 0.4 * lift);
  const Flat behind = on_epiglottis(v, lift, {30.4, -40.7});
  auto fold = stroke({front, {0.5 * (front.u + behind.u), 0.5 * (front.v + behind.v)}, behind}, {0.7, 0.6, 0.6});
  Shape shape;
  shape.low = {-16.0, profile.low().u + 5.0, profile.low().v + 5.0};
  shape.high = {16.0, profile.high().u - 5.0, profile.high().v - 5.0};
  shape.distance = [profile = std::move(profile), half = std::move(half), fold = std::move(fold)](const Vec& p) {
    const double x = std::abs(p.x);
    const double groove = 0.5 * std::exp(-(x - 5.5) * (x - 5.5) / 14.0) - 0.057;  // the midline stays on the profile
    const double d = profile(p.y, p.z) - groove;
    return blend(rounded(d, x - half(p.y, p.z), 5.0), rounded(fold(p.y, p.z), x - 0.6, 0.5), 1.0);
  };
  return shape;
}

Shape epiglottis_shape(const Variation& v, double lift) {
  const double turn = (v.epiglottis_turn + 6.0 * lift) * kDegree;
  const Flat base = kEpiglottis[0];
  const auto placed = [&](const Flat& p) { return on_epiglottis(v, lift, p); };
  const auto turned = [&](const Flat& d) {
    return Flat{std::cos(turn) * d.u - std::sin(turn) * d.v, std::sin(turn) * d.u + std::cos(turn) * d.v};
  };
  // The design's points are the laryngeal face; the middle of the sheet lies half a thickness in front, and ends that
  // much before the tip and the base.
  std::vector<Flat> middle;
  const std::vector<Flat> face(std::begin(kEpiglottis), std::end(kEpiglottis));
  const Flat normals[] = {{-0.94, 0.34}, {-0.86, 0.51}, {-0.74, 0.67}, {-0.74, 0.67}};
  const double h = kEpiglottisHalfThickness;
  for (std::size_t i = 0; i < face.size(); ++i) {
    Flat p{face[i].u + h * normals[i].u, face[i].v + h * normals[i].v};
    if (i + 1 == face.size()) p = {p.u - 0.6 * 0.67, p.v - 0.6 * 0.74};
    middle.push_back(p);
  }
  for (auto& p : middle) p = placed(p);
  middle.insert(middle.begin(), moved({28.4, -47.9}, 0.2 * lift));  // the stalk, down to the anterior commissure
  auto profile = stroke(middle, {0.6, h, h, h, 0.8 * h});
  auto half = widths({{moved({28.5, -48.0}, 0.2 * lift), 1.2},
                      {placed({28.8, -46.0}), 2.2},
                      {placed({30.2, -42.0}), 3.3},
                      {placed({31.8, -39.7}), 3.7},
                      {placed({33.6, -38.0}), 3.7},
                      {placed({35.2, -36.3}), 3.3},
                      {placed({36.5, -34.8}), 2.4}},
                     profile);
  const Flat back = turned({0.77, -0.64});
  const Flat up = turned({0.64, 0.77});
  const Flat foot = placed(base);
  const double curl = v.epiglottis_curl / (3.5 * 3.5);
  Shape shape;
  shape.low = {-6.0, profile.low().u - 1.0, profile.low().v - 1.0};
  shape.high = {6.0, profile.high().u + 1.0, profile.high().v + 1.0};
  shape.distance = [=, profile = std::move(profile), half = std::move(half)](const Vec& p) {
    const double x = std::abs(p.x);
    const double height = (p.y - foot.u) * up.u + (p.z - foot.v) * up.v;
    const double c = curl * ramp(-1.0, 6.0, height);
    const double xc = std::min(x, 4.5);
    const double shift = c * xc * xc;
    const double slope = 2.0 * c * xc;
    // The sheet keeps its thickness where it runs obliquely: distances shrink by the slope's secant.
    const double secant = std::sqrt(1.0 + slope * slope);
    const double d = (profile(p.y - back.u * shift, p.z - back.v * shift) + kEpiglottisHalfThickness) / secant -
                     kEpiglottisHalfThickness;
    return rounded(d, x - half(p.y, p.z), 0.9);
  };
  return shape;
}

}  // namespace vallecula::pipeline::manikin

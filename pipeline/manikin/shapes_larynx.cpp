// Larynx with arytenoids, folds and glottis; subglottis, trachea, carina.
#include "pipeline/manikin/shapes.h"

namespace vallecula::pipeline::manikin {
namespace {

constexpr double kGlottisLength = 7.034;      // between the commissures
constexpr Flat kGlottisBack{0.9667, 0.2559};  // in its plane, from front to back
constexpr double kCricoidX = 2.25;            // half axes of the cricoid's lumen: 19.3 mm^2
constexpr double kCricoidY = 2.73;
constexpr double kTracheaRadius = 2.6;

/// Signed distance to the triangle of the glottis, in its plane: u from the anterior commissure backwards, x sideways.
double triangle(double u, double x, double half, double length) {
  x = std::abs(x);
  const double side = std::hypot(half, length);
  const double across = (x * length - u * half) / side;  // outside of the slanting edge
  return rounded(across, u - length, 0.5);
}

}  // namespace

Flat carina(const Variation& v) {
  const double length = kTracheaLength * v.trachea_length;
  return {kSubglottis.u + length * kTracheaAxis.u, kSubglottis.v + length * kTracheaAxis.v};
}

LarynxShapes larynx_shapes(const Variation& v) {
  LarynxShapes shapes;
  const Flat c = carina(v);

  // Vestibule: from the cords up to the inlet between epiglottis, folds and arytenoids.
  auto vestibule = outline({{29.2, -48.3},
                            {36.1, -46.7},
                            {37.0, -45.2},
                            {37.9, -43.0},
                            {36.5, -39.0},
                            {33.4, -38.0},
                            {30.2, -41.0},
                            {28.8, -45.4}});
  auto vestibule_width = widths({{{30.2, -47.6}, 0.9},
                                 {{36.0, -46.2}, 2.3},
                                 {{33.5, -46.8}, 1.7},
                                 {{30.0, -45.0}, 2.0},
                                 {{32.0, -43.0}, 3.0},
                                 {{36.5, -44.0}, 2.6},
                                 {{34.0, -40.0}, 3.6},
                                 {{36.5, -41.0}, 3.4}},
                                vestibule);
  const double wide = v.lumen;
  const Vec top{0.0, kSubglottis.u, kSubglottis.v};
  const Vec end{0.0, c.u, c.v};
  const Vec axis{0.0, kTracheaAxis.u, kTracheaAxis.v};
  const Vec back{0.0, -kTracheaAxis.v, kTracheaAxis.u};
  const double radius = kTracheaRadius * wide;
  // The bronchi part at the carina: their inner walls meet there, so their axes start a radius above it.
  const Vec fork = end - 4.2 * axis;
  const auto bronchi =
      std::make_shared<Tube>(std::vector<Vec>{{0.3, fork.y, fork.z},
                                              {1.7, end.y - 1.6 * axis.y, end.z - 1.6 * axis.z},
                                              {4.6, end.y + 2.6 * axis.y, end.z + 2.6 * axis.z},
                                              {8.0, end.y + 6.5 * axis.y, end.z + 6.5 * axis.z}},
                             std::vector<double>{0.8 * radius, 0.78 * radius, 0.75 * radius, 0.72 * radius}, true);
  const double length = kTracheaLength * v.trachea_length;

  shapes.lumen.low = {-11.5, 26.0, c.v - 9.0};
  shapes.lumen.high = {11.5, c.u + 6.0, -36.0};
  shapes.lumen.distance = [=, vestibule = std::move(vestibule),
                           vestibule_width = std::move(vestibule_width)](const Vec& p) {
    // Glottis and subglottis: cross-sections parallel to the glottic plane, from its triangle to the cricoid's ellipse.
    const double h = (p.y - kGlottisCentre.u) * kGlottisNormal.u + (p.z - kGlottisCentre.v) * kGlottisNormal.v;
    const double u = (p.y - kAnteriorCommissure.u) * kGlottisBack.u + (p.z - kAnteriorCommissure.v) * kGlottisBack.v;
    const double slit = triangle(u, p.x, kGlottisHalfWidth, kGlottisLength);
    const double s = dot(p - top, axis);
    const double b = dot(p - top, back);
    const double grow = ramp(0.0, 8.0, s);
    const double rx = (kCricoidX + grow * (kTracheaRadius - kCricoidX)) * wide;
    const double ry = (kCricoidY + grow * (kTracheaRadius - kCricoidY)) * wide;
    const double k0 = std::hypot(p.x / rx, b / ry);
    const double k1 = std::hypot(p.x / (rx * rx), b / (ry * ry));
    const double tube = k1 > 1e-9 ? k0 * (k0 - 1.0) / k1 : -std::min(rx, ry);
    const double open = ramp(0.5, 4.2, -h);
    double d = (1.0 - open) * slit + open * tube;
    d = std::max(d, h - 0.6);
    d = meet(d, s - length + 2.2, 1.5);
    d = blend(d, (*bronchi)(p), 1.2);
    return blend(d, rounded(vestibule(p.y, p.z), std::abs(p.x) - vestibule_width(p.y, p.z), 0.8), 0.5);
  };

  const auto arytenoid =
      std::make_shared<Tube>(std::vector<Vec>{{1.75, 39.1, -44.6}, {1.9, 39.0, -46.0}, {2.2, 38.8, -48.5}},
                             std::vector<double>{1.15, 1.35, 1.5}, true);
  auto between = stroke({{38.7, -45.6}, {38.4, -49.0}}, {0.9, 1.6});  // the interarytenoid fold
  shapes.arytenoids.low = {-4.2, 35.0, -51.0};
  shapes.arytenoids.high = {4.2, 41.5, -42.5};
  shapes.arytenoids.distance = [arytenoid, between = std::move(between)](const Vec& p) {
    return blend((*arytenoid)(p), rounded(between(p.y, p.z), std::abs(p.x) - 2.0, 0.8), 0.8);
  };

  auto tower = outline({{27.0, -48.6},
                        {29.6, -47.0},
                        {32.5, -45.6},
                        {36.0, -45.6},
                        {39.0, -45.4},
                        {40.0, -47.0},
                        {40.2, -51.0},
                        {40.4, -56.0},
                        {38.6, -60.5},
                        {34.0, -61.0},
                        {31.2, -57.0},
                        {28.2, -52.0}});
  auto tower_width = widths({{{28.0, -49.0}, 3.6},
                             {{32.0, -46.5}, 4.4},
                             {{36.0, -46.5}, 4.6},
                             {{39.0, -46.5}, 4.0},
                             {{33.5, -51.0}, 5.4},
                             {{39.0, -51.0}, 4.8},
                             {{35.5, -57.0}, 5.2},
                             {{30.0, -52.0}, 4.2}},
                            tower);
  const auto fold = std::make_shared<Tube>(
      std::vector<Vec>{{2.7, 38.9, -45.3}, {4.1, 36.2, -44.0}, {4.7, 34.2, -42.4}, {4.3, 32.8, -41.2}},
      std::vector<double>{1.1, 0.95, 0.9, 0.8}, true);
  const auto wall = std::make_shared<Plate>(
      std::vector<Vec>{{2.7, 38.9, -45.3}, {4.1, 36.2, -44.0}, {4.7, 34.2, -42.4}, {4.3, 32.6, -41.2}},
      std::vector<Vec>{{2.9, 38.6, -48.0}, {3.6, 35.8, -48.0}, {3.4, 32.6, -48.0}, {2.6, 30.2, -47.6}},
      std::vector<double>{0.9, 0.9, 0.9, 0.8}, std::vector<double>{1.2, 1.2, 1.2, 1.2});
  const Shape arytenoids = shapes.arytenoids;
  shapes.body.low = {-6.5, 25.5, -62.5};
  shapes.body.high = {6.5, 42.0, -39.5};
  shapes.body.distance = [=, tower = std::move(tower), tower_width = std::move(tower_width)](const Vec& p) {
    double d = rounded(tower(p.y, p.z), std::abs(p.x) - tower_width(p.y, p.z), 1.5);
    d = blend(d, (*fold)(p), 1.0);
    d = blend(d, (*wall)(p), 1.0);
    return blend(d, arytenoids(p), 0.8);
  };
  return shapes;
}

}  // namespace vallecula::pipeline::manikin

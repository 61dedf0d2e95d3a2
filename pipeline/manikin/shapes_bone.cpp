// Skull, hard palate and upper jaw, mandible, cervical spine, hyoid.
#include "pipeline/manikin/shapes.h"

namespace vallecula::pipeline::manikin {
namespace {

constexpr double kHeadExtension = 25.0 * 3.14159265358979323846 / 180.0;

Shape skull_shape(const Variation& v, const Shape& nasal) {
  const double cs = std::cos(kHeadExtension);
  const double sn = std::sin(kHeadExtension);
  const double cy = 45.0 + 58.0 * (v.head_length - 1.0);
  const Vec centre{0.0, cs * cy + sn * 50.0, cs * 50.0 - sn * cy};
  const Vec radii{46.5 * v.head_width - 4.5, 58.0 * v.head_length - 4.5, 43.5};
  const Vec brow{9.0, cs * 4.0 + sn * 48.0 + 17.5, cs * 48.0 - sn * 4.0 - 4.0};

  // Palate plate: 1.2 mm behind the mucosa of the hard palate, 2.4 mm thick.
  auto plate = stroke({{3.0, 3.4}, {5.6, 2.8}, {10.7, 4.0}, {16.8, 2.7}, {22.4, -0.8}, {26.2, -3.6}},
                      {1.3, 1.2, 1.1, 1.1, 1.1, 0.9});
  const auto arch = std::make_shared<std::vector<Vec>>();
  for (const auto& p : upper_arch(v)) arch->push_back({p.u, p.v, upper_crest(p.v) + 2.5});
  const auto alveolar = std::make_shared<Tube>(*arch, std::vector<double>{1.45, 1.5, 1.5, 1.5, 1.5, 1.4}, true);
  std::vector<Vec> raised = *arch;
  for (auto& p : raised) p = p + Vec{0.0, 0.8, 2.6};
  const auto root = std::make_shared<Tube>(raised, std::vector<double>{1.6, 2.0, 2.3, 2.6, 2.6, 2.2}, true);
  const auto cheek = std::make_shared<Tube>(
      std::vector<Vec>{{12.0, 11.0, 8.0}, {20.0, 14.0, 13.0}, {28.0, 22.0, 14.0}, {33.0, 33.0, 8.0}, {35.0, 47.0, 1.0}},
      std::vector<double>{3.2, 3.4, 2.6, 1.6, 1.6}, true);
  const auto pillar =
      std::make_shared<Tube>(std::vector<Vec>{{9.0, 6.5, 7.0}, {8.0, 6.5, 15.0}, {6.5, 6.5, 24.0}, {8.0, 8.5, 33.0}},
                             std::vector<double>{2.6, 2.0, 1.7, 2.2}, true);
  const auto nasal_bone = std::make_shared<Tube>(std::vector<Vec>{{1.6, 5.0, 29.5}, {1.5, 3.6, 25.8}, {1.6, 2.2, 23.8}},
                                                 std::vector<double>{1.5, 1.1, 0.9}, true);
  const auto rim = std::make_shared<Tube>(std::vector<Vec>{{8.0, 8.5, 32.0},
                                                           {16.0, 6.8, 35.2},
                                                           {25.0, 10.5, 33.0},
                                                           {29.5, 16.5, 25.5},
                                                           {27.0, 18.5, 17.0},
                                                           {20.0, 13.5, 14.0}},
                                          std::vector<double>{1.8, 1.8, 1.8, 1.7, 1.8, 1.9}, true);
  const Vec fontanelle{0.0, centre.y - 16.0, centre.z + 47.0};

  Shape shape;
  shape.distance = [=, plate = std::move(plate)](const Vec& p) {
    const Vec q{std::abs(p.x), p.y, p.z};
    // Brain case: the cranium less the face below the base that runs from the brow to the foramen magnum.
    double box = tilted_ellipsoid(q, centre, radii, kHeadExtension);
    box = blend(box, tilted_ellipsoid(q, brow, {20.0 * v.head_width - 4.0, 15.0, 18.5}, kHeadExtension), 12.0);
    const double base = (-(q.z - 32.0) * 0.83 - (q.y - 8.0) * 0.553);
    box = meet(box, base, 8.0);
    double d = std::abs(box) - 1.0;
    const double soft = norm(q - fontanelle) - 7.5;
    d = carve(d, soft, 1.0);
    const double foramen = std::hypot(q.x, q.y - 60.0) - 8.0;
    if (q.z < 15.0) d = carve(d, foramen, 1.0);
    double face = blend((*alveolar)(q), (*root)(q), 2.0);
    const double half = 3.0 + 12.0 * ramp(0.0, 16.0, q.y);
    face = blend(face, rounded(plate(q.y, q.z), q.x - std::min(half, 14.0), 1.0), 2.0);
    face = blend(face, (*cheek)(q), 3.0);
    face = blend(face, (*pillar)(q), 3.0);
    face = blend(face, (*rim)(q), 2.0);
    face = blend(face, (*nasal_bone)(q), 1.5);
    d = blend(d, face, 3.0);
    return 0.9 * carve(d, nasal(p) - 0.8, 0.8);
  };
  shape.steepest = kGentle;
  shape.low = {-50.0 * v.head_width, 0.0, -45.0};
  shape.high = {50.0 * v.head_width, 125.0, 85.0};
  return shape;
}

Shape mandible_shape(const Variation& v) {
  // Columns from the crest (below 1 mm of gum) to the lower border, chin to ramus; the angle is the gonion.
  const auto arch = lower_arch(v);
  std::vector<Vec> top;
  std::vector<Vec> bottom;
  const Flat opening = with_jaw(v, {3.4, -20.8});
  for (const auto& p : arch) {
    const double y = p.v + opening.u - 3.4;
    top.push_back({p.u, y, lower_crest(v, y) - 2.7});
  }
  const auto low = [&](double x, double y, double z) {
    const Flat p = with_jaw(v, {y, z});
    bottom.push_back({with_gonia(v, x, y), p.u, p.v});
  };
  const auto high = [&](double x, double y, double z) {
    const Flat p = with_jaw(v, {y, z});
    top.push_back({with_gonia(v, x, y), p.u, p.v});
  };
  low(0.0, 6.4, -35.7);
  low(5.0, 6.8, -35.7);
  low(9.2, 9.0, -35.4);
  low(13.8, 13.0, -34.6);
  low(18.2, 18.6, -33.4);
  low(22.6, 24.0, -32.2);
  low(26.4, 30.0, -30.8);
  high(24.0, 33.5, -12.0);
  low(29.4, 36.0, -28.2);
  high(28.0, 38.5, -6.5);
  low(30.0, 40.5, -20.0);
  high(29.6, 44.5, -7.5);
  low(30.0, 45.0, -10.5);
  const auto plate =
      std::make_shared<Plate>(top, bottom, std::vector<double>{1.7, 1.7, 1.7, 1.7, 1.7, 1.7, 1.7, 1.5, 1.3, 1.5},
                              std::vector<double>{2.3, 2.3, 2.3, 2.3, 2.3, 2.2, 2.1, 1.9, 1.7, 1.8});
  const double condyle_x = with_gonia(v, kCondyleX, kCondyle.u);
  Shape shape;
  shape.steepest = kGentle;
  shape.low = {-40.0, 0.0, -44.0};
  shape.high = {40.0, 53.0, 2.0};
  shape.distance = [plate, condyle_x](const Vec& p) {
    const Vec q{std::abs(p.x), p.y, p.z};
    return blend((*plate)(q), ellipsoid(q, {condyle_x, kCondyle.u, kCondyle.v}, {4.0, 2.6, 2.6}), 2.0);
  };
  return shape;
}

Shape spine_shape(const Variation& v) {
  const Flat c = carina(v);
  // Middle of the vertebral bodies from the skull base to below the carina.
  const auto line =
      std::make_shared<std::vector<Flat>>(curve(std::vector<Flat>{{54.0, 1.0},
                                                                  {52.6, -8.0},
                                                                  {51.6, -18.0},
                                                                  {50.6, -28.0},
                                                                  {50.0, -38.0},
                                                                  {50.4, -52.0},
                                                                  {0.5 * (50.4 + c.u + 15.5), 0.5 * (-52.0 + c.v)},
                                                                  {c.u + 15.5, c.v},
                                                                  {c.u + 20.0, c.v - 22.0}},
                                                false, 6));
  const auto arc = std::make_shared<std::vector<double>>(1, 0.0);
  for (std::size_t i = 1; i < line->size(); ++i)
    arc->push_back(arc->back() + std::hypot((*line)[i].u - (*line)[i - 1].u, (*line)[i].v - (*line)[i - 1].v));
  Shape shape;
  shape.low = {-15.0, 40.0, c.v - 24.0};
  shape.high = {15.0, 96.0, 3.0};
  shape.distance = [line, arc](const Vec& p) {
    double best = 1e9;
    double s = 0.0;
    double b = 0.0;
    for (std::size_t i = 0; i + 1 < line->size(); ++i) {
      const Flat& a = (*line)[i];
      const Flat& e = (*line)[i + 1];
      const double du = e.u - a.u;
      const double dv = e.v - a.v;
      const double l2 = du * du + dv * dv;
      const double t = std::clamp(((p.y - a.u) * du + (p.z - a.v) * dv) / l2, 0.0, 1.0);
      const double eu = p.y - a.u - t * du;
      const double ev = p.z - a.v - t * dv;
      const double d = std::hypot(eu, ev);
      if (d < best) {
        best = d;
        s = (*arc)[i] + t * std::sqrt(l2);
        b = eu * -dv + ev * du > 0.0 ? d : -d;
      }
    }
    constexpr double kLevel = 7.4;  // body and disc
    const double phase = std::abs(s / kLevel - std::floor(s / kLevel) - 0.5) * kLevel;
    const double body = (std::hypot(p.x / 6.2, b / 4.2) - 1.0) * 4.2;
    double d = rounded(body, phase - 2.7, 1.0);
    const double ring = std::abs((std::hypot(p.x / 7.2, (b - 9.0) / 6.4) - 1.0) * 6.4) - 1.1;
    d = blend(d, rounded(ring, phase - 2.2, 0.8), 1.0);
    const double spinous = rounded(std::abs(p.x) - 1.2, std::max(std::abs(b - 18.5) - 4.0, phase - 1.8), 0.8);
    d = blend(d, spinous, 1.0);
    return 0.9 * std::max(d, std::max(1.5 - s, s - arc->back() + 1.0));
  };
  return shape;
}

Shape hyoid_shape() {
  const auto horn = std::make_shared<Tube>(
      std::vector<Vec>{
          {-4.0, 22.6, -41.7}, {0.0, 22.2, -41.7}, {4.5, 22.8, -41.7}, {8.5, 26.0, -41.4}, {11.2, 31.5, -40.4}},
      std::vector<double>{1.5, 1.6, 1.4, 1.0, 0.8}, true);
  Shape shape;
  shape.low = {-13.0, 19.0, -45.0};
  shape.high = {13.0, 34.0, -38.0};
  shape.distance = [horn](const Vec& p) { return (*horn)(p); };
  return shape;
}

}  // namespace

BoneShapes bone_shapes(const Variation& v, const Shape& nasal) {
  return {skull_shape(v, nasal), mandible_shape(v), spine_shape(v), hyoid_shape()};
}

}  // namespace vallecula::pipeline::manikin

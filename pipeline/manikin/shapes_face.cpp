// Skin: cranium, face with nose, lips, closed eyes, chin, ears, neck and upper chest; and the opening of the mouth.
#include "pipeline/manikin/shapes.h"

namespace vallecula::pipeline::manikin {
namespace {

constexpr double kExtension = 25.0 * 3.14159265358979323846 / 180.0;  ///< of the head

/// From the head's own frame (not extended) to the patient's, in (y, z).
Flat extended(double y, double z) {
  return {std::cos(kExtension) * y + std::sin(kExtension) * z, std::cos(kExtension) * z - std::sin(kExtension) * y};
}

Shape aperture_shape(const Variation& v) {
  // Oval between the lips, 26 mm from lip to lip where the gums are 22 apart; its lower rim follows the jaw.
  const double bottom = with_jaw(v, {-1.5, -22.0}).v;
  const double top = 3.5;
  const double middle = 0.5 * (top + bottom);
  const double half_z = 0.5 * (top - bottom);
  constexpr double kHalfX = 15.0;
  Shape shape;
  shape.low = {-kHalfX - 1.0, -26.0, bottom - 1.0};
  shape.high = {kHalfX + 1.0, 3.0, top + 1.0};
  shape.near = 6.0;  // the lips are rounded off over some millimetres
  shape.distance = [=](const Vec& p) {
    const double a = std::abs(p.x) / kHalfX;
    const double b = std::abs(p.z - middle) / half_z;
    // A superellipse of exponent 2.3; value over gradient is its distance to first order.
    const double q = std::pow(a, 2.3) + std::pow(b, 2.3);
    const double k = std::pow(q, 1.0 / 2.3);
    const double ga = std::pow(a, 1.3) / kHalfX;
    const double gb = std::pow(b, 1.3) / half_z;
    const double gradient = std::pow(std::max(q, 1e-9), 1.0 / 2.3 - 1.0) * std::hypot(ga, gb);
    const double d = (k - 1.0) / std::max(gradient, 0.06);
    return meet(d, std::max(p.y - 2.5, -25.0 - p.y), 2.0);
  };
  return shape;
}

}  // namespace

FaceShapes face_shapes(const Variation& v) {
  FaceShapes shapes;
  shapes.aperture = aperture_shape(v);
  const auto jaw = [&](Flat p) { return with_jaw(v, p); };

  // Mid-sagittal profile of the face without the nose: brow, lips, chin, under the chin, and back inside the head.
  const Flat chin_shift{-v.chin, 0.0};
  const auto chin = [&](Flat p) {
    const Flat q = jaw(p);
    return Flat{q.u + chin_shift.u, q.v};
  };
  auto profile =
      outline({{2.6, 38.0},         {1.0, 31.0},        {0.6, 25.0},        {-0.2, 19.0},        {-1.5, 13.4},
               {-4.2, 10.2},        {-5.8, 7.2},        {-5.5, 4.0},        {-4.4, -4.0},        jaw({-3.4, -14.0}),
               jaw({-3.2, -21.0}),  jaw({-4.8, -24.6}), jaw({-3.4, -28.2}), chin({-2.2, -30.8}), chin({-2.9, -34.2}),
               chin({-1.0, -37.6}), chin({3.0, -40.0}), jaw({10.0, -42.4}), {17.5, -46.0},       {32.0, -44.0},
               {42.0, -20.0},       {42.0, 20.0},       {22.0, 42.0},       {8.0, 44.0}},
              6.0, 0.5);
  auto profile_width = widths({{{0.0, 34.0}, 24.0},
                               {{0.0, 24.0}, 21.0},
                               {{-3.0, 8.0}, 20.5},
                               {{-3.0, -8.0}, 20.5},
                               {{-3.0, -24.0}, 18.5},
                               {{-1.0, -35.0}, 14.5},
                               {{8.0, -41.0}, 18.0},
                               {{20.0, -38.0}, 24.0},
                               {{20.0, 0.0}, 28.0},
                               {{25.0, 30.0}, 28.0}},
                              profile);
  const auto nose = v.nose_size;
  const auto bridge =
      std::make_shared<Tube>(std::vector<Vec>{{0, 4.6, 29.5}, {0, 2.8, 25.6}, {0, 0.2, 22.6}, {0, -1.9, 19.9}},
                             std::vector<double>{3.4, 3.0 * nose, 3.5 * nose, 4.5 * nose}, false);
  const auto columella = std::make_shared<Tube>(std::vector<Vec>{{0, -3.0, 17.9}, {0, 0.2, 14.6}},
                                                std::vector<double>{2.5 * nose, 1.9}, false);
  const auto wing =
      std::make_shared<Tube>(std::vector<Vec>{{2.4, -2.3, 19.4}, {5.9 * nose, -0.6, 18.2}, {7.6 * nose, 2.2, 16.2}},
                             std::vector<double>{3.4 * nose, 3.3 * nose, 2.6 * nose}, true);

  // Lips: one swelling round the opening, thick in the middle, thin at the corners.
  const Flat low = jaw({-2.6, -24.2});
  const Flat low_side = jaw({-0.4, -22.4});
  const auto lip =
      std::make_shared<Tube>(std::vector<Vec>{{-5.0, -3.3, 6.2},
                                              {0.0, -3.5, 6.0},
                                              {5.0, -3.3, 6.2},
                                              {10.5, -0.7, 3.0},
                                              {14.9, 2.4, -3.0},
                                              {16.4, 3.6, -9.2},
                                              {14.7, 2.8, -15.8},
                                              {9.8, low_side.u, low_side.v},
                                              {4.8, low.u, low.v + 0.2},
                                              {0.0, low.u, low.v},
                                              {-4.8, low.u, low.v + 0.2}},
                             std::vector<double>{2.9, 2.6, 2.9, 2.7, 2.2, 1.8, 2.1, 2.7, 2.9, 2.8, 2.9}, true);

  const double hw = v.head_width;
  const double hl = v.head_length;
  const Flat cranium = extended(45.0 + 58.0 * (hl - 1.0), 50.0);
  const Flat brow = extended(4.0, 48.0);
  const double cheek = v.cheek;
  const double jaw_wide = v.gonial_width / 63.6;

  // Auricle: a bowl behind the jaw's hinge, turned out of the head; sized 35 mm at term.
  const Flat ear = extended(63.0, 27.0);
  const double es = v.ear_size;

  shapes.head.distance = [=, profile = std::move(profile), profile_width = std::move(profile_width)](const Vec& p) {
    const Vec q{std::abs(p.x), p.y, p.z};
    // Face: profile, cheeks, jaw, temples.
    double face = rounded(profile(q.y, q.z), q.x - profile_width(q.y, q.z), 15.0);
    face = blend(face, ellipsoid(q, {20.5, 20.0, -3.0}, {17.0 + cheek, 17.5 + 0.6 * cheek, 18.5}), 7.0);
    face = blend(face, ellipsoid(q, {18.0 * jaw_wide, 30.0, -18.0}, {18.0, 20.5, 18.0}), 9.0);
    face = blend(face, ellipsoid(q, {19.0, 36.0, 8.0}, {20.0 * hw, 28.0, 26.0}), 10.0);
    // Cranium with its frontal and parietal bosses.
    double skull = tilted_ellipsoid(q, {0.0, cranium.u, cranium.v}, {46.5 * hw, 58.0 * hl, 48.0}, kExtension);
    skull = blend(skull, tilted_ellipsoid(q, {11.0, brow.u + 17.0, brow.v - 4.0}, {22.0 * hw, 19.0, 23.0}, kExtension),
                  14.0);
    double d = blend(face, skull, 14.0);
    // Eye sockets, then lids over the eyeballs.
    d = carve(d, ellipsoid(q, {16.5, -3.8, 25.0}, {11.0, 6.6, 6.8}), 7.0);
    d = blend(d, ellipsoid(q, {18.0, 11.8, 24.6}, {10.4, 9.4, 8.0}), 4.0);
    d = blend(d, (*bridge)(q), 4.0);
    d = blend(d, (*wing)(q), 2.0);
    d = blend(d, (*columella)(q), 1.6);
    d = blend(d, (*lip)(q), 1.6);
    // Neck and the upper chest with the shoulders.
    const Vec n0{0.0, 56.0, -15.0};
    const Vec n1{0.0, 51.0, -80.0};
    const double t = std::clamp(dot(q - n0, n1 - n0) / dot(n1 - n0, n1 - n0), 0.0, 1.0);
    const Vec nq = q - (n0 + t * (n1 - n0));
    const double neck = norm({nq.x * 0.88, nq.y * 0.93, nq.z}) - (28.5 + 2.0 * t);
    d = blend(d, neck, 9.0);
    const double chest = ellipsoid(q, {0.0, 57.0, -106.0}, {76.0, 41.0, 46.0});
    d = blend(d, chest, 22.0);
    // Ear.
    const double out = q.x - 43.0 * hw;
    if (std::abs(q.y - ear.u) < 26.0 && std::abs(q.z - ear.v) < 30.0 && out > -14.0) {
      const double cs = std::cos(0.42);
      const double sn = std::sin(0.42);
      const double ey = q.y - ear.u;
      const Vec e{cs * out - sn * ey, sn * out + cs * ey, q.z - ear.v};
      double ear_d = tilted_ellipsoid(e, {1.5, 0.0, 0.0}, {3.2, 10.5 * es, 17.5 * es}, kExtension);
      ear_d = carve(ear_d, tilted_ellipsoid(e, {5.2, -1.2, 1.6}, {4.6, 7.4 * es, 13.0 * es}, kExtension), 1.4);
      ear_d = blend(ear_d, tilted_ellipsoid(e, {2.2, -7.4, -2.5}, {2.0, 2.0, 3.6}, kExtension), 3.0);
      d = blend(d, ear_d, 2.5);
    }
    return 0.95 * d;
  };

  const auto slit = std::make_shared<Tube>(
      std::vector<Vec>{{11.2, 5.4, 23.4}, {14.0, 3.4, 22.4}, {18.5, 2.4, 21.6}, {23.0, 3.4, 22.2}, {27.6, 6.8, 24.2}},
      std::vector<double>{0.0, 0.4, 0.55, 0.45, 0.0}, true);
  shapes.eyelids.distance = [slit](const Vec& p) { return (*slit)(p); };
  shapes.eyelids.low = slit->low();
  shapes.eyelids.high = slit->high();
  return shapes;
}

}  // namespace vallecula::pipeline::manikin

// The hollow of mouth, pharynx and nose, and what stands into it: gums, soft palate; and the oesophagus behind.
#include "pipeline/manikin/shapes.h"

namespace vallecula::pipeline::manikin {
namespace {

Sampled plan_of(const std::vector<Flat>& arch) {
  const auto points = curve(arch, false, 8);
  return Sampled({-3.0, -6.0}, {34.0, 44.0}, 0.4, true, [&](const Flat& p) {
    double best = 1e9;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double du = points[i + 1].u - points[i].u;
      const double dv = points[i + 1].v - points[i].v;
      const double t =
          std::clamp(((p.u - points[i].u) * du + (p.v - points[i].v) * dv) / (du * du + dv * dv), 0.0, 1.0);
      best = std::min(best, std::hypot(p.u - points[i].u - t * du, p.v - points[i].v - t * dv));
    }
    return best;
  });
}

}  // namespace

std::vector<Flat> upper_arch(const Variation&) {
  return {{0.0, 0.9}, {5.0, 2.4}, {9.0, 6.6}, {13.0, 15.0}, {14.6, 22.0}, {15.0, 27.5}};
}

std::vector<Flat> lower_arch(const Variation& v) {
  std::vector<Flat> arch = {{0.0, 3.4},   {5.4, 4.6},   {10.0, 7.2}, {14.2, 11.6},
                            {17.3, 17.0}, {19.2, 22.5}, {20.4, 28.0}};
  for (auto& p : arch) p.u = with_gonia(v, p.u, p.v);
  return arch;
}

double upper_crest(double y) { return -0.30 * std::max(y - 2.0, 0.0); }

double lower_crest(const Variation& v, double y) {
  const Flat front = with_jaw(v, {3.4, -20.8});
  const Flat back = with_jaw(v, {28.0, -16.0});
  return front.v + (back.v - front.v) * std::max(y - front.u, 0.0) / (back.u - front.u);
}

MouthShapes mouth_shapes(const Variation& v, const FaceShapes& face) {
  MouthShapes shapes;
  const auto jaw = [&](Flat p, double share = 1.0) { return with_jaw(v, p, share); };

  // Mouth: from behind the lips to the fauces; its floor is the sulcus around the tongue.
  auto mouth = outline({{-0.4, 3.2},
                        {1.8, 0.6},
                        {5.6, 0.2},
                        {10.7, 1.6},
                        {16.8, 0.5},
                        {22.9, -3.0},
                        {27.7, -6.8},
                        {31.0, -9.5},
                        {33.0, -16.0},
                        {32.5, -28.0},
                        {31.5, -37.0},
                        {29.6, -42.0},
                        {27.6, -39.0},
                        {25.6, -34.5},
                        {22.5, -31.4},
                        jaw({17.5, -29.4}, 0.8),
                        jaw({12.5, -28.0}),
                        jaw({7.5, -26.8}),
                        jaw({1.5, -27.2}),
                        jaw({0.0, -24.5}),
                        jaw({-0.4, -18.0}, 0.6),
                        {-0.6, -8.0}});
  auto mouth_width = widths({{{-0.5, -9.0}, 13.5},
                             {{3.0, -4.0}, 15.0},
                             {{3.0, -14.0}, 15.0},
                             {{8.0, -8.0}, 17.0},
                             {{15.0, -8.0}, 18.8},
                             {{21.0, -10.0}, 18.6},
                             {{26.0, -14.0}, 15.5},
                             {{30.5, -17.0}, 11.0},
                             {{9.0, -24.0}, 16.6},
                             {{15.0, -25.0}, 18.6},
                             {{22.0, -26.0}, 18.0},
                             {{27.0, -27.0}, 15.6},
                             {{30.5, -28.0}, 13.0},
                             {{29.0, -33.0}, 14.0},
                             {{29.5, -37.5}, 9.5},
                             {{29.5, -41.0}, 7.2},
                             {{15.0, 0.0}, 15.0},
                             {{24.0, -4.0}, 13.0}},
                            mouth);
  // Nasopharynx, oropharynx, hypopharynx down to the mouth of the oesophagus and the pits beside the larynx.
  auto throat = outline({{28.2, -2.6},
                         {27.6, 3.0},
                         {29.5, 8.0},
                         {33.5, 9.6},
                         {38.5, 7.2},
                         {42.8, 1.6},
                         {45.0, -6.0},
                         {44.5, -18.0},
                         {43.5, -28.0},
                         {42.5, -36.0},
                         {41.8, -43.0},
                         {42.3, -49.0},
                         {41.3, -50.8},
                         {38.0, -49.6},
                         {34.5, -48.4},
                         {31.5, -45.5},
                         {29.6, -41.0},
                         {29.0, -30.0},
                         {28.8, -12.0}});
  auto throat_width = widths({{{31.0, 3.0}, 8.6},
                              {{38.0, 3.0}, 8.6},
                              {{40.0, -8.0}, 9.8},
                              {{38.0, -20.0}, 10.5},
                              {{38.0, -34.0}, 10.5},
                              {{36.5, -41.0}, 9.6},
                              {{38.0, -46.0}, 7.6},
                              {{41.3, -50.0}, 4.0},
                              {{33.0, -46.5}, 7.6},
                              {{30.0, -12.0}, 10.0},
                              {{30.0, -30.0}, 10.5},
                              {{31.0, -40.0}, 7.6}},
                             throat);
  // One nasal passage a side: a slit beside the septum, above the palate.
  auto passage = outline({{2.0, 15.2},
                          {5.0, 8.6},
                          {10.0, 5.0},
                          {16.5, 3.6},
                          {22.5, 0.4},
                          {29.5, -2.8},
                          {33.0, 1.0},
                          {30.0, 6.6},
                          {22.0, 11.5},
                          {12.5, 16.8},
                          {5.5, 21.6},
                          {1.6, 20.8},
                          {0.6, 17.6}});

  const double nose = v.nose_size;
  const auto nostril = std::make_shared<Tube>(
      std::vector<Vec>{{4.4 * nose, -6.5, 11.2}, {4.1 * nose, -3.0, 14.4}, {3.6, 0.4, 17.2}, {2.8, 4.0, 18.0}},
      std::vector<double>{1.8 * nose, 1.7 * nose, 1.6 * nose, 1.4}, true);
  shapes.nasal.low = {-8.0, -9.0, -5.0};
  shapes.nasal.high = {8.0, 35.0, 25.0};
  shapes.nasal.distance = [passage = std::move(passage), nostril](const Vec& p) {
    const double slit = rounded(passage(p.y, p.z), std::abs(std::abs(p.x) - 2.5) - 1.5, 1.2);
    return blend(slit, (*nostril)(p), 1.5);
  };

  const auto upper_plan = std::make_shared<Sampled>(plan_of(upper_arch(v)));
  shapes.upper_gum.low = {-19.0, -4.0, -12.0};
  shapes.upper_gum.high = {19.0, 32.0, 8.0};
  shapes.upper_gum.distance = [upper_plan](const Vec& p) {
    const double half = 2.3 + 0.35 * std::max(p.z - upper_crest(p.y), 0.0);
    return std::max(rounded((*upper_plan)(std::abs(p.x), p.y) - half, upper_crest(p.y) - p.z, 2.1), p.z - 6.0) * 0.94;
  };
  const auto lower_plan = std::make_shared<Sampled>(plan_of(lower_arch(v)));
  const Flat opening = with_jaw(v, {3.4, -20.8});
  const double shift_y = opening.u - 3.4;
  shapes.lower_gum.low = {-25.0, -2.0, -38.0};
  shapes.lower_gum.high = {25.0, 33.0, -13.0};
  shapes.lower_gum.distance = [lower_plan, v, shift_y](const Vec& p) {
    const double crest = lower_crest(v, p.y);
    const double half = 2.3 + 0.10 * std::max(crest - p.z, 0.0);
    return std::max(rounded((*lower_plan)(std::abs(p.x), p.y - shift_y) - half, p.z - crest, 2.1), -36.0 - p.z) * 0.97;
  };

  const Shape upper_gum = shapes.upper_gum;
  const Shape lower_gum = shapes.lower_gum;
  const Shape nasal = shapes.nasal;
  shapes.cavity.low = {-21.0, -30.0, -53.0};
  shapes.cavity.high = {21.0, 47.0, 25.0};
  shapes.cavity.distance = [mouth = std::move(mouth), mouth_width = std::move(mouth_width), throat = std::move(throat),
                            throat_width = std::move(throat_width), face, upper_gum, lower_gum, nasal](const Vec& p) {
    const double x = std::abs(p.x);
    double d = rounded(mouth(p.y, p.z), x - mouth_width(p.y, p.z), 4.0);
    if (d < 1.0 && p.y < 12.0) d = meet(d, face.head(p) + 3.2, 2.0);  // lips and cheeks are never thinner than this
    d = blend(d, face.aperture(p), 2.5);
    d = carve(d, upper_gum(p), 1.2);
    d = carve(d, lower_gum(p), 1.0);
    d = blend(d, rounded(throat(p.y, p.z), x - throat_width(p.y, p.z), 6.0), 2.0);
    return blend(d, nasal(p), 1.0);
  };

  // Soft palate: a sheet from the hard palate's edge to the uvula's tip; the design's line is its oral face.
  const double longer = v.uvula_length;
  auto sheet = stroke({{25.0, -3.4}, {28.4, -5.4}, {33.4, -9.6}, {36.2, -16.6}, {35.0 + 0.2 * longer, -23.2 - longer}},
                      {1.7, 2.0, 2.2, 2.0, 1.8});
  auto sheet_width = widths({{{25.0, -3.4}, 13.0},
                             {{28.4, -5.4}, 12.0},
                             {{33.4, -9.6}, 11.5},
                             {{35.6, -14.5}, 10.5},
                             {{36.2, -17.8}, 3.4},
                             {{35.6, -20.5}, 2.5},
                             {{35.0, -25.0 - longer}, 2.3},
                             {{33.5, -16.5}, 9.0}},
                            sheet);
  shapes.soft_palate.low = {-15.0, 22.0, -28.0};
  shapes.soft_palate.high = {15.0, 40.0, -0.5};
  shapes.soft_palate.distance = [sheet = std::move(sheet), sheet_width = std::move(sheet_width)](const Vec& p) {
    const double x = std::abs(p.x);
    const double hang = 0.012 * x * x;  // the arches hang lower at the sides
    return 0.9 * rounded(sheet(p.y, p.z + std::min(hang, 1.4)), x - sheet_width(p.y, p.z), 1.6);
  };

  // Oesophagus, collapsed: flat tube behind the trachea.
  const Flat c = carina(v);
  const std::vector<Flat> line = {{41.6, -50.5},
                                  {41.6, -55.0},
                                  {kSubglottis.u + 0.5 * (c.u - kSubglottis.u) + 6.3, -73.0 - 0.5 * (-95.8 - c.v)},
                                  {c.u + 6.2, c.v + 1.6},
                                  {c.u + 8.4, c.v - 6.0},
                                  {c.u + 12.0, c.v - 18.0}};
  auto gullet = stroke(line, {1.9, 2.0, 2.0, 2.0, 2.1, 2.2});
  shapes.oesophagus.low = {-6.0, 37.0, c.v - 21.0};
  shapes.oesophagus.high = {6.0, c.u + 16.0, -47.0};
  shapes.oesophagus.distance = [gullet = std::move(gullet)](const Vec& p) {
    return rounded(gullet(p.y, p.z), std::abs(p.x) - 3.8, 1.9);
  };
  return shapes;
}

}  // namespace vallecula::pipeline::manikin

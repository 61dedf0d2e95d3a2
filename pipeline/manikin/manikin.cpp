#include "pipeline/manikin/manikin.h"

#include <cstdio>
#include <stdexcept>

#include "pipeline/manikin/manikin_data.h"

namespace vallecula::pipeline {

using manikin::Flat;
using manikin::Vec;

namespace {

/// Lengths grow with weight to the power 0.29: the slope, over 24 to 40 weeks, of the cords-to-trachea and mandible
/// regressions of CLINICAL sources against a growth chart's weights (0.65 kg at 24, 3.1 kg at 38 weeks).
double scale_of(double weight_kg) { return std::pow(weight_kg / 3.2, 0.29); }

// From the glottis' centre the operator looks along the handle's plane; the eye is 320 mm from the upper gum.
constexpr Flat kSight{-0.616, 0.788};
constexpr double kEyeDistance = 320.2;

constexpr double kTongueHeight = 18.0;  // mm at term (assumed, CLINICAL sources)

double eye_along(double scale, const Flat& glottis) {
  // Distance t from the glottis with |glottis + t sight| = kEyeDistance, at term scale.
  const double reach = kEyeDistance / scale;
  const double norm2 = kSight.u * kSight.u + kSight.v * kSight.v;
  const double b = (glottis.u * kSight.u + glottis.v * kSight.v) / norm2;
  const double c = (glottis.u * glottis.u + glottis.v * glottis.v - reach * reach) / norm2;
  return -b + std::sqrt(b * b - c);
}

void check_range(const char* what, double value, double low, double high) {
  char text[160];
  std::snprintf(text, sizeof text, "manikin: %s of %g is outside %g to %g; give a value in that range", what, value,
                low, high);
  if (!(value >= low && value <= high)) throw std::runtime_error(text);
}

/// What the seed draws, with what the shape asks for in its place; everything at term scale.
manikin::Variation varied(double scale, std::uint64_t seed, const ManikinShape& shape) {
  manikin::Variation v = manikin::vary(seed);
  if (shape.mouth_opening) {
    check_range("a mouth opening (factor)", *shape.mouth_opening, 0.8, 1.15);
    v.mouth_opening = *shape.mouth_opening * manikin::Variation{}.mouth_opening;
  }
  if (shape.tongue_size) {
    check_range("a tongue's size (factor)", *shape.tongue_size, 0.9, 1.1);
    v.tongue_width = *shape.tongue_size;
    v.tongue_bulk = kTongueHeight * (*shape.tongue_size - 1.0);
  }
  if (shape.larynx_height_mm) {
    check_range("a larynx' height (mm)", *shape.larynx_height_mm, manikin::kDeepestLarynx, manikin::kHighestLarynx);
    v.larynx_rise = *shape.larynx_height_mm;
  }
  if (shape.epiglottis_length) {
    check_range("an epiglottis' length (factor)", *shape.epiglottis_length, 0.8, 1.2);
    v.epiglottis_length = *shape.epiglottis_length;
  }
  if (shape.gestation_weeks) {
    check_range("a gestation (weeks)", *shape.gestation_weeks, 22.0, 44.0);
    const double cords_to_carina = 2.0 * (2.831 + 0.6208 * *shape.gestation_weeks);  // orbi.uliege.be 220819
    const double to_subglottis = std::hypot(manikin::kSubglottis.u - manikin::kGlottisCentre.u,
                                            manikin::kSubglottis.v - manikin::kGlottisCentre.v);
    v.trachea_length = (cords_to_carina / scale - to_subglottis) / manikin::kTracheaLength;
    check_range("a trachea's length for its gestation, against the weight's (factor)", v.trachea_length, 0.7, 1.5);
  }
  return v;
}

}  // namespace

Manikin::Data::Data(double weight_kg, const manikin::Variation& variation)
    : scale(scale_of(weight_kg)), body(variation) {
  const Vec centre = with_larynx(variation, {0.0, manikin::kGlottisCentre.u, manikin::kGlottisCentre.v});
  const double t = eye_along(scale, {centre.y, centre.z});
  eye = {0.0, centre.y + t * kSight.u, centre.z + t * kSight.v};
}

Manikin::Manikin(double weight_kg, std::uint64_t seed, const ManikinShape& shape) {
  if (!(weight_kg >= kLightest && weight_kg <= kHeaviest))
    throw std::runtime_error("manikin: a weight of " + std::to_string(weight_kg) +
                             " kg is outside 0.6 to 4.5 kg; give a weight in that range");
  data_ = std::make_unique<Data>(weight_kg, varied(scale_of(weight_kg), seed, shape));
}
Manikin::~Manikin() = default;
Manikin::Manikin(Manikin&&) noexcept = default;
Manikin& Manikin::operator=(Manikin&&) noexcept = default;

double Manikin::scale() const { return data_->scale; }

Label Manikin::label_at(const Point& p) const { return manikin::label_of(data_->body.at(data_->inside(p))); }

double Manikin::hounsfield_at(const Point& p) const { return manikin::hounsfield_of(data_->body.at(data_->inside(p))); }

std::map<std::string, Point> Manikin::landmarks() const {
  const auto& body = data_->body;
  const auto& v = body.variation();
  const auto place = [this](const Flat& p) { return data_->placed({0.0, p.u, p.v}); };
  const auto at = [&](double y, double z) { return body.at(with_larynx(v, {0.0, y, z})); };
  // Vallecula: the deepest air in the middle that has tongue in front and epiglottis behind.
  Flat pit{29.0, -40.5};
  for (double z = -37.0; z > -44.0; z -= 0.05) {
    double y = 24.0;
    while (y < 33.0 && at(y, z) != manikin::Matter::airway) y += 0.05;
    double end = y;
    while (end < 36.0 && at(end, z) == manikin::Matter::airway) end += 0.05;
    if (at(end, z) != manikin::Matter::epiglottis) break;
    pit = {0.5 * (y + end), z};
  }
  // Tip of the epiglottis: its farthest point from the base in the middle.
  Flat tip{};
  double farthest = 0.0;
  for (double z = -40.0; z < -30.0; z += 0.1)
    for (double y = 30.0; y < 42.0; y += 0.1) {
      const double d = std::hypot(y - 29.0, z + 46.0);
      if (d > farthest && body.epiglottis()({0.0, y, z}) < 0.0) {
        farthest = d;
        tip = {y, z};
      }
    }
  return {{"upper_gum_midline", {0.0, 0.0, 0.0}},
          {"lower_gum_midline", place(with_jaw(v, {3.4, -20.8}))},
          {"vallecula", place(pit)},
          {"glottis_centre", place(manikin::kGlottisCentre)},
          {"glottis_normal", {0.0, manikin::kGlottisNormal.u, manikin::kGlottisNormal.v}},
          {"carina", place(carina(v))},
          {"operator_eye", {0.0, data_->scale * data_->eye.y, data_->scale * data_->eye.z}},
          {"hyoid", place({22.5, -41.5})},
          {"epiglottis_tip", place(tip)},
          {"condyle_axis", place(manikin::kCondyle)}};
}

std::vector<Point> Manikin::glottis_outline() const {
  std::vector<Point> points;
  constexpr int kSide = 12;
  const auto at = [&](double along, double across) {
    const Flat& a = manikin::kAnteriorCommissure;
    const Flat& b = manikin::kPosteriorCommissure;
    points.push_back(data_->placed({across, a.u + along * (b.u - a.u), a.v + along * (b.v - a.v)}));
  };
  for (int i = 0; i <= kSide; ++i) at(i / double{kSide}, manikin::kGlottisHalfWidth * i / kSide);
  for (int i = 1; i < 4; ++i) at(1.0, manikin::kGlottisHalfWidth * (1.0 - 0.5 * i));
  for (int i = kSide; i > 0; --i) at(i / double{kSide}, -manikin::kGlottisHalfWidth * i / kSide);
  return points;
}

}  // namespace vallecula::pipeline

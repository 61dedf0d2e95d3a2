#include "pipeline/manikin/manikin.h"

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

double eye_along(double scale) {
  // Distance t from the glottis with |glottis + t sight| = kEyeDistance, at term scale.
  const double reach = kEyeDistance / scale;
  const double norm2 = kSight.u * kSight.u + kSight.v * kSight.v;
  const double b = (manikin::kGlottisCentre.u * kSight.u + manikin::kGlottisCentre.v * kSight.v) / norm2;
  const double c = (manikin::kGlottisCentre.u * manikin::kGlottisCentre.u +
                    manikin::kGlottisCentre.v * manikin::kGlottisCentre.v - reach * reach) /
                   norm2;
  return -b + std::sqrt(b * b - c);
}

}  // namespace

Manikin::Data::Data(double weight_kg, std::uint64_t seed) : scale(scale_of(weight_kg)), body(manikin::vary(seed)) {
  const double t = eye_along(scale);
  eye = {0.0, manikin::kGlottisCentre.u + t * kSight.u, manikin::kGlottisCentre.v + t * kSight.v};
}

Manikin::Manikin(double weight_kg, std::uint64_t seed) {
  if (!(weight_kg >= kLightest && weight_kg <= kHeaviest))
    throw std::runtime_error("manikin: a weight of " + std::to_string(weight_kg) +
                             " kg is outside 0.6 to 4.5 kg; give a weight in that range");
  data_ = std::make_unique<Data>(weight_kg, seed);
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
  const double s = data_->scale;
  const auto place = [s](const Flat& p) { return Point{0.0, s * p.u, s * p.v}; };
  // Vallecula: the deepest air in the middle that has tongue in front and epiglottis behind.
  Flat pit{29.0, -40.5};
  for (double z = -37.0; z > -44.0; z -= 0.05) {
    double y = 24.0;
    while (y < 33.0 && body.at({0.0, y, z}) != manikin::Matter::airway) y += 0.05;
    double end = y;
    while (end < 36.0 && body.at({0.0, end, z}) == manikin::Matter::airway) end += 0.05;
    if (body.at({0.0, end, z}) != manikin::Matter::epiglottis) break;
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
          {"operator_eye", place({data_->eye.y, data_->eye.z})},
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
    const double s = data_->scale;
    points.push_back({s * across, s * (a.u + along * (b.u - a.u)), s * (a.v + along * (b.v - a.v))});
  };
  for (int i = 0; i <= kSide; ++i) at(i / double{kSide}, manikin::kGlottisHalfWidth * i / kSide);
  for (int i = 1; i < 4; ++i) at(1.0, manikin::kGlottisHalfWidth * (1.0 - 0.5 * i));
  for (int i = kSide; i > 0; --i) at(i / double{kSide}, -manikin::kGlottisHalfWidth * i / kSide);
  return points;
}

}  // namespace vallecula::pipeline

// The property the manikin exists for: the glottis is hidden at rest and seen when the tongue base is lifted.
#include <stdexcept>

#include "pipeline/manikin/manikin_data.h"

namespace vallecula::pipeline {

using manikin::Flat;
using manikin::Matter;
using manikin::Vec;

namespace {

/// Whether it blocks the sight and stays where it is when the tongue is lifted.
bool is_fixed(Matter matter) {
  return matter != Matter::outside && matter != Matter::airway && matter != Matter::tongue &&
         matter != Matter::epiglottis;
}

/// Tongue and epiglottis lifted, everything else at rest. Where tongue and epiglottis lay at rest there is nothing but
/// what has moved there.
class Posed {
 public:
  Posed(const Manikin::Data& data, double lift_mm)
      : data_(data),
        tongue_(tongue_shape(data.body.variation(), lift_mm / data.scale)),
        epiglottis_(epiglottis_shape(data.body.variation(), lift_mm / data.scale)) {}

  bool solid(const Vec& p) const {
    const Vec q = without_larynx(data_.body.variation(), p);
    if (tongue_(q) < 0.0 || epiglottis_(q) < 0.0) return true;
    return is_fixed(data_.body.at(p));
  }

  bool seen(const Vec& unmoved) const {
    const Vec target = with_larynx(data_.body.variation(), unmoved);
    const Vec way = data_.eye - target;
    const double length = norm(way);
    constexpr double kStep = 0.2;
    for (double t = 0.0; t < length; t += kStep) {
      const Vec p = target + (t / length) * way;
      if (p.y < -30.0) break;  // clear of the face
      if (solid(p)) return false;
    }
    return true;
  }

 private:
  const Manikin::Data& data_;
  manikin::Shape tongue_;
  manikin::Shape epiglottis_;
};

/// A point of the glottic opening just above its plane: `along` 0 in front .. 1 behind, `across` -1 .. 1.
Vec glottis_point(double along, double across) {
  const Flat& a = manikin::kAnteriorCommissure;
  const Flat& b = manikin::kPosteriorCommissure;
  constexpr double kAbove = 0.3;
  return {across * along * manikin::kGlottisHalfWidth, a.u + along * (b.u - a.u) + kAbove * manikin::kGlottisNormal.u,
          a.v + along * (b.v - a.v) + kAbove * manikin::kGlottisNormal.v};
}

}  // namespace

double Manikin::glottis_seen(double lift_mm) const {
  const Posed posed(*data_, lift_mm);
  constexpr int kAlong = 14;
  double seen = 0.0;
  double all = 0.0;
  for (int i = 0; i < kAlong; ++i) {
    const double along = (i + 0.5) / kAlong;
    for (const double across : {-0.7, 0.0, 0.7}) {  // the rim itself touches the cords
      all += along;                                 // a strip's area grows with its width
      if (posed.seen(glottis_point(along, across))) seen += along;
    }
  }
  return seen / all;
}

double Manikin::glottis_seen_midline(double lift_mm) const {
  const Posed posed(*data_, lift_mm);
  constexpr int kAlong = 50;
  int seen = 0;
  for (int i = 0; i < kAlong; ++i)
    if (posed.seen(glottis_point((i + 0.5) / kAlong, 0.0))) ++seen;
  return static_cast<double>(seen) / kAlong;
}

double Manikin::sight_clearance(const std::string& part, double lift_mm) const {
  // Measured in the mid-sagittal plane (the arytenoids: in theirs) across the line, as the design's table does: towards
  // back and head (+1) for what bounds the sight from above, towards feet and ceiling (-1) for the lower gum.
  struct Region {
    const char* name;
    double side;
    Flat low;
    Flat high;
    double x = 0.0;
  };
  constexpr Region kRegions[] = {{"upper_lip", 1.0, {-12.0, 2.0}, {-1.5, 10.0}},
                                 {"upper_gum", 1.0, {-1.5, -1.0}, {2.4, 4.0}},
                                 {"hard_palate", 1.0, {4.0, -8.0}, {27.0, 4.0}},
                                 {"soft_palate", 1.0, {27.0, -27.0}, {40.0, -3.0}},
                                 {"nose", 1.0, {-12.0, 12.0}, {4.0, 32.0}},
                                 {"posterior_wall", 1.0, {40.2, -45.0}, {50.0, 0.0}},
                                 {"arytenoids", 1.0, {36.0, -47.0}, {40.0, -42.0}, 1.75},
                                 {"lower_gum", -1.0, {0.5, -26.0}, {6.5, -18.0}}};
  const auto& body = data_->body;
  const Vec centre = with_larynx(body.variation(), {0.0, manikin::kGlottisCentre.u, manikin::kGlottisCentre.v});
  const double length = norm(data_->eye - centre);
  const Vec along = (1.0 / length) * (data_->eye - centre);
  const Vec across{0.0, along.z, -along.y};
  constexpr double kStep = 0.1;
  constexpr double kFar = 30.0;
  const auto on_line = [&](auto&& visit) {
    for (double t = 0.0; t < length; t += kStep) {
      const Vec p = centre + t * along;
      if (p.y < -40.0) break;
      visit(p);
    }
  };

  if (part == "tongue" || part == "epiglottis") {
    const double lift = lift_mm / data_->scale;
    const auto shape =
        part == "tongue" ? tongue_shape(body.variation(), lift) : epiglottis_shape(body.variation(), lift);
    double reach = -kFar;
    on_line([&](const Vec& p) {
      for (double d = kFar; d > reach; d -= kStep)
        if (shape(without_larynx(body.variation(), p + d * across)) < 0.0) reach = d;
    });
    return -reach * data_->scale;
  }
  for (const auto& region : kRegions) {
    if (part != region.name) continue;
    double clear = kFar;
    on_line([&](const Vec& p) {
      for (double d = 0.0; d < clear; d += kStep) {
        const Vec q = p + (region.side * d) * across;
        if (q.y < region.low.u || q.y > region.high.u || q.z < region.low.v || q.z > region.high.v) continue;
        if (is_fixed(body.at({region.x, q.y, q.z}))) clear = d;
      }
    });
    return clear * data_->scale;
  }
  throw std::runtime_error("manikin: no part is called " + part);
}

}  // namespace vallecula::pipeline

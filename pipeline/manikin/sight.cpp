// The property the manikin exists for: the glottis is hidden at rest and seen when the tongue base is lifted.
#include <limits>
#include <stdexcept>

#include "pipeline/manikin/manikin_data.h"

namespace vallecula::pipeline {

using manikin::Flat;
using manikin::Matter;
using manikin::Vec;

namespace {

/// Tongue and epiglottis lifted, everything else at rest. Where tongue and epiglottis lay at rest there is nothing but
/// what has moved there.
class Posed {
 public:
  Posed(const Manikin::Data& data, double lift_mm)
      : data_(data),
        tongue_(tongue_shape(data.body.variation(), lift_mm / data.scale)),
        epiglottis_(epiglottis_shape(data.body.variation(), lift_mm / data.scale)) {}

  bool solid(const Vec& p) const {
    if (tongue_(p) < 0.0 || epiglottis_(p) < 0.0) return true;
    switch (data_.body.at(p)) {
      case Matter::outside:
      case Matter::airway:
      case Matter::tongue:
      case Matter::epiglottis: return false;
      default: return true;
    }
  }

  bool seen(const Vec& target) const {
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
  const auto& body = data_->body;
  const auto& v = body.variation();
  manikin::Shape shape;
  if (part == "tongue") {
    shape = tongue_shape(v, lift_mm / data_->scale);
  } else if (part == "epiglottis") {
    shape = epiglottis_shape(v, lift_mm / data_->scale);
  } else if (part == "soft_palate") {
    shape = body.mouth().soft_palate;
  } else if (part == "arytenoids") {
    shape = body.larynx().arytenoids;
  } else if (part == "upper_gum") {
    shape = body.mouth().upper_gum;
  } else if (part == "lower_gum") {
    shape = body.mouth().lower_gum;
  } else {
    // Parts of the face and of the cavity's wall: distance to anything solid along a stretch, found below.
    const bool known = part == "upper_lip" || part == "nose" || part == "hard_palate" || part == "posterior_wall";
    if (!known) throw std::runtime_error("manikin: no part is called " + part);
    const auto& centre = manikin::kGlottisCentre;
    double best = std::numeric_limits<double>::max();
    const Vec way = data_->eye - Vec{0.0, centre.u, centre.v};
    const double length = norm(way);
    const Vec dir = (1.0 / length) * way;
    const Vec side{0.0, dir.z, -dir.y};  // across the line, to the back and the head
    const auto within = [&](const Vec& p) {
      if (part == "upper_lip") return p.y < -1.0 && p.z < 10.0;
      if (part == "nose") return p.y < 2.0 && p.z >= 12.0;
      if (part == "hard_palate") return p.y > 3.0 && p.y < 27.0 && p.z > -8.0;
      return p.y > 40.0 && p.z > -45.0;
    };
    for (double t = 0.0; t < length; t += 0.1) {
      const Vec base = Vec{0.0, centre.u, centre.v} + t * dir;
      if (base.y < -40.0) break;
      for (double d = 0.0; d < best && d < 40.0; d += 0.05) {
        const Vec p = base + d * side;
        if (!within(p)) continue;
        const Matter m = body.at(p);
        if (m != Matter::airway && m != Matter::outside && m != Matter::tongue && m != Matter::epiglottis) {
          best = d;
          break;
        }
      }
    }
    return best * data_->scale;
  }
  double best = std::numeric_limits<double>::max();
  const Vec centre{0.0, manikin::kGlottisCentre.u, manikin::kGlottisCentre.v};
  const Vec way = data_->eye - centre;
  const double length = norm(way);
  for (double t = 0.0; t < length; t += 0.05) {
    const Vec p = centre + (t / length) * way;
    if (p.y < -40.0) break;
    best = std::min(best, shape(p));
  }
  return best * data_->scale;
}

}  // namespace vallecula::pipeline

#include "pipeline/manikin/body.h"

namespace vallecula::pipeline::manikin {

Label label_of(Matter matter) {
  switch (matter) {
    case Matter::outside:
      return kBackground;
    case Matter::airway:
      return kAirway;
    case Matter::skull:
      return kSkull;
    case Matter::mandible:
      return kMandible;
    case Matter::spine:
      return kSpine;
    case Matter::tongue:
      return kTongue;
    case Matter::epiglottis:
      return kEpiglottis;
    case Matter::soft_palate:
      return kSoftPalate;
    case Matter::larynx:
      return kLarynx;
    case Matter::oesophagus:
      return kOesophagus;
    case Matter::skin:
    case Matter::fat:
    case Matter::hyoid:
      break;
  }
  return kSkin;
}

double hounsfield_of(Matter matter) {
  // Newborn bone is thin and little mineralised; laryngeal cartilage is not calcified at all.
  switch (matter) {
    case Matter::outside:
    case Matter::airway:
      return -1000.0;
    case Matter::skin:
      return 45.0;
    case Matter::fat:
      return -90.0;
    case Matter::skull:
      return 620.0;
    case Matter::mandible:
      return 700.0;
    case Matter::spine:
      return 420.0;
    case Matter::hyoid:
      return 320.0;
    case Matter::tongue:
      return 58.0;
    case Matter::epiglottis:
      return 56.0;
    case Matter::soft_palate:
      return 48.0;
    case Matter::larynx:
      return 60.0;
    case Matter::oesophagus:
      return 44.0;
  }
  return 0.0;
}

Body::Body(const Variation& variation)
    : variation_(variation),
      face_(face_shapes(variation)),
      mouth_(mouth_shapes(variation, face_)),
      larynx_(larynx_shapes(variation)),
      bones_(bone_shapes(variation, mouth_.nasal)),
      tongue_(tongue_shape(variation, 0.0)),
      epiglottis_(epiglottis_shape(variation, 0.0)) {
  // Lip plane: through the foremost points of the two lips. Air in front of it belongs to the room.
  const Flat upper{-5.3, 4.1};
  const Flat lower = with_jaw(variation_, {-3.4, -21.5});
  const double length = std::hypot(lower.u - upper.u, lower.v - upper.v);
  const Flat out{(lower.v - upper.v) / length, -(lower.u - upper.u) / length};
  const auto head = face_.head;
  const auto cavity = mouth_.cavity;
  const auto tongue = tongue_;

  Shape room = cavity;  // air of the cavity that lies outside of the face
  room.distance = [cavity, head, upper, out](const Vec& p) {
    const double d = cavity(p);
    if (d > 1.0) return d;
    const double plane = p.z > 9.0 ? -1.0 : (p.y - upper.u) * out.u + (p.z - upper.v) * out.v;
    return std::max(d, -std::max(head(p), plane));
  };
  // The room: beyond the skin, whose lips are rounded off towards the mouth, and between the lids.
  Shape outside;
  outside.steepest = kGentle;
  const auto aperture = face_.aperture;
  const auto lids = face_.eyelids;
  const auto upper_gum = mouth_.upper_gum;
  const auto lower_gum = mouth_.lower_gum;
  outside.distance = [head, aperture, lids, upper_gum, lower_gum](const Vec& p) {
    const double opening = carve(aperture(p), std::min(upper_gum(p), lower_gum(p)), 1.0);
    return -carve(carve(head(p), opening, 3.6), lids(p), 0.6);
  };
  Shape fat = tongue_;  // thin planes round the part of the tongue that is fastened to the floor of the mouth
  fat.low = fat.low - Vec{1.2, 1.2, 1.2};
  fat.high = fat.high + Vec{1.2, 1.2, 1.2};
  fat.distance = [tongue, cavity](const Vec& p) {
    const double d = tongue(p) - 1.0;
    return d > 0.5 ? d : std::max(d, 1.2 - cavity(p));
  };
  // Whatever the seed, bone lies under skin and mucosa.
  const auto covered = [head, cavity](Shape bone) {
    const auto bare = bone.distance;
    bone.distance = [bare, head, cavity](const Vec& p) {
      const double d = bare(p);
      if (d > 1.0 || p.y > 55.0) return d;  // the brain case is well inside behind the face
      return std::max({d, head(p) + 2.0, 0.8 - cavity(p)});
    };
    return bone;
  };
  tests_ = {{epiglottis_, Matter::epiglottis},
            {tongue_, Matter::tongue},
            {mouth_.soft_palate, Matter::soft_palate},
            {larynx_.arytenoids, Matter::larynx},
            {larynx_.lumen, Matter::airway},
            {larynx_.body, Matter::larynx},
            {room, Matter::outside},
            {cavity, Matter::airway},
            {outside, Matter::outside},
            {covered(bones_.mandible), Matter::mandible},
            {covered(bones_.skull), Matter::skull},
            {bones_.spine, Matter::spine},
            {bones_.hyoid, Matter::hyoid},
            {fat, Matter::fat}};
  static_assert(kTests == 14, "one bit a question");
}

Matter Body::at(const Vec& given, const Open& open) const {
  const Vec p = without_larynx(variation_, given);
  for (int i = 0; i < kTests; ++i)
    if (open[i] && tests_[i].shape(p) < 0.0) return tests_[i].matter;
  return mouth_.oesophagus(p) < 0.0 ? Matter::oesophagus : Matter::skin;
}

bool Body::settle(const Vec& given, double given_radius, Open& open, Matter& matter) const {
  const Vec centre = without_larynx(variation_, given);
  const double radius = variation_.larynx_rise == 0.0 ? given_radius : kLarynxStretch * given_radius;
  bool certain = true;
  for (int i = 0; i < kTests; ++i) {
    if (!open[i]) continue;
    const double reach = tests_[i].shape.steepest * radius;
    const double d = tests_[i].shape(centre);
    if (d > reach) {
      open.reset(i);
    } else if (d < -reach) {
      for (int j = i + 1; j < kTests; ++j) open.reset(j);
      matter = tests_[i].matter;
      if (!certain) return false;
      return true;
    } else {
      certain = false;
    }
  }
  if (!certain) return false;
  const double d = mouth_.oesophagus(centre);
  if (std::abs(d) <= kSteepest * radius) return false;
  matter = d < 0.0 ? Matter::oesophagus : Matter::skin;
  return true;
}

}  // namespace vallecula::pipeline::manikin

#include "gui/session/airway_course.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "gui/session/airway_cuts.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/package_parts.h"

namespace vallecula::gui {

namespace {

using engine::AirwayPart;
using engine::AirwayRing;
using engine::Vec3;

// Lengths are mm of a term infant, times the patient's size.
constexpr double kInlet = 2.5;                            // above the cords and below the arytenoids' tips (ANATOMY)
constexpr double kInletStep = 0.5;                        // between the cuts that are tried for it
constexpr double kJoinedShare = 1.6;                      // of the area of the cut below: the throat has joined it
constexpr double kFar = 1000.0;
constexpr double kCricoidFrom = 4.5, kCricoidTo = 9.0;    // below the cords; nearer to them it is their slit that is cut
constexpr double kCricoidStep = 0.5;                      // between the cuts of which it is the narrowest
constexpr double kCone = 0.4;                             // the elastic cone below the cords gives that much more than it
constexpr double kSpacing = 2.0;                          // of cuts
constexpr double kLeastSpacing = 0.6, kMostSpacing = 3.5; // mm of any patient
constexpr double kMarch = 1.0;                            // from one cut to the next while the way is sought
constexpr double kBronchusWidth = 0.75;                   // of the trachea's (assumed)
constexpr double kBronchusAngle[2] = {30.0 * M_PI / 180, 45.0 * M_PI / 180};  // right, left off the trachea (assumed)
constexpr double kBronchusLength = 20.0, kLeastBronchus = 5.0;                // (assumed); less is not taken for seen
constexpr double kMostAside = 7.0;                        // mm of any patient
constexpr double kGulletFront = 0.5, kGulletSide = 3.0;   // collapsed (assumed)
constexpr double kGulletWalls = 3.5;                      // from the trachea's lumen to the oesophagus' middle (assumed)
constexpr double kGulletLength = 60.0;                    // as far as it is modelled (assumed)
constexpr double kGulletMouth = 3.0, kGulletMouthSide = 5.0;  // half widths of its mouth where none is seen (assumed)
constexpr double kGulletBelow = 3.0, kGulletReach = 15.0;  // of the cricoid, and behind the airway: where it is looked for
constexpr double kGulletSettles = 10.0;                   // below its mouth it lies behind the trachea
// mm that the smoothed surface of a round lumen lies within its wall: of nine manikins of 0.7 to 4.2 kg on voxels of 0.4
// and 0.5 mm the trachea's was 0.066 (0.052 to 0.078) mm within.
constexpr double kWithin = 0.066;

AirwayRing ring(const Outline& outline, const Across& frame, AirwayPart part) {
  AirwayRing r;
  r.centre = outline.centre;
  r.along = frame.along;
  r.left = frame.left;
  r.to_left_m = r.to_right_m = outline.half_left + kWithin;
  r.to_front_m = r.to_back_m = outline.half_front + kWithin;
  r.part = part;
  return r;
}

AirwayRing straight_on(AirwayRing last, const Vec3& centre, const Vec3& along) {
  const Across frame(along);
  last.centre = centre;
  last.along = frame.along;
  last.left = frame.left;
  return last;
}

std::string millimetres(double mm) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f mm", mm);
  return text;
}

/// Works in millimetres; the rings are converted at the end.
class Finder {
 public:
  explicit Finder(const pipeline::PatientPackage& package)
      : package_(package),
        mesh_(mesh_of(surface(package, "airway"))),
        motion_(package),
        size_(size_of(package)),
        spacing_(std::min(kSpacing * size_, kMostSpacing)),
        glottis_(landmark(package, "glottis_centre")),
        carina_(landmark(package, "carina")),
        down_(-landmark(package, "glottis_normal").normalized()) {}

  PatientAirway find() {
    trachea();
    inlet();
    for (std::size_t side = 0; side < 2; ++side) bronchus(side);
    oesophagus();
    auto& course = found_.course;
    for (auto* chain : {&course.airway, &course.bronchi[0], &course.bronchi[1], &course.oesophagus})
      for (AirwayRing& r : *chain) {
        r.larynx_share = r.part == AirwayPart::main_bronchus ? 0.0 : kLarynxShare * motion_.with_larynx(r.centre);
        r.centre *= kMetres;
        for (double* half : {&r.to_left_m, &r.to_right_m, &r.to_front_m, &r.to_back_m}) *half *= kMetres;
      }
    course.airway.back().larynx_share = 0.0;  // where the bronchi begin, which do not move
    course.larynx_body = kHyoidBody;
    return std::move(found_);
  }

 private:
  AirwayRing cords();
  void trachea();
  void inlet();
  void bronchus(std::size_t side);
  void oesophagus();
  /// The outline about a point of the way, or none.
  std::optional<Cut> cut(const Line& way, double s) const {
    return cut_at(mesh_, way.at(s), Across(way.along(s, spacing_)));
  }

  const pipeline::PatientPackage& package_;
  const engine::TriangleMesh mesh_;
  const AnatomyMotion motion_;
  const double size_, spacing_;
  const Vec3 glottis_, carina_, down_;
  PatientAirway found_;
};

/// The outline of the glottis from end to end: its walls are not an ellipse's.
AirwayRing Finder::cords() {
  const Across frame(down_);
  AirwayRing r;
  r.centre = glottis_;
  r.along = frame.along;
  r.left = frame.left;
  r.part = AirwayPart::cords;
  r.to_left_m = r.to_right_m = r.to_front_m = r.to_back_m = 0.0;
  for (const Vec3& p : mesh_of(surface(package_, "glottis")).points) {
    r.to_left_m = std::max(r.to_left_m, frame.left.dot(p - glottis_));
    r.to_right_m = std::max(r.to_right_m, -frame.left.dot(p - glottis_));
    r.to_front_m = std::max(r.to_front_m, frame.front.dot(p - glottis_));
    r.to_back_m = std::max(r.to_back_m, -frame.front.dot(p - glottis_));
  }
  if (!(r.to_left_m > 0 && r.to_right_m > 0 && r.to_front_m > 0 && r.to_back_m > 0))
    throw std::runtime_error("patient '" + package_.name +
                             "': its glottis is not about the landmark glottis_centre; import it again");
  found_.glottis_length_m = kMetres * (r.to_front_m + r.to_back_m);
  return r;
}

void Finder::trachea() {
  const double march = kMarch * size_;
  auto [centres, forked] = follow(mesh_, glottis_, down_, march, [&](const Vec3& at, const Vec3& along) {
    return along.dot(carina_ - at) > march;
  });
  const bool ends = (carina_ - centres.back()).norm() > 3 * march;
  if (ends && centres.size() > 2) centres.pop_back();  // the cut before a lumen's end may be of its round bottom
  const double seen = Line(centres).length();
  if (seen < (kCricoidTo + kMarch) * size_)
    throw std::runtime_error("patient '" + package_.name + "': its airway cannot be followed past the cricoid (" +
                             millimetres(seen) + " below the cords); import a CT that shows the trachea");
  if (ends && !forked)
    found_.assumed.push_back("the airway's surface ends " + millimetres(seen) +
                             " below the cords: from there to the carina the trachea goes straight on as wide as it is");
  // Sideways the carina's place is where the two bronchi part; the way ends in its plane.
  const Vec3 last = (centres.back() - centres[centres.size() - 4]).normalized();
  centres.push_back(ends ? carina_ : Vec3(centres.back() + last * std::max(0.2 * march, last.dot(carina_ - centres.back()))));
  const Line way(smoothed(centres));

  double cricoid = 0.0, narrowest = std::numeric_limits<double>::infinity();
  for (double s = kCricoidFrom * size_; s <= kCricoidTo * size_; s += kCricoidStep * size_) {
    const auto one = cut(way, s);
    if (!one || one->own.area >= narrowest) continue;
    narrowest = one->own.area;
    cricoid = s;
  }
  if (!(cricoid > 0))
    throw std::runtime_error("patient '" + package_.name + "': no cut of its airway lies below the cords; import it again");

  std::vector<AirwayRing>& rings = found_.course.airway;
  rings.push_back(cords());
  const auto stretch = [&](double from, double to, AirwayPart part) {
    const int count = std::max(1, static_cast<int>(std::lround((to - from) / (spacing_))));
    for (int i = 1; i <= count; ++i) {
      const double s = from + (to - from) * i / count;
      const Across frame(way.along(s, spacing_));
      const auto one = s <= seen ? cut(way, s) : std::nullopt;
      const bool fits = one && one->own.area > kLeastShare * narrowest;
      rings.push_back(fits ? ring(one->own, frame, part) : straight_on(rings.back(), way.at(s), frame.along));
      rings.back().part = part;
    }
  };
  stretch(0.0, cricoid, AirwayPart::subglottis);
  rings.back().part = AirwayPart::cricoid;
  const AirwayRing ring_of_cricoid = rings.back();
  found_.cricoid_area_m2 = M_PI * ring_of_cricoid.to_left_m * ring_of_cricoid.to_front_m * kMetres * kMetres;
  for (AirwayRing& r : rings) {
    if (r.part != AirwayPart::subglottis) continue;
    r.to_left_m = r.to_right_m = std::max(r.to_left_m, ring_of_cricoid.to_left_m + kCone * size_);
    r.to_front_m = r.to_back_m = std::max(r.to_front_m, ring_of_cricoid.to_front_m + kCone * size_);
  }
  stretch(cricoid, way.length(), AirwayPart::trachea);
}

/// Above the cords, as far as the lumen is the larynx' own: higher up the throat behind the arytenoids joins it. From
/// there to the inlet it is what lies in front of them, its folds leaning outwards by half a right angle (assumed).
void Finder::inlet() {
  std::vector<AirwayRing>& rings = found_.course.airway;
  const Across frame(down_);
  const auto box_of = [&](const std::vector<Vec3>& outline, double above, double most_side) {
    AirwayRing r = straight_on(rings.front(), glottis_ - above * down_, down_);
    r.part = AirwayPart::vestibule;
    r.to_left_m = r.to_right_m = r.to_front_m = r.to_back_m = 0.0;
    for (const Vec3& p : outline) {
      const double left = frame.left.dot(p - r.centre), forward = frame.front.dot(p - r.centre);
      r.to_left_m = std::min(std::max(r.to_left_m, left), most_side);
      r.to_right_m = std::min(std::max(r.to_right_m, -left), most_side);
      if (std::abs(left) > most_side) continue;
      r.to_front_m = std::max(r.to_front_m, forward);
      r.to_back_m = std::max(r.to_back_m, -forward);
    }
    return r;
  };
  const auto outline_at = [&](double above) {
    for (auto& outline : plane_section(mesh_, glottis_ - above * down_, frame.along))
      if (holds(outline, glottis_, frame.left, frame.front)) return outline;
    return std::vector<Vec3>();
  };
  const double step = kInletStep * size_, top = kInlet * size_;
  double own = 0.0, area = measured(outline_at(0.0), frame.left, frame.front).area;
  for (double above = step; above < top + 0.5 * step; above += step) {
    const double next = measured(outline_at(above), frame.left, frame.front).area;
    if (!(next > 0) || next > kJoinedShare * area) break;
    area = next;
    own = above;
  }
  if (own > 2 * kLeastSpacing) rings.insert(rings.begin(), box_of(outline_at(0.5 * own), 0.5 * own, kFar));
  if (own > kLeastSpacing) rings.insert(rings.begin(), box_of(outline_at(own), own, kFar));
  if (own > top - 0.5 * step) return;
  const AirwayRing below = rings.front();
  const double above = std::clamp(top, own + kLeastSpacing, own + kMostSpacing);
  AirwayRing mouth = box_of(outline_at(above), above, std::max(below.to_left_m, below.to_right_m) + (above - own));
  mouth.to_back_m = below.to_back_m;
  mouth.to_front_m = std::max(mouth.to_front_m, 0.5 * below.to_front_m);
  mouth.to_left_m = std::max(mouth.to_left_m, below.to_left_m);
  mouth.to_right_m = std::max(mouth.to_right_m, below.to_right_m);
  rings.insert(rings.begin(), mouth);
  if (own > 0) return;
  found_.assumed.push_back("no cut above the cords is the larynx' own: its inlet is taken to be as wide as the cords");
}

void Finder::bronchus(std::size_t side) {
  const AirwayRing& last = found_.course.airway.back();
  AirwayRing narrow = found_.course.airway[found_.course.airway.size() / 2];  // the last cuts flare into the bronchi
  for (double* half : {&narrow.to_left_m, &narrow.to_right_m, &narrow.to_front_m, &narrow.to_back_m})
    *half *= kBronchusWidth;
  narrow.part = AirwayPart::main_bronchus;
  const double angle = kBronchusAngle[side], radius = narrow.to_left_m;
  const Vec3 away = (side == 0 ? -1.0 : 1.0) * last.left;
  const Vec3 along = std::cos(angle) * last.along + std::sin(angle) * away;
  // Its axis leaves the trachea's above the carina, so that its inner wall goes through the carina (but for grown-ups,
  // whose branches the tube would not find), and is followed from just below the carina on.
  const double above = std::min(radius / std::sin(angle), kMostAside / std::tan(angle));
  const Vec3 start = last.centre - above * last.along + (above + 0.5 * size_) / std::cos(angle) * along;

  const double step = kMarch * size_, length = kBronchusLength * size_;
  const auto away_from_start = [&](const Vec3& at, const Vec3&) { return (at - start).norm() < length; };
  std::vector<Vec3> centres = follow(mesh_, start, along, step, away_from_start).centres;
  if (centres.size() > 2) centres.pop_back();
  const double seen = Line(centres).length();
  const bool imaged = seen >= kLeastBronchus * size_ && away.dot(centres.back() - last.centre) > radius;
  if (!imaged) centres = {start};
  centres = smoothed(centres);
  const Vec3 onward = imaged ? Vec3((centres.back() - centres[centres.size() - 4]).normalized()) : along;
  if (seen < length) centres.push_back(centres.back() + (length - (imaged ? seen : 0.0)) * onward);
  const Line way(centres);
  std::vector<AirwayRing>& rings = found_.course.bronchi[side];
  const int count = static_cast<int>(std::lround(way.length() / (spacing_)));
  for (int i = 0; i <= count; ++i) {
    const double s = way.length() * i / count;
    const Across frame(way.along(s, spacing_));
    const auto one = imaged && s > 0 && s <= seen ? cut(way, s) : std::nullopt;
    const double area = one ? one->own.area : 0.0, usual = M_PI * narrow.to_left_m * narrow.to_front_m;
    const bool fits = area > kLeastShare * usual && area < kMostShare * usual;
    if (fits) rings.push_back(ring(one->own, frame, AirwayPart::main_bronchus));
    else rings.push_back(straight_on(rings.empty() ? narrow : rings.back(), way.at(s), frame.along));
  }
  if (!imaged)
    found_.assumed.push_back(std::string("the ") + (side == 0 ? "right" : "left") +
                             " main bronchus is not imaged: its angle, width and length are assumed");
}

/// Where the throat behind the larynx ends: the last cut in which it is seen, or the cricoid's level.
void Finder::oesophagus() {
  const auto& airway = found_.course.airway;
  std::vector<Vec3> axis;
  double cricoid = 0.0;
  const AirwayRing* cricoid_ring = nullptr;
  for (const AirwayRing& r : airway) {
    if (r.part == AirwayPart::vestibule) continue;
    axis.push_back(r.centre);
    if (r.part == AirwayPart::cricoid) cricoid = Line(axis).length();
    if (r.part == AirwayPart::cricoid) cricoid_ring = &r;
  }
  const Line way(axis);
  double level = cricoid, behind = cricoid_ring->to_back_m + kGulletWalls * size_, half_front = 0.0;
  bool seen = false;
  for (double s = 0.0; s < cricoid + kGulletBelow * size_; s += kCricoidStep * size_) {
    const Across frame(way.along(s, spacing_));
    const auto one = cut_at(mesh_, way.at(s), frame);
    double area = 0.0, moment = 0.0, deepest = 0.0;
    for (const Outline& o : one ? one->others : std::vector<Outline>()) {
      const Vec3 off = o.centre - way.at(s);
      const double back = -frame.front.dot(off);
      if (back < cricoid_ring->to_back_m || back > kGulletReach * size_ || std::abs(frame.left.dot(off)) > 3 * cricoid_ring->to_left_m)
        continue;
      area += o.area;
      moment += o.area * back;
      deepest = std::max(deepest, o.half_front);
    }
    if (!(area > 0)) continue;
    // Two recesses beside the middle, or one behind it: the mouth is between them.
    level = s;
    behind = moment / area;
    half_front = deepest;
    seen = true;
  }
  if (!seen)
    found_.assumed.push_back("the throat's end behind the larynx is not imaged: the oesophagus' mouth is assumed there");

  // From there behind the trachea, and straight on below the carina.
  std::vector<AirwayRing>& rings = found_.course.oesophagus;
  const double settled = airway[airway.size() / 2].to_back_m + kGulletWalls * size_;
  const int count = static_cast<int>(std::lround(kGulletLength * size_ / spacing_));
  for (int i = 0; i <= count; ++i) {
    const double s = level + i * spacing_;
    const Across frame(way.along(std::min(s, way.length()), spacing_));
    const double share = std::clamp(i * spacing_ / (kGulletSettles * size_), 0.0, 1.0);
    AirwayRing r;
    r.part = AirwayPart::oesophagus;
    r.centre = way.at(s) - (behind + share * (settled - behind)) * frame.front;
    r.along = frame.along;
    r.left = frame.left;
    r.to_front_m = r.to_back_m = i == 0 ? std::max(half_front, kGulletMouth * size_) : kGulletFront * size_;
    r.to_left_m = r.to_right_m = i == 0 ? kGulletMouthSide * size_ : kGulletSide * size_;
    rings.push_back(r);
  }
}

}  // namespace

PatientAirway airway_of(const pipeline::PatientPackage& package) { return Finder(package).find(); }

}  // namespace vallecula::gui

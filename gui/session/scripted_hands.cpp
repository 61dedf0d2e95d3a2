#include "gui/session/scripted_hands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/mesh/soft_mesh.h"
#include "engine/mesh/triangle_bvh.h"
#include "gui/session/operator_frame.h"
#include "gui/session/package_parts.h"

namespace vallecula::gui {

namespace {

using engine::Mat3;
using engine::Quat;
using engine::Vec3;
using pipeline::PatientPackage;

/// A keyframe with the blade's tip at `tip` and the blade passing through `through` (towards the handle), its tongue side
/// turned to the tongue.
device::Keyframe keyframe(const OperatorFrame& frame, double time_s, const Vec3& tip, const Vec3& through) {
  Mat3 axes;
  const Vec3 x = (through - tip).normalized();
  const Vec3 z = (frame.lift - frame.lift.dot(x) * x).normalized();
  axes << x, z.cross(x), z;
  const Quat q(axes);
  device::Keyframe k;
  k.time_s = time_s;
  for (int a = 0; a < 3; ++a) k.position_m[a] = tip[a];
  k.rotation_wxyz = {q.w(), q.x(), q.y(), q.z()};
  return k;
}

/// One line of a plan: time, and along sight, lift and left (term millimetres from the glottis) of the tip and of a point
/// the blade passes through at the mouth.
struct Waypoint {
  double time_s;
  double tip[3];
  double mouth[3];
};

device::Trajectory follow(const OperatorFrame& frame, const std::vector<Waypoint>& plan) {
  std::vector<device::Keyframe> keys;
  for (const Waypoint& w : plan)
    keys.push_back(keyframe(frame, w.time_s, frame.at(w.tip[0], w.tip[1], w.tip[2]), frame.at(w.mouth[0], w.mouth[1], w.mouth[2])));
  return device::Trajectory(std::move(keys));
}

// In at the right corner, over the tongue's right side, behind it, sweep to the left, tip deep into the vallecula, then the
// lift: mostly along the handle, the blade coming level with the line of sight as it rises (from 8 degrees below it: the
// upper gum stands in the way of a blade that is level before), hold while looking, and out the way it came. Of some 100
// plans tried on three manikins one that sees most on each with little on the gums. The epiglottis turns up or it does not, by
// half a millimetre of the tip and by the mesh: a patient's own small change of the plan (Approach) is found by playing when it
// is imported.
const std::vector<Waypoint> kExpert = {
    {0.0, {80, 20, -9.5}, {110, 42, -9.5}}, {1.0, {60, 9, -8.5}, {80, 24, -8.5}},
    {2.0, {42, -2, -7.5}, {54, 7, -7.5}}, {3.0, {30, -11, -5.5}, {50, 4, -6.5}},
    {4.0, {15, -10, -3.5}, {50, 5, -3.5}}, {5.0, {6.75, -10.5, 0.5}, {50, 5, 1}}, {6.0, {3.75, -4.5, 0.5}, {50, 5, 1}},
    {8.0, {4.25, 3.5, 0.5}, {50, 8, 1}}, {10.0, {4.25, 9.5, 0.5}, {50, 11, 1}}, {11.5, {4.25, 9.5, 0.5}, {50, 11, 1}},
    {12.5, {10, -4, 0.5}, {50, 4, 1}}, {13.3, {15, -10, -1.5}, {50, 5, -3.5}},
    {14.0, {30, -11, -4.5}, {50, 4, -5.5}}, {14.8, {44, -1, -7.5}, {56, 8, -7.5}},
    {16.0, {80, 20, -9.5}, {110, 42, -9.5}},
};

constexpr double kLiftHeldUntil = 11.5;  // s, of kExpert

/// The plan with the tip where this patient's approach has it: from the way into the vallecula to the end of the lift.
std::vector<Waypoint> adapted(std::vector<Waypoint> plan, const pipeline::Approach& approach) {
  constexpr double kIn = 4.5, kOut = 12.0;  // s: the blade is in the vallecula, or lifted, between these
  for (Waypoint& w : plan) {
    if (w.time_s < kIn || w.time_s > kOut) continue;
    w.tip[0] += approach.along_mm;
    w.tip[1] += approach.lift_mm;
  }
  return plan;
}

// Where the manikin's vallecula lies from its glottis (ANATOMY), along the sight and the lift, and how much farther off
// it is another plan (term mm; assumed: infants vary by less).
constexpr double kValleculaAlong = 7.9, kValleculaLift = -0.5, kElsewhere = 2.0;

// Straight in over the middle, turns the blade about the upper gum instead of lifting, and presses on past what the
// device can give.
const std::vector<Waypoint> kNovice = {
    {0.0, {84, 4, -2}, {110, 4, -2}},  {1.0, {62, 2, 0}, {90, 3, 0}},        {2.2, {44, -3, 0}, {62, 0, 0}},
    {3.4, {26, -7, 0}, {56, -1, 0}},   {5.0, {12, -5, 0}, {56, 0, 0}},       {7.0, {12, 1, 0}, {56, -4, 0}},
    {9.0, {12, 2, 0}, {56, -4, 0}},    {11.0, {14, 24, 0}, {56, 16, 0}},     {12.5, {14, 24, 0}, {56, 16, 0}},
    {15.0, {20, -5, 0}, {58, 0, 0}},   {16.5, {46, -2, 0}, {66, 1, 0}},      {18.0, {84, 4, -2}, {110, 4, -2}},
};

constexpr double kInVallecula = 6.0, kOutOfIt = 12.5;  // s, of kExpert: from the last point before the lift to the way out

// Faults, each of the expert's plan as this patient has it.
std::vector<Waypoint> levering(std::vector<Waypoint> plan) {
  for (Waypoint& w : plan)  // the handle comes down as far as it should have gone up
    if (w.time_s > kInVallecula && w.time_s < kOutOfIt) w.mouth[1] = w.time_s < 9.0 ? -1.0 : -7.0;
  return plan;
}

std::vector<Waypoint> too_far(std::vector<Waypoint> plan) {
  for (Waypoint& w : plan) {
    if (w.time_s < 4.5 || w.time_s > kOutOfIt) continue;
    const bool on_the_way = w.time_s < 5.5 || w.time_s > 12.0;
    w.tip[0] = on_the_way ? 2.0 : -7.0;
    w.tip[1] = on_the_way ? -10.5 : -9.0;
    w.mouth[1] = 5.0;
  }
  return plan;
}

std::vector<Waypoint> off_midline(std::vector<Waypoint> plan) {
  for (Waypoint& w : plan) {
    if (w.time_s < 3.5 || w.time_s > 13.5) continue;
    w.tip[2] -= 8.0;
    w.mouth[2] -= 4.0;
  }
  return plan;
}

std::vector<Waypoint> forceful(std::vector<Waypoint> plan) {
  constexpr double kHeldLonger = 4.0;  // s
  for (Waypoint& w : plan) {
    if (w.time_s < 5.5) continue;
    if (w.time_s < kOutOfIt) {
      const double harder = w.time_s < kInVallecula + 1.0 ? 0.0 : w.time_s < 9.0 ? 0.5 : 1.0;
      w.tip[0] += 4.0;
      w.tip[1] += 6.0 * harder;
      w.mouth[1] += 3.0 * harder;
    }
    if (w.time_s >= kLiftHeldUntil) w.time_s += kHeldLonger;
  }
  return plan;
}

std::vector<Waypoint> many_tries(const std::vector<Waypoint>& last) {
  constexpr double kTry = 5.6;  // s, with more than a second outside: less would be one entry
  const Waypoint &outside = kExpert[0], &lips = kExpert[1], &mouth = kExpert[2];
  std::vector<Waypoint> plan;
  const auto at = [&plan](double time_s, Waypoint w) {
    w.time_s = time_s;
    plan.push_back(w);
  };
  for (const double from_s : {0.0, kTry}) {
    at(from_s, outside);
    at(from_s + 0.8, lips);
    at(from_s + 1.6, mouth);
    at(from_s + 2.3, {0.0, {32, -9, -6}, {50, 4, -6.5}});
    at(from_s + 3.0, mouth);
    at(from_s + 3.8, lips);
    at(from_s + 4.6, outside);
  }
  for (const Waypoint& w : last) at(w.time_s + 2.0 * kTry, w);
  return plan;
}

/// How much of a blade with this pose would begin inside something: points along both edges that lie in the tongue (which
/// count double) or in anatomy that stops the blade.
int points_inside(const engine::TriangleBvh& tongue, const engine::TriangleBvh& face, const std::vector<std::uint8_t>& classes,
                  const Vec3& tip, const Mat3& axes) {
  constexpr double kLength = 0.075, kHalfWidth = 0.005, kSpacing = 0.003, kDeep = 0.03, kWeb = 0.006,
                   kNear = 0.0005;
  int inside = 0;
  for (double x = kSpacing; x < kLength; x += kSpacing)
    for (const auto& [y, z] : {std::pair{-kHalfWidth, 0.0}, {kHalfWidth, 0.0}, {-kHalfWidth, -kWeb}}) {
      const Vec3 p = tip + axes * Vec3(x, y, z);
      if (tongue.signed_distance(p, kDeep) < kNear) inside += 2;
      engine::TriangleBvh::Hit hit;
      if (face.signed_distance(p, kDeep, &hit) < 0 && hit.triangle >= 0) {
        const auto tissue = static_cast<pipeline::Tissue>(classes[hit.triangle]);
        inside += tissue == pipeline::Tissue::gum || tissue == pipeline::Tissue::palate || tissue == pipeline::Tissue::larynx;
      }
    }
  return inside;
}

/// Presses the tongue's dorsum with the blade's tip where it has room to: start off the surface, press 3.5 mm deep
/// (scaled), hold, withdraw. Works in a closed mouth too, for it starts inside: of all free places on the dorsum and all
/// ways to hold the blade there it takes one that begins inside as little as can be.
device::Trajectory press(const PatientPackage& package, const OperatorFrame& frame) {
  constexpr double kClear = 0.0015, kDepth = 0.0035;
  constexpr double kFacesBack = -0.75;       // cosine between a dorsal normal and the lift
  constexpr int kPlaces = 40, kTurns = 12;
  engine::TriangleMesh tongue;
  for (const auto& p : package.tongue.points) tongue.points.push_back(Vec3(p[0], p[1], p[2]) * kMetres);
  const engine::SoftSurface skin = engine::extract_surface(package.tongue.tets);
  tongue.triangles = skin.triangles;
  const auto face = package.surfaces.find("face");
  if (face == package.surfaces.end() || face->second.tissue.size() != face->second.triangles.size())
    throw std::runtime_error("patient '" + package.name + "': it has no whole surface 'face'; import it again");
  engine::TriangleMesh rigid;
  for (const auto& p : face->second.points) rigid.points.push_back(Vec3(p[0], p[1], p[2]) * kMetres);
  rigid.triangles = face->second.triangles;
  const engine::TriangleBvh tongue_bvh(tongue), face_bvh(rigid);

  std::vector<std::pair<Vec3, Vec3>> places;  // centre and normal of free dorsal faces
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    const auto& k = skin.triangles[t];
    const Vec3 n = tongue_bvh.triangle_normal(static_cast<int>(t));
    if (package.tongue.tissue[skin.tet[t]] != 0 || n.dot(frame.lift) > kFacesBack) continue;
    if (package.tongue.anchor[k[0]] != 0 || package.tongue.anchor[k[1]] != 0 || package.tongue.anchor[k[2]] != 0) continue;
    places.emplace_back((tongue.points[k[0]] + tongue.points[k[1]] + tongue.points[k[2]]) / 3, n);
  }
  if (places.empty()) throw std::runtime_error("patient '" + package.name + "': no free dorsum was found on the tongue to press");
  Vec3 spot = Vec3::Zero(), normal = Vec3::UnitZ();
  Mat3 axes = Mat3::Identity();
  int least = std::numeric_limits<int>::max();
  const std::size_t stride = std::max<std::size_t>(1, places.size() / kPlaces);
  for (std::size_t i = 0; i < places.size(); i += stride)
    for (int turn = 0; turn < kTurns; ++turn)
      for (double elevation : {0.15, 0.5, 0.9}) {
        const auto& [place, n] = places[i];
        const Vec3 across = Eigen::AngleAxisd(2 * M_PI * turn / kTurns, n) * n.unitOrthogonal();
        const Vec3 x = std::cos(elevation) * across + std::sin(elevation) * n;
        const Vec3 z = (-n + n.dot(x) * x).normalized();
        Mat3 candidate;
        candidate << x, z.cross(x), z;
        const int inside = points_inside(tongue_bvh, face_bvh, face->second.tissue, place + kClear * n, candidate);
        if (inside >= least) continue;
        least = inside;
        spot = place;
        normal = n;
        axes = candidate;
      }
  const Vec3 n = normal;
  const Quat q(axes);
  std::vector<device::Keyframe> keys;
  const double depth = kDepth * frame.size;
  for (const auto& [time, off] : {std::pair{0.0, kClear}, {1.5, -depth}, {3.0, -depth}, {4.5, kClear}, {5.0, kClear}}) {
    device::Keyframe k;
    k.time_s = time;
    const Vec3 tip = spot + off * n;
    for (int a = 0; a < 3; ++a) k.position_m[a] = tip[a];
    k.rotation_wxyz = {q.w(), q.x(), q.y(), q.z()};
    keys.push_back(k);
  }
  return device::Trajectory(std::move(keys));
}

}  // namespace

pipeline::Approach usual_approach(const PatientPackage& package) {
  if (package.approach.along_mm != 0.0 || package.approach.lift_mm != 0.0) return package.approach;
  const OperatorFrame frame(package);
  const Vec3 vallecula = (kMetres * landmark(package, "vallecula") - frame.origin) / (kMetres * frame.size);
  const double along = vallecula.dot(frame.sight) - kValleculaAlong;
  const double lift = vallecula.dot(frame.lift) - kValleculaLift;
  if (std::hypot(along, lift) < kElsewhere) return package.approach;
  return {along, lift};
}

device::Trajectory expert_laryngoscopy(const PatientPackage& package, double hold_until_s) {
  std::vector<Waypoint> plan = adapted(kExpert, package.approach);
  for (Waypoint& w : plan)
    if (w.time_s > kLiftHeldUntil) {
      // Past the tube, which lies in the right corner: out over the middle.
      w.tip[2] = w.mouth[2] = 1.0;
    }
  for (Waypoint& w : plan)
    if (w.time_s >= kLiftHeldUntil) w.time_s += std::max(0.0, hold_until_s - kLiftHeldUntil);
  return follow(OperatorFrame(package), plan);
}

device::Trajectory way_to_vallecula(const PatientPackage& package) {
  std::vector<Waypoint> plan = adapted(kExpert, package.approach);
  plan.erase(std::find_if(plan.begin(), plan.end(), [](const Waypoint& w) { return w.time_s > kInVallecula; }), plan.end());
  for (Waypoint& w : plan) w.time_s *= kLeadInS / kInVallecula;
  return follow(OperatorFrame(package), plan);
}

device::Trajectory scripted_hand(const std::string& kind, const PatientPackage& package, const curricula::Scenario&) {
  const OperatorFrame frame(package);
  const std::vector<Waypoint> expert = adapted(kExpert, package.approach);
  if (kind == "expert") return follow(frame, expert);
  if (kind == "levers") return follow(frame, levering(expert));
  if (kind == "too-far") return follow(frame, too_far(expert));
  if (kind == "off-midline") return follow(frame, off_midline(expert));
  if (kind == "forceful") return follow(frame, forceful(expert));
  if (kind == "many-tries") return follow(frame, many_tries(expert));
  if (kind == "novice") return follow(frame, kNovice);
  if (kind == "press") return press(package, frame);
  throw std::runtime_error("scripted hand '" + kind + "' is not known; there are expert, novice, press, levers, too-far, "
                           "off-midline, forceful and many-tries, or a trajectory file (.csv)");
}

}  // namespace vallecula::gui

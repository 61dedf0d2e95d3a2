#include "gui/session/scripted_hands.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/mesh/soft_mesh.h"
#include "engine/mesh/triangle_bvh.h"

namespace vallecula::gui {

namespace {

using engine::Mat3;
using engine::Quat;
using engine::Vec3;
using pipeline::PatientPackage;

constexpr double kMetres = 0.001;
constexpr double kTermSize = 0.0503;  // m, upper gum to vallecula of the term manikin

Vec3 landmark(const PatientPackage& package, const char* name) {
  const auto found = package.landmarks.find(name);
  if (found == package.landmarks.end())
    throw std::runtime_error("patient '" + package.name + "': it has no landmark '" + name + "'; import it again");
  return Vec3(found->second[0], found->second[1], found->second[2]) * kMetres;
}

/// The operator's own axes in a patient, origin at the glottis: `sight` towards the eye, `lift` across it towards the
/// tongue (the way a right lift goes: CLINICAL.md, along the handle), `left` to the patient's left.
struct OperatorFrame {
  explicit OperatorFrame(const PatientPackage& package) {
    origin = landmark(package, "glottis_centre");
    left = Vec3::UnitX();
    const Vec3 to_eye = landmark(package, "operator_eye") - origin;
    sight = (to_eye - to_eye.x() * left).normalized();
    lift = left.cross(sight);
    size = (landmark(package, "vallecula") - landmark(package, "upper_gum_midline")).norm() / kTermSize;
  }
  /// Millimetres of a term infant along sight, lift and left, scaled to this one.
  Vec3 at(double along_sight, double along_lift, double to_left) const {
    return origin + kMetres * size * (along_sight * sight + along_lift * lift + to_left * left);
  }
  Vec3 origin, sight, lift, left;
  double size = 1.0;
};

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

// In at the right corner, over the tongue's right side, behind it, sweep to the left, tip into the vallecula, lift along
// the handle without turning, hold while looking, and out the way it came. Found on the term manikin (seed 1), by trying
// how far along and across the line of sight the tip must come for the epiglottis to turn out of the way.
const std::vector<Waypoint> kExpert = {
    {0.0, {80, 20, -10}, {110, 42, -10}}, {1.0, {60, 9, -9}, {80, 24, -9}},    {2.0, {42, -2, -8}, {54, 7, -8}},
    {3.0, {30, -11, -6}, {50, 4, -7}},    {4.0, {15, -10, -4}, {50, 5, -4}},   {5.0, {11, -8, 0}, {50, 5, 0.5}},
    {6.0, {8, -1, 0}, {50, 5, 0.5}},      {8.0, {9, 7, 0}, {50, 8, 0.5}},      {10.0, {9, 10.5, 0}, {50, 10, 0.5}},
    {11.5, {9, 10.5, 0}, {50, 10, 0.5}},  {12.5, {10, -4, 0}, {50, 4, 0.5}},   {13.3, {15, -10, -2}, {50, 5, -4}},
    {14.0, {30, -11, -5}, {50, 4, -6}},   {14.8, {44, -1, -8}, {56, 8, -8}},   {16.0, {80, 20, -10}, {110, 42, -10}},
};

// Straight in over the middle, turns the blade about the upper gum instead of lifting, and presses on past what the
// device can give.
const std::vector<Waypoint> kNovice = {
    {0.0, {84, 4, -2}, {110, 4, -2}},  {1.0, {62, 2, 0}, {90, 3, 0}},        {2.2, {44, -3, 0}, {62, 0, 0}},
    {3.4, {26, -7, 0}, {56, -1, 0}},   {5.0, {12, -5, 0}, {56, 0, 0}},       {7.0, {12, 1, 0}, {56, -4, 0}},
    {9.0, {12, 2, 0}, {56, -4, 0}},    {11.0, {14, 24, 0}, {56, 16, 0}},     {12.5, {14, 24, 0}, {56, 16, 0}},
    {15.0, {20, -5, 0}, {58, 0, 0}},   {16.5, {46, -2, 0}, {66, 1, 0}},      {18.0, {84, 4, -2}, {110, 4, -2}},
};

/// Presses the back of the tongue's dorsum, where it has the most room before it: start off the surface, press 3.5 mm deep
/// (scaled), hold, withdraw. Works in a closed mouth too, for it starts inside.
device::Trajectory press(const PatientPackage& package, const OperatorFrame& frame) {
  constexpr double kClear = 0.0015, kDepth = 0.0035;
  std::vector<Vec3> nodes;
  for (const auto& p : package.tongue.points) nodes.push_back(Vec3(p[0], p[1], p[2]) * kMetres);
  const engine::SoftSurface skin = engine::extract_surface(package.tongue.tets);
  std::vector<Vec3> normals(nodes.size(), Vec3::Zero());
  std::vector<char> tongue(nodes.size(), 0);
  Vec3 centre = Vec3::Zero();
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    const auto& k = skin.triangles[t];
    const Vec3 n = (nodes[k[1]] - nodes[k[0]]).cross(nodes[k[2]] - nodes[k[0]]);
    for (int v : k) {
      normals[v] += n;
      tongue[v] = package.tongue.tissue[skin.tet[t]] == 0 ? 1 : 0;
    }
  }
  for (const Vec3& p : nodes) centre += p / static_cast<double>(nodes.size());

  const auto face = package.surfaces.find("face");
  if (face == package.surfaces.end()) throw std::runtime_error("patient '" + package.name + "': it has no surface 'face'");
  engine::TriangleMesh rigid;
  for (const auto& p : face->second.points) rigid.points.push_back(Vec3(p[0], p[1], p[2]) * kMetres);
  rigid.triangles = face->second.triangles;
  const engine::TriangleBvh bvh(rigid);
  // The dorsum faces away from the lift; of its free nodes near the midline, take the one with the most room before it.
  int best = -1;
  double best_room = -1.0;
  constexpr double kMidline = 0.006, kFarEnough = 0.010;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!tongue[i] || package.tongue.anchor[i] != 0 || normals[i].squaredNorm() == 0) continue;
    const Vec3 n = normals[i].normalized();
    if (n.dot(frame.lift) > -0.6 || std::abs((nodes[i] - centre).dot(frame.left)) > kMidline * frame.size) continue;
    const double room = bvh.closest(nodes[i] + 0.003 * n, kFarEnough).distance;
    if (room > best_room) {
      best_room = room;
      best = static_cast<int>(i);
    }
  }
  if (best < 0) throw std::runtime_error("patient '" + package.name + "': no free dorsum was found on the tongue to press");
  const Vec3 n = normals[best].normalized();
  // The blade lies flat on the spot, its tip a centimetre beyond it, its handle end towards the operator.
  const Vec3 along = (frame.sight - frame.sight.dot(n) * n).normalized();
  const Vec3 spot = nodes[best] - 0.006 * frame.size * along;
  Mat3 axes;
  axes << along, (-n).cross(along), -n;
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

device::Trajectory scripted_hand(const std::string& kind, const PatientPackage& package, const curricula::Scenario&) {
  const OperatorFrame frame(package);
  if (kind == "expert") return follow(frame, kExpert);
  if (kind == "novice") return follow(frame, kNovice);
  if (kind == "press") return press(package, frame);
  throw std::runtime_error("scripted hand '" + kind + "' is not known; there are expert, novice and press, or a trajectory file (.csv)");
}

}  // namespace vallecula::gui

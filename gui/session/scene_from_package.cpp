#include "gui/session/scene_from_package.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/mesh/triangle_bvh.h"
#include "engine/tool/miller_blade.h"
#include "gui/session/anatomy_motion.h"
#include "gui/session/intubation_of.h"
#include "gui/session/operator_axes.h"
#include "gui/session/package_parts.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;
using pipeline::Anchor;
using pipeline::PatientPackage;
using pipeline::Tissue;

// Springs that hold hyoid and mandible (DESIGN 4.1: the hyoid follows 0.3-0.4 of the lift). No measured stiffness was
// found; these were tried out on the term manikin and scale with the infant's size.
constexpr double kHyoidStiffness = 80.0;    // N/m
constexpr double kLarynxStiffness = 35.0;    // N/m
constexpr double kMandibleStiffness = 0.6;   // N m/rad about the condyles
// The floor under the tongue: no measured stiffness was found; with the hinge alone a lift, which passes within 2 mm of
// the condyles' axis, moves the jaw by nothing and crushes the tongue.
constexpr double kFloorStiffness = 250.0;    // N/m
constexpr double kFloorMass = 0.015;         // kg (assumed)
constexpr double kBoneReach = 0.0025;        // m: nodes nearer to the mandible hang on it
constexpr double kLigamentYoung = 6000.0;    // Pa, thyroepiglottic ligament at the small strains of a hinge (assumed)
constexpr double kMandibleStop = 0.2;        // rad: the mouth is imaged open; farther than this it hardly goes (assumed)
// Lips give by their thickness over their modulus: 15 kPa over 6 mm of it (assumed), under a skin's tension that carries a dent
// 2 mm to the side (assumed); a third of a stretch is left after 0.15 s (assumed).
constexpr double kLipBed = 15000.0 / 0.006;  // Pa/m
constexpr double kLipTension = kLipBed * 0.002 * 0.002;  // N/m
constexpr double kLipRecovery = 0.15;        // s
constexpr double kBodyDampingRatio = 1.0;    // critically damped (assumed)
constexpr double kHyoidMass = 0.010;         // kg, with the muscles that hang on it (assumed)
constexpr double kMandibleMass = 0.030;      // kg (assumed)
// The joint between skull and neck, behind and below the condyles of the jaw (assumed; no landmark has it).
constexpr double kNeckBehind = 0.013, kNeckBelow = 0.006;  // m, term
constexpr double kHyoidWithHead = 0.5;       // share of the head's turn (assumed)

Vec3 metres(const pipeline::Point& p) { return Vec3(p[0], p[1], p[2]) * kMetres; }

Vec3 landmark_m(const PatientPackage& package, const char* name) { return landmark(package, name) * kMetres; }

engine::Structure structure_of(std::uint8_t tissue) {
  switch (static_cast<Tissue>(tissue)) {
    case Tissue::gum: return engine::Structure::gum;
    case Tissue::palate: return engine::Structure::palate;
    case Tissue::larynx: return engine::Structure::larynx;
    case Tissue::skin:
    case Tissue::lip:
    case Tissue::mucosa: break;  // they yield: see LipDescription for the lips; cheeks do not resist
  }
  return engine::Structure::other;
}

engine::SoftBodyDescription soft_body(const PatientPackage& package, const curricula::Scenario& scenario) {
  engine::SoftBodyDescription soft;
  for (const auto& p : package.tongue.points) soft.nodes.push_back(metres(p));
  soft.tets = package.tongue.tets;
  for (std::uint8_t tissue : package.tongue.tissue) {
    soft.tet_material.push_back(tissue);
    soft.tet_structure.push_back(tissue == 0 ? engine::Structure::tongue : engine::Structure::epiglottis);
  }
  for (const char* name : {"tongue", "epiglottis"}) {
    const auto found = package.materials.find(name);
    if (found == package.materials.end())
      throw std::runtime_error("patient '" + package.name + "': it has no material '" + name + "'; import it again");
    soft.materials.push_back({found->second.young_pa, found->second.poisson, found->second.density_kg_m3});
  }
  if (scenario.tongue_young_pa > 0) soft.materials[0].young_pa = scenario.tongue_young_pa;

  // The epiglottis hangs on the larynx by the thyroepiglottic ligament, a hinge, not by its cartilage: the tetrahedra at
  // that anchor are ligament, as soft as the tongue. Clamped cartilage would not turn forward under a right lift.
  soft.materials.push_back({kLigamentYoung, soft.materials[1].poisson, soft.materials[1].density_kg_m3});
  for (std::size_t t = 0; t < soft.tets.size(); ++t)
    for (int v : soft.tets[t])
      if (soft.tet_structure[t] == engine::Structure::epiglottis &&
          static_cast<Anchor>(package.tongue.anchor[v]) == Anchor::larynx)
        soft.tet_material[t] = 2;

  const Vec3 condyles = landmark_m(package, "condyle_axis");
  const double size = size_of(package);
  const double stiffer = soft.materials[0].young_pa / 6000.0;  // a stiffer tongue is taken to hang in stiffer muscles
  const auto damped = [](engine::SprungBody body) {
    body.damping = 2 * kBodyDampingRatio * std::sqrt(body.stiffness * body.inertia);
    return body;
  };
  engine::SprungBody mandible;
  mandible.motion = engine::SprungBody::Motion::hinge;
  mandible.pivot = condyles;
  mandible.axis = Vec3::UnitX();
  mandible.stiffness = kMandibleStiffness * stiffer * size * size * size;
  mandible.stop = kMandibleStop;
  const double reach = (landmark_m(package, "lower_gum_midline") - condyles).norm();
  mandible.inertia = kMandibleMass * size * size * size * reach * reach / 3;
  engine::SprungBody hyoid;
  hyoid.motion = engine::SprungBody::Motion::translation;
  hyoid.stiffness = kHyoidStiffness * stiffer * size;
  hyoid.inertia = kHyoidMass * size * size * size;
  // Where the epiglottis hangs on the larynx, it gives way.
  engine::SprungBody larynx;
  larynx.motion = engine::SprungBody::Motion::translation;
  larynx.stiffness = kLarynxStiffness * stiffer * size;
  larynx.inertia = kHyoidMass * size * size * size;
  // The floor of the mouth is muscle slung from bone to bone: what lies against it and not against bone gives way as a whole.
  engine::SprungBody floor;
  floor.motion = engine::SprungBody::Motion::translation;
  floor.stiffness = kFloorStiffness * stiffer * size;
  floor.inertia = kFloorMass * size * size * size;
  soft.bodies = {damped(mandible), damped(hyoid), damped(larynx), damped(floor)};
  const engine::TriangleBvh bone(mesh_of(surface(package, "mandible"), kMetres));
  for (std::uint8_t anchor : package.tongue.anchor) {
    switch (static_cast<Anchor>(anchor)) {
      case Anchor::free: soft.node_anchor.push_back(-1); break;
      case Anchor::mandible: {
        const Vec3& at = soft.nodes[soft.node_anchor.size()];
        const bool on_bone = bone.closest(at, kBoneReach * size).triangle >= 0;
        soft.node_anchor.push_back(on_bone ? kMandibleBody : kFloorBody);
        break;
      }
      case Anchor::hyoid: soft.node_anchor.push_back(kHyoidBody); break;
      case Anchor::larynx: soft.node_anchor.push_back(kLarynxBody); break;
      default: throw std::runtime_error("patient '" + package.name + "': tongue.vtu has an unknown anchor");
    }
  }
  return soft;
}

/// The lower gum goes with the jaw, the larynx some of the hyoid's way. A gum's triangle belongs to the jaw it is nearer to.
void follow_bodies(const AnatomyMotion& motion, engine::RigidAnatomy& rigid) {
  rigid.parts = {{kMandibleBody, 1.0}, {kHyoidBody, kLarynxShare}};
  for (std::size_t t = 0; t < rigid.surface.triangles.size(); ++t) {
    const auto& corner = rigid.surface.triangles[t];
    const Vec3 middle =
        (rigid.surface.points[corner[0]] + rigid.surface.points[corner[1]] + rigid.surface.points[corner[2]]) / 3;
    std::int8_t part = -1;
    if (rigid.triangle_structure[t] == engine::Structure::gum && motion.with_jaw(middle / kMetres) > 0.5) part = 0;
    if (rigid.triangle_structure[t] == engine::Structure::larynx && motion.with_larynx(middle / kMetres) > 0.5) part = 1;
    rigid.triangle_part.push_back(part);
  }
}

/// Told in the throat's frame, which the scene holds still: the head turns back on the neck, and the hyoid, slung between
/// jaw and neck, goes half of its way (assumed), forward and up. The jaws themselves stay (README).
engine::NeckDescription neck_of(const PatientPackage& package, const engine::SoftBodyDescription& soft) {
  engine::NeckDescription neck;
  neck.joint = landmark_m(package, "condyle_axis") + size_of(package) * Vec3(0, kNeckBehind, -kNeckBelow);
  neck.joint.x() = 0.0;
  neck.axis = -Vec3::UnitX();
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < soft.nodes.size(); ++i)
    if (soft.node_anchor[i] == kHyoidBody) {
      sum += soft.nodes[i];
      ++count;
    }
  // Half the way of the whole arm is the whole way of half the arm.
  if (count > 0) neck.carried = {{kHyoidBody, neck.joint + kHyoidWithHead * (sum / count - neck.joint)}};
  return neck;
}

}  // namespace

engine::SceneDescription scene_from_package(const PatientPackage& package, const curricula::Scenario& scenario) {
  engine::SceneDescription scene;
  scene.soft = soft_body(package, scenario);
  const pipeline::Surface& face = surface(package, "face");
  scene.rigid.surface = mesh_of(face, kMetres);
  for (std::size_t t = 0; t < face.triangles.size(); ++t)
    scene.rigid.triangle_structure.push_back(structure_of(t < face.tissue.size() ? face.tissue[t] : 0));
  const AnatomyMotion motion(package);
  follow_bodies(motion, scene.rigid);
  for (const Vec3& p : motion.lips().points) {
    scene.lips.surface.points.push_back(kMetres * p);
    scene.lips.jaw_share.push_back(static_cast<float>(motion.with_jaw(p)));
  }
  scene.lips.surface.triangles = motion.lips().triangles;
  scene.lips.jaw_body = kMandibleBody;
  scene.lips.bed_pa_m = kLipBed;
  scene.lips.tension_n_m = kLipTension;
  scene.lips.recovery_s = kLipRecovery;
  scene.tool.surface = engine::blade_surface(engine::miller_blade(scenario.blade));
  scene.sight.eye = landmark_m(package, "operator_eye");
  const OperatorAxes axes = operator_axes(package);
  scene.sight.eye_right = axes.right;
  scene.sight.eye_up = axes.up;
  scene.neck = neck_of(package, scene.soft);
  for (const auto& p : surface(package, "glottis").points) scene.sight.glottis_outline.push_back(metres(p));
  scene.sight.occluders = {scene.rigid.surface};
  engine::SightDescription::Follower jaw{kMandibleBody, 0.0, {}}, larynx{kHyoidBody, kLarynxShare, {}};
  for (const Vec3& p : scene.rigid.surface.points) {
    jaw.point_share.push_back(static_cast<float>(motion.with_jaw(p / kMetres)));
    larynx.point_share.push_back(static_cast<float>(kLarynxShare * motion.with_larynx(p / kMetres)));
  }
  scene.sight.followers = {std::move(jaw), std::move(larynx)};
  if (scenario.intubation) scene.intubation = intubation_of(package, scenario);
  return scene;
}

}  // namespace vallecula::gui

// The scene: everything that stays as it is during a trial. What changes is in state.h.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "engine/tube/intubation.h"
#include "engine/types.h"

namespace vallecula::engine {

enum class Response : std::uint8_t { compliant, projection, penalty };
enum class Collision : std::uint8_t { aist, triangles };  ///< sphere tree, or direct tests of primitives (the baseline)
enum class Coverage : std::uint8_t { full, paper };

struct TissueMaterial {
  double young_pa = 6000.0;
  double poisson = 0.45;
  double density_kg_m3 = 1040.0;
};

/// A rigid body that tissue nodes are anchored to, held at rest by springs: motion is linearised about rest
/// (translations here; the mandible's hinge is a rotation about an axis through the condyles).
struct SprungBody {
  enum class Motion : std::uint8_t { fixed, translation, hinge };
  Motion motion = Motion::fixed;
  Vec3 pivot = Vec3::Zero();          ///< hinge: a point of the axis, m
  Vec3 axis = Vec3::UnitX();          ///< hinge: unit axis
  double stiffness = 0.0;             ///< N/m (translation) or N m/rad (hinge)
  double inertia = 0.0;               ///< kg or kg m^2
  double damping = 0.0;               ///< N s/m or N m s/rad
  double stop = 0.0;                  ///< hinge: beyond this angle (rad) it is kStopFactor times as stiff; 0: nowhere
  static constexpr double kStopFactor = 30.0;

  /// Where a point p at rest is carried to by the body's displacement q (translation, or angle in x), as a way from p.
  Vec3 way_of(const Vec3& p, const Vec3& q) const {
    switch (motion) {
      case Motion::translation: return q;
      case Motion::hinge: return q.x() * axis.normalized().cross(p - pivot);
      case Motion::fixed: break;
    }
    return Vec3::Zero();
  }
};

struct SoftBodyDescription {
  std::vector<Vec3> nodes;                     ///< rest positions, m
  std::vector<std::array<int, 4>> tets;        ///< positively oriented
  std::vector<std::uint8_t> tet_material;      ///< index into materials, per tet
  std::vector<Structure> tet_structure;        ///< tongue or epiglottis, per tet
  std::vector<TissueMaterial> materials;
  std::vector<std::int8_t> node_anchor;        ///< -1 free, else index into bodies
  std::vector<SprungBody> bodies;
};

/// A part of the rigid anatomy that moves with a sprung body: all its way, or a share of it.
struct RigidPart {
  int body = -1;       ///< index into SoftBodyDescription::bodies
  double share = 1.0;  ///< above 0, up to 1
};

/// Rigid anatomy: a closed surface whose triangles name what they are. Triangles of `Structure::other` carry no load.
struct RigidAnatomy {
  TriangleMesh surface;
  std::vector<Structure> triangle_structure;
  std::vector<RigidPart> parts;             ///< what moves
  std::vector<std::int8_t> triangle_part;   ///< -1 stands still, else index into parts; empty: all stands still
};

/// The lips and what is about them: a surface under tension on an elastic bed, that the blade moves aside. Its force is part of
/// the model force and of no structure's load. Without points there are none.
struct LipDescription {
  TriangleMesh surface;
  std::vector<float> jaw_share;        ///< per point: of the jaw's motion; empty: none moves
  int jaw_body = -1;                   ///< index into SoftBodyDescription::bodies
  double bed_pa_m = 0.0;               ///< pressure per depth, Pa/m
  double tension_n_m = 0.0;            ///< of the skin, N/m
  double recovery_s = 0.0;             ///< time in which a lip let go comes back by all but a third
};

struct ToolDescription {
  TriangleMesh surface;                ///< closed, in the tool frame, m
  /// Corners of a box in the tool frame, m: soft tissue meets no part of the tool outside it. For tools with a handle, which
  /// stays out of the mouth: a field of all of it at the blade's resolution would take gigabytes.
  Vec3 tissue_low = Vec3::Constant(-std::numeric_limits<double>::infinity());
  Vec3 tissue_high = Vec3::Constant(std::numeric_limits<double>::infinity());
  double mass_kg = 0.08;               ///< virtual mass of the proxy
};

struct SightDescription {
  Vec3 eye = Vec3::Zero();
  Vec3 eye_right = -Vec3::UnitX(), eye_up = -Vec3::UnitY();  ///< the operator's own axes, unit, at right angles
  std::vector<Vec3> glottis_outline;   ///< polygon of the glottic opening, in order
  std::vector<TriangleMesh> occluders; ///< rigid surfaces that can stand in the way (face with mouth and airway walls)
  /// What of this moves with a sprung body, each point by a share of the body's way (0..1).
  struct Follower {
    int body = -1;                     ///< index into SoftBodyDescription::bodies
    double glottis_share = 0.0;
    std::vector<float> point_share;    ///< of the occluders' points, in their order; empty: none moves
  };
  std::vector<Follower> followers;
};

/// Where the head turns on the neck, and what of the neck goes along, in the head's own frame.
struct NeckDescription {
  Vec3 joint = Vec3::Zero();         ///< atlanto-occipital, m
  Vec3 axis = Vec3::UnitX();         ///< unit; a right-handed turn of the neck about it extends the head
  struct Carried {
    int body = -1;                   ///< of SoftBodyDescription::bodies, one that shifts: where it rests goes along
    Vec3 at = Vec3::Zero();          ///< its own place, m
  };
  std::vector<Carried> carried;      ///< empty: extension changes nothing
};

struct HapticSettings {
  double device_limit_n = 7.9;         ///< f_max
  double coupling_stiffness_n_m = 1200.0;
  double coupling_rotation_nm_rad = 3.0;
  double limit_time_s = 0.5;           ///< over the limit for longer: the device is taken as lost
  double force_rate_n_s = 400.0;       ///< bound on the displayed force's change at every transition
};

struct SceneDescription {
  SoftBodyDescription soft;
  RigidAnatomy rigid;
  LipDescription lips;
  ToolDescription tool;
  SightDescription sight;
  NeckDescription neck;
  HapticSettings haptics;
  std::optional<IntubationDescription> intubation;  ///< none: laryngoscopy alone
  bool hold_volume = true;             ///< nearly incompressible tissue as a whole keeps its volume within 1 %
  double friction = 0.0;               ///< Coulomb's coefficient of the tool on the tissue
  Response response = Response::compliant;
  Collision collision = Collision::aist;
  Coverage coverage = Coverage::full;
  double sphere_ratio = 10.0;          ///< AIST: coarse sphere's volume over the mean tetrahedron's (paper 3.1.1)
  int sphere_levels = 2;               ///< AIST: levels of the paper's grid
  bool sphere_distances = false;       ///< `projection`: neighbouring spheres resist being pressed together (paper 3.1)
  double step_s = 0.001;
};

/// What is precomputed from a description; fixed, shared by everyone who steps or replays it.
class Scene;

/// Builds the scene (sphere fill, distance fields, stiffness; about a second). Throws std::invalid_argument with the
/// offending number when the description cannot be simulated.
std::shared_ptr<const Scene> build_scene(const SceneDescription& description);

}  // namespace vallecula::engine

// The way of what the second hand holds, along its whole length: above the laryngeal inlet and the mouth of the
// oesophagus it meets surfaces, from there on it is inside a canal and meets only that, so it can neither break out of
// a windpipe nor step over into the gullet. A canal is a chain of rings; where the tube's axis crosses a ring's plane,
// that ring's wall pushes it towards the middle.
//
// In a tick: find_contacts, the soft tissue's behind them (soft_contacts.h), the rod's step, read_loads.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/contact/rigid_field.h"
#include "engine/contact/skin_field.h"
#include "engine/contact/tissue_contact.h"
#include "engine/contact/tool_field.h"
#include "engine/tube/airway.h"
#include "engine/tube/glottis.h"
#include "engine/tube/intubation_record.h"
#include "engine/tube/tube_design.h"

namespace vallecula::engine {

/// The outside of what is pushed in, near its tip. A bevelled end is the tube cut by a plane: `s` behind the tip there
/// is only what lies beyond a chord, at the tip itself but a point of the rim opposite to where the opening looks.
class TubeOutside {
 public:
  explicit TubeOutside(const TubeDesign& design) noexcept;

  double radius() const noexcept { return radius_; }
  double bevel_length() const noexcept { return bevel_length_; }  ///< m; 0: cut square

  /// How far it reaches from the axis in direction u (unit, across the tube, its frame) at s m behind the tip, and how
  /// that grows with s.
  struct Reach {
    double m, slope;
  };
  Reach reach(const Vec3& u, double s) const noexcept;

  /// Of the tube, m from its tip: where it has its full width from.
  double end_length() const noexcept { return std::max(bevel_length_, radius_); }
  /// Does what touches it there stand before the tip? Those who ask at samples give their spacing: the first one behind
  /// the end stands for some of it.
  bool before_tip(double from_tip_m, double spacing_m) const noexcept { return from_tip_m < end_length() + spacing_m; }

  /// A ball within it, s m behind the tip: how far from the axis, on the side of the tip's point, and its radius.
  struct Ball {
    double aside_m, radius_m;
  };
  Ball ball(double s) const noexcept;
  /// The side of the axis on which the tip's point is, unit, frame of the tip.
  const Vec3& point_side() const noexcept { return point_side_; }

 private:
  double radius_, bevel_length_, steepness_, rounding_;
  Vec3 point_side_;
};

enum class Canal : std::uint8_t { none, airway, oesophagus };

/// The airway's course, the cords and the mouth's front plane, checked, with what a tick needs of them.
class Passage {
 public:
  /// Throws std::invalid_argument naming the number at fault.
  Passage(const AirwayCourse& course, const Glottis& glottis, const Vec3& mouth, const Vec3& mouth_inward,
          const Vec3& mouth_axis = -Vec3::UnitZ(), double mouth_radius_m = 0.0, double mouth_half_width_m = 0.0);

  struct Ring {
    AirwayRing cut;  ///< its axes made exact
    Vec3 front;
    double from_start_m = 0.0;  ///< along the chain's centres, from its first ring
    /// Of the canal's length, m, what this ring's wall stands for: half the way to either neighbour; of the cords and
    /// of an entrance's rim a fixed thickness.
    double before_m = 0.0, after_m = 0.0;

    Vec3 centre(const Vec3& larynx_way) const { return cut.centre + cut.larynx_share * larynx_way; }
    double beyond(const Vec3& x, const Vec3& larynx_way) const { return cut.along.dot(x - centre(larynx_way)); }
  };
  using Chain = std::vector<Ring>;
  /// The airway with one main bronchus (0 right, 1 left), and the oesophagus.
  const Chain& airway(int side) const noexcept { return airway_[static_cast<std::size_t>(side)]; }
  const Chain& oesophagus() const noexcept { return oesophagus_; }
  /// That which holds the tube; of the airway's two that with the right bronchus, until the tip is past the carina.
  const Chain& chain(Canal canal, int side) const noexcept {
    return canal == Canal::oesophagus ? oesophagus_ : airway_[side == 1 ? 1 : 0];
  }
  int cords() const noexcept { return cords_; }      ///< index of the cords' ring in the airway
  int trachea() const noexcept { return trachea_; }  ///< of the last ring above the trachea: the cricoid
  int carina() const noexcept { return carina_; }    ///< of the last ring before the main bronchi
  double cords_to_carina_m() const noexcept;         ///< along the centres
  const Glottis& glottis() const noexcept { return glottis_; }
  const Vec3& mouth() const noexcept { return mouth_; }
  const Vec3& mouth_inward() const noexcept { return mouth_inward_; }
  /// Is x behind the mouth's front, and no farther from its axis than its radius? What is in a canal need not be.
  bool mouth_holds(const Vec3& x) const noexcept {
    const Vec3 way = x - mouth_;
    const bool bounded = mouth_radius_m_ > 0;
    return way.dot(mouth_inward_) > 0 &&
           !(bounded && way.cross(mouth_axis_).squaredNorm() >= mouth_radius_m_ * mouth_radius_m_);
  }
  /// Does what crosses the mouth's front at x come between its corners?
  bool between_corners(const Vec3& x) const noexcept {
    return !(mouth_half_width_m_ > 0) || std::abs(x.x() - mouth_.x()) <= mouth_half_width_m_;
  }
  int larynx_body() const noexcept { return larynx_body_; }

 private:
  std::array<Chain, 2> airway_;
  Chain oesophagus_;
  int cords_ = 0, trachea_ = 0, carina_ = 0, larynx_body_ = -1;
  Glottis glottis_;
  Vec3 mouth_, mouth_inward_, mouth_axis_;
  double mouth_radius_m_, mouth_half_width_m_;
};

/// Balls along the tube, half a segment apart, that surfaces meet.
constexpr int kTubeBalls = 2 * kTubeSegments + 1;

/// Which nodes are inside which canal, and what the skin has met: all of it between two steps.
struct PassageState {
  PassageState() noexcept { set_rest(); }
  /// Outside, as at the start, or when the hand took the other thing.
  void set_rest() noexcept;

  Canal canal = Canal::none;
  int inside = 0;  ///< so many nodes, from the tip on, are in the canal
  int side = -1;   ///< main bronchus that the tip went into: 0 right, 1 left; -1: it has not passed the carina
  std::array<std::int16_t, kTubeNodes> passed{};  ///< per node inside: index of the last ring it has passed
  /// Per ball along the tube (tube_surfaces.h): how deep it was when the skin met it, m; it resists what comes deeper.
  /// 0 for a ball that came from outside; one that comes from within (from the mouth, or put there) is met where it is.
  std::array<float, kTubeBalls> met_by_skin{};
  static constexpr float kNotMet = 1e9f;
};

/// What there is about it in this tick. What is not finite is taken as not there (or as still), and named.
struct PassageInput {
  Vec3 larynx_way = Vec3::Zero();       ///< displacement of AirwayCourse::larynx_body (translation), m
  Vec3 larynx_velocity = Vec3::Zero();  ///< m/s
  double glottis_opening = 1.0;         ///< GlottisState::opening; below that of rest, muscles hold the cords shut
  const RigidField* rigid = nullptr;    ///< none: no surface
  const PartPoses* parts = nullptr;     ///< with `rigid`
  const SkinField* skin = nullptr;      ///< asked outside of the box of `rigid`; none: no skin there
  const ToolField* blade = nullptr;     ///< none: no blade
  Pose blade_pose;
  Vec3 blade_velocity = Vec3::Zero(), blade_spin = Vec3::Zero();  ///< of the blade's origin, m/s; rad/s
  double friction = 0.1;                                          ///< on wet mucosa
};

/// The skin's: it is felt by the hand and counts for no part of the airway.
constexpr std::uint8_t kLoadOfNothing = 255;

/// What a contact of the tube belongs to.
struct ContactTag {
  std::uint8_t load = kLoadPharynx;  ///< AirwayPart or TubeLoad, or kLoadOfNothing
  bool before_tip = false;           ///< it stands before the tip: its part along the tube is the tip's load
  float larynx_share = 0.0f;         ///< of the reaction that the larynx body bears (walls of canals; surfaces: `part`)
  std::int8_t part = -1;             ///< of RigidField; -1: what stands still, and all that is not its
  Vec3 at = Vec3::Zero();            ///< where surfaces touch, m, world; for RigidField's in the part's rest
};

constexpr int kMostTubeContacts = 1024;  ///< of walls and surfaces; the soft tissue has places of its own behind them

/// The contacts of one tick, for the rod's step. Sized once.
struct TubeContacts {
  std::array<RodContact, kMostTubeContacts + kMostSoftContacts> contact;
  std::array<ContactTag, kMostTubeContacts + kMostSoftContacts> tag;
  int count = 0;
  int left_out = 0;  ///< that found no room

  void clear() noexcept { count = left_out = 0; }
  void add(const RodContact& c, const ContactTag& t) noexcept;
};

enum PassageFault : std::uint32_t {
  kPassageFaultNone = 0,
  kPassageFaultTube = 1u << 0,    ///< the rod was not finite: it meets nothing, and is outside
  kPassageFaultLarynx = 1u << 1,  ///< larynx or cords: taken as at rest, open
  kPassageFaultBlade = 1u << 2,   ///< taken as not there
  kPassageFaultFull = 1u << 3,    ///< more contacts than there is room for
};

/// Follows the nodes into and out of the canals and leaves this tick's contacts in `contacts` (cleared first; those
/// nearly touching are there too, with a depth below 0, so that the rod's implicit step meets them in time). Returns
/// faults. No allocation, lock, I/O or exception.
std::uint32_t find_contacts(const Passage& passage, PassageState& state, const TubeOutside& outside, const Rod& rod,
                            const RodState& tube, const PassageInput& input, double dt_s,
                            TubeContacts& contacts) noexcept;

/// What the rod's step left in the contacts' forces.
struct PassageLoads {
  PassageLoads() noexcept { on_part.fill(Vec3::Zero()); }
  std::array<double, kTubeLoads> loads_n{};  ///< sums of magnitudes by part, as IntubationRecord's
  double tip_load_n = 0.0;                   ///< along the tube, of what stands before its tip
  std::uint8_t tip_against = 255;            ///< index into loads_n of its largest part; 255: nothing
  Wrench on_blade;                           ///< by the tube, about the blade's tip
  Mat6 on_blade_stiffness = Mat6::Zero();    ///< of the springs that push the blade, the tube standing
  Vec3 on_larynx = Vec3::Zero();             ///< by the tube, what the larynx body bears, N
  Mat3 on_larynx_stiffness = Mat3::Zero();   ///< of those springs, likewise, N/m
  /// On the body of each moving part of RigidField, generalized (RigidField::lever's units): to be added to that of
  /// on_larynx where it is the same body.
  std::array<Vec3, kMostRigidParts> on_part;
  std::array<double, kMostRigidParts> on_part_stiffness{};
  /// On the epiglottis and the larynx down to the cords: what the superior laryngeal nerve feels and the vagus answers.
  double vagal_n = 0.0;
  double glottis_n = 0.0;  ///< at the cords or above them within the larynx: what may close them
};

/// After the rod's step. `blade_tip`: PassageInput::blade_pose.position.
PassageLoads read_loads(const RigidField* rigid, const RodState& tube, const Vec3& blade_tip,
                        const TubeContacts& contacts) noexcept;

/// Writes loads_n, tip_load_n and tip_against.
void write_loads(const PassageLoads& loads, IntubationRecord& record) noexcept;

/// The tube's way in: m along it from its tip to where it leaves the canal it is in; 0: it is in none.
double inside_canal_m(const Passage& passage, const PassageState& state, const Rod& rod, const RodState& tube,
                      const Vec3& larynx_way) noexcept;

/// Does the tube lie between the mouth's corners where it first crosses its front, counted from the tip? One that does
/// not cross it is not held against anybody.
bool came_by_mouth(const Passage& passage, const RodState& tube) noexcept;

/// In the mouth is only what came by it; through a cheek there is no way into a canal either.
TipPlace place(const Passage& passage, const PassageState& state, const RodState& tube) noexcept;

/// As IntubationRecord::past_cords_m: of the tip along the airway from the cords, in the oesophagus from its mouth;
/// above the inlet as at the inlet.
double past_cords_m(const Passage& passage, const PassageState& state, const RodState& tube,
                    const Vec3& larynx_way) noexcept;

/// As IntubationRecord::at_mouth_m: m along the tube from the tip to where it first crosses the plane `lips_m` before
/// the mouth's front; 0: the tip is before that.
double at_mouth_m(const Passage& passage, const Rod& rod, const RodState& tube, double lips_m) noexcept;

}  // namespace vallecula::engine

#include "engine/tube/intubation_step.h"

#include <algorithm>
#include <cmath>

#include "engine/state.h"
#include "engine/tube/secretions.h"

namespace vallecula::engine {

namespace {

constexpr double kReturnSpeed = 0.1, kReturnTurn = 1.0;  // m/s, rad/s: of a grip that its hand was lost from
constexpr double kPressRise = 0.3;                       // s, to the whole force and from it (assumed)
constexpr double kBreathEvery = 1.5;                     // s: 40 a minute while the key is down
constexpr double kTouch = 0.02;                          // N: less is not felt by cords and larynx (assumed)

/// From `from` towards `to`, by no more than these; true once it is there.
bool approach(const Pose& to, double most_m, double most_rad, Pose& from) {
  const Vec6 way = move_between(from, to);
  const Vec3 move = way.head<3>(), turn = way.tail<3>();
  if (move.norm() <= most_m && turn.norm() <= most_rad) {
    from = to;
    return true;
  }
  from.position += no_longer_than(move, most_m);
  const double angle = turn.norm();
  if (angle > most_rad)
    from.rotation = (Quat(Eigen::AngleAxisd(most_rad, turn / angle)) * from.rotation).normalized();
  else
    from.rotation = to.rotation;
  return false;
}

/// What the second hand holds hangs undeformed from its grip, and is in no canal.
void put_to_rest(const Intubation& in, const Pose& grip, IntubationState& s) {
  s.rod.set_rest(in.rod(s.in_hand), grip);
  s.passage.set_rest();
  s.soft.forget();
}

/// Where the grip is to be in this step: the hand's place, or where it was left.
Pose take_hand(const Scene& scene, const StepInput& input, IntubationState& s, std::uint32_t& faults) {
  const bool good = usable(input.second);
  if (!good) faults |= kIntubationFaultHandPose;
  if (!input.second_valid) faults |= kIntubationFaultHand;
  if (!good || !hands_there(input)) {
    s.returning = s.placed;
    return s.rod.grip;
  }
  const Pose hand = within_reach(scene, input.second);
  if (!s.placed) {
    s.placed = true;
    put_to_rest(*scene.intubation, hand, s);
  }
  if (!s.returning) return hand;
  Pose grip = s.rod.grip;
  s.returning = !approach(hand, kReturnSpeed * scene.model.step_s, kReturnTurn * scene.model.step_s, grip);
  return grip;
}

/// What the hand holds: the stylet is drawn in the mouth as well, tube and catheter change places outside of it.
void take_tools(const Intubation& in, std::uint32_t actions, const Pose& grip, IntubationState& s) {
  if ((actions & kActionStyletOut) != 0) s.stylet_in = false;
  InHand wanted = s.stylet_in ? InHand::tube_with_stylet : InHand::tube;
  if ((actions & kActionCatheter) != 0 && in.has(InHand::catheter)) wanted = InHand::catheter;
  if (wanted == s.in_hand) return;
  const bool exchange = wanted == InHand::catheter || s.in_hand == InHand::catheter;
  if (exchange && place(in.passage, s.passage, s.rod) != TipPlace::outside) return;
  s.in_hand = wanted;
  if (exchange) put_to_rest(in, grip, s);
}

/// True in the step of a breath that is asked for.
bool breath_due(std::uint32_t actions, double dt, IntubationState& s) {
  if ((actions & kActionBreath) == 0) return false;
  if ((s.actions & kActionBreath) == 0) s.until_breath_s = 0.0;
  s.until_breath_s -= dt;
  if (s.until_breath_s > 0) return false;
  s.until_breath_s += kBreathEvery;
  return true;
}

TubeTip tube_tip(const IntubationRecord& r) {
  if (r.in_hand == InHand::catheter) return TubeTip::none;
  switch (r.place) {
    case TipPlace::oesophagus:
      return TubeTip::oesophagus;
    case TipPlace::trachea:
      return TubeTip::trachea;
    case TipPlace::main_bronchus:
      return TubeTip::main_bronchus;
    case TipPlace::larynx:
      return r.past_cords_m > 0 ? TubeTip::trachea : TubeTip::none;
    default:
      return TubeTip::none;
  }
}

/// How a breath goes in.
Breath way_of_breath(const Passage& passage, const SceneState& scene, const IntubationRecord& r) {
  const bool in_canal = r.place != TipPlace::outside && r.place != TipPlace::mouth;
  if (in_canal) return r.in_hand == InHand::catheter ? Breath::none : Breath::tube;
  const bool blade_in = scene.placed && passage.mouth_holds(scene.proxy.pose.position);
  return blade_in || r.place == TipPlace::mouth ? Breath::none : Breath::mask;
}

/// -1, 0 or 1.
int driven(std::uint32_t actions, Action down, Action up) {
  return static_cast<int>((actions & up) != 0) - static_cast<int>((actions & down) != 0);
}

double load_on(const StepResult& result, Structure structure) {
  return result.loads[static_cast<std::size_t>(structure)].force_n.norm();
}

void step_secretions(const Scene& scene, const IntubationRecord& r, std::uint32_t actions, IntubationState& s) {
  if (r.in_hand != InHand::catheter || (actions & kActionSuction) == 0) return;
  const Intubation& in = *scene.intubation;
  const double flow = drawn(in.description.secretions, s.secretions_m3, r.tip_m, in.design(r.in_hand).inner_diameter);
  s.secretions_m3 = std::max(0.0, s.secretions_m3 - scene.model.step_s * flow);
}

/// Infant and cords: one step each; a breath asked for goes the way that is open.
void step_patient(const Scene& scene, const SceneState& state, std::uint32_t actions, const StepResult& result,
                  const PassageLoads& loads, IntubationState& s, std::uint32_t& fault, const IntubationRecord& r) {
  const Intubation& in = *scene.intubation;
  const double dt = scene.model.step_s;

  InfantInput input;
  input.tip = tube_tip(r);
  if (breath_due(actions, dt, s)) input.breath = way_of_breath(in.passage, state, r);
  if (input.breath == Breath::tube) s.stylet_in = false;
  input.blade_load_n = load_on(result, Structure::epiglottis) + load_on(result, Structure::larynx);
  input.tube_load_n = loads.vagal_n;
  input.glottis_opening = s.glottis.opening;
  input.breathing = in.description.breathes;
  input.drive_saturation = driven(actions, kInstructorSaturationDown, kInstructorSaturationUp);
  input.drive_heart = driven(actions, kInstructorHeartDown, kInstructorHeartUp);
  s.signs = step(in.infant, s.infant, input, dt);

  GlottisInput cords;
  cords.breathing = in.description.breathes;
  cords.breath_phase = s.signs.breath_phase;
  cords.held_closed = (actions & kInstructorSpasm) != 0;
  cords.touched = std::max(loads.glottis_n, load_on(result, Structure::larynx)) > kTouch;
  step(in.description.glottis, s.glottis, cords, dt);
  if ((s.signs.faults & kInfantFaultState) != 0 || (s.glottis.faults & kGlottisFaultState) != 0)
    fault |= kIntubationFaultInfant;
}

void write_signs(const IntubationState& s, IntubationRecord& r) {
  r.secretions_ml = 1e6 * s.secretions_m3;
  r.glottis_opening = s.glottis.opening;
  r.spasm = s.glottis.spasm;
  r.sao2 = s.signs.sao2;
  r.spo2 = s.signs.spo2;
  r.heart_per_min = s.signs.heart_per_min;
  r.detector_yellow = s.signs.detector == DetectorColour::yellow;
  r.breaths_given = s.infant.breaths_given;
  r.given_per_min = s.signs.given_per_min;
}

/// The assistant's force on the larynx for the next step of its body.
void press_larynx(const Scene& scene, std::uint32_t actions, IntubationState& s) {
  const IntubationDescription& d = scene.intubation->description;
  const double most = scene.model.step_s / kPressRise;
  s.press += std::clamp(((actions & kActionPress) != 0 ? 1.0 : 0.0) - s.press, -most, most);
  if (d.course.larynx_body >= 0)
    s.body_load[static_cast<std::size_t>(d.course.larynx_body)] +=
        scene.intubation->larynx_share() * s.press * d.press_n * d.press_direction;
}

/// Farthest of the axis from where it would be undeformed in the hand.
double buckled(const Rod& rod, const RodState& s) {
  const RodState rest(rod, s.grip);
  double most = 0.0;
  for (int i = 0; i < kTubeNodes; ++i) most = std::max(most, (s.position[i] - rest.position[i]).squaredNorm());
  return std::sqrt(most);
}

PassageInput about_tube(const Scene& scene, const SceneState& state) {
  PassageInput about;
  const int larynx = scene.intubation->passage.larynx_body();
  if (larynx >= 0) {
    about.larynx_way = state.tissue.body_displacement[static_cast<std::size_t>(larynx)];
    about.larynx_velocity = state.tissue.body_velocity[static_cast<std::size_t>(larynx)];
  }
  about.glottis_opening = state.intubation->glottis.opening;
  about.rigid = &scene.rigid;
  about.parts = &state.parts;
  about.skin = &scene.skin;
  if (state.placed) about.blade = &scene.tool;
  about.blade_pose = state.proxy.pose;
  about.blade_velocity = state.proxy.velocity;
  about.blade_spin = state.proxy.angular_velocity;
  return about;
}

/// Those with tongue and epiglottis, behind the others.
void add_soft_contacts(const Scene& scene, const TissueState& tissue, const PassageInput& about, IntubationState& s) {
  const Rod& rod = scene.intubation->rod(s.in_hand);
  const auto free = static_cast<std::size_t>(s.contacts.count);
  const double from = inside_canal_m(scene.intubation->passage, s.passage, rod, s.rod, about.larynx_way);
  s.contacts.count += find_soft_contacts(scene, tissue, rod, s.rod, from, about.friction, s.soft,
                                         s.contacts.contact.data() + free, kMostSoftContacts);
  for (int i = 0; i < s.soft.count; ++i) {
    const SoftContact& at = s.soft.found[static_cast<std::size_t>(i)];
    const int tet =
        scene.surface.tet[static_cast<std::size_t>(scene.tree.spheres[static_cast<std::size_t>(at.sphere)].triangle)];
    ContactTag& tag = s.contacts.tag[free + static_cast<std::size_t>(i)];
    tag = ContactTag{};
    tag.load = scene.description.soft.tet_structure[static_cast<std::size_t>(tet)] == Structure::epiglottis
                   ? kLoadEpiglottis
                   : kLoadTongue;
    tag.before_tip = scene.intubation->outside(s.in_hand).before_tip((at.segment + at.weight) * rod.segment_m(),
                                                                     rod.segment_m() / 2);
  }
}

/// What the tube asks of blade and bodies in the next step.
void keep_loads(const Scene& scene, const PassageLoads& loads, IntubationState& s) {
  s.on_blade = loads.on_blade;
  s.on_blade_stiffness = loads.on_blade_stiffness;
  const auto add = [&s](int body, const Vec3& load, double stiffness) {
    s.body_load[static_cast<std::size_t>(body)] += load;
    s.body_load_stiffness[static_cast<std::size_t>(body)] += stiffness;
  };
  const int larynx = scene.intubation->passage.larynx_body();
  // No direction resists more than the largest sum of a row.
  if (larynx >= 0) add(larynx, loads.on_larynx, loads.on_larynx_stiffness.cwiseAbs().rowwise().sum().maxCoeff());
  for (int p = 0; p < scene.rigid.part_count(); ++p)
    add(scene.rigid.body_of(p), loads.on_part[static_cast<std::size_t>(p)],
        loads.on_part_stiffness[static_cast<std::size_t>(p)]);
}

/// Brings what the hand holds through the step, and says where it is and what it presses on.
PassageLoads step_tool(const Scene& scene, const SceneState& state, const Pose& grip, IntubationState& s,
                       IntubationRecord& r) {
  const Intubation& in = *scene.intubation;
  const Rod& rod = in.rod(s.in_hand);
  const double dt = scene.model.step_s;
  const PassageInput about = about_tube(scene, state);
  const std::uint32_t faults =
      find_contacts(in.passage, s.passage, in.outside(s.in_hand), rod, s.rod, about, dt, s.contacts);
  if ((faults & kPassageFaultTube) != 0) r.faults |= kIntubationFaultTube;
  if ((faults & kPassageFaultLarynx) != 0) r.faults |= kIntubationFaultInfant;
  const int first_soft = s.contacts.count;
  add_soft_contacts(scene, state.tissue, about, s);
  const RodStep moved = step(rod, s.rod, grip, s.contacts.contact.data(), s.contacts.count, dt);
  if ((faults & (kPassageFaultBlade | kPassageFaultFull)) != 0 || (moved.faults & kRodFaultContact) != 0 ||
      s.soft.left_out > 0)
    r.faults |= kIntubationFaultContacts;
  if ((moved.faults & kRodFaultState) != 0) {
    r.faults |= kIntubationFaultTube;
    s.passage.set_rest();
    s.soft.forget();
    s.contacts.clear();
  }
  press_tissue(scene, s.rod, s.contacts.contact.data() + first_soft, s.soft);
  const PassageLoads loads = read_loads(&scene.rigid, s.rod, about.blade_pose.position, s.contacts);
  write_loads(loads, r);
  r.model_force_n = moved.on_hand.force;
  r.tip_m = s.rod.position[0];
  r.tip_direction = -(s.rod.rotation[0] * Vec3::UnitX());
  r.place = place(in.passage, s.passage, s.rod);
  r.side = r.place == TipPlace::main_bronchus ? static_cast<std::int8_t>(s.passage.side) : std::int8_t{-1};
  r.past_cords_m = past_cords_m(in.passage, s.passage, s.rod, about.larynx_way);
  r.at_mouth_m =
      r.place == TipPlace::outside ? 0.0 : at_mouth_m(in.passage, rod, s.rod, in.description.lips_before_gums_m);
  r.buckled_m = buckled(rod, s.rod);
  return loads;
}

}  // namespace

IntubationState::IntubationState(const Scene& scene)
    : in_hand(scene.intubation->at_start.in_hand),
      stylet_in(in_hand == InHand::tube_with_stylet),
      rod(scene.intubation->rod(in_hand), Pose{}),
      soft(scene),
      glottis(start(scene.intubation->description.glottis)),
      infant(start(scene.intubation->infant)),
      secretions_m3(scene.intubation->description.secretions.volume_m3),
      body_load(scene.model.bodies.size(), Vec3::Zero()),
      body_load_stiffness(scene.model.bodies.size(), 0.0) {}

void step_intubation(const Scene& scene, SceneState& state, const StepInput& input, StepResult& result) noexcept {
  const Intubation& in = *scene.intubation;
  IntubationState& s = *state.intubation;
  IntubationRecord& r = result.intubation;
  r.hand_pose = input.second;
  r.hand_valid = input.second_valid;
  if (!std::isfinite(s.secretions_m3) || !std::isfinite(s.press) || !std::isfinite(s.until_breath_s)) {
    s.secretions_m3 = in.description.secretions.volume_m3;
    s.press = s.until_breath_s = 0.0;
    r.faults |= kIntubationFaultInfant;
  }
  std::fill(s.body_load.begin(), s.body_load.end(), Vec3::Zero());
  std::fill(s.body_load_stiffness.begin(), s.body_load_stiffness.end(), 0.0);
  const Pose grip = take_hand(scene, input, s, r.faults);
  const bool paused = s.started && !hands_there(input);
  if (!paused) take_tools(in, input.actions, grip, s);
  r.in_hand = s.in_hand;
  PassageLoads loads;
  if (s.placed) loads = step_tool(scene, state, grip, s, r);
  keep_loads(scene, loads, s);
  if (paused) {
    // A trial without one of its hands stands still, and the infant with it: nobody could help it meanwhile.
    press_larynx(scene, s.actions, s);
  } else {
    s.started = true;
    step_secretions(scene, r, input.actions, s);
    step_patient(scene, state, input.actions, result, loads, s, r.faults, r);
    press_larynx(scene, input.actions, s);
    s.actions = input.actions;
  }
  write_signs(s, r);
}

}  // namespace vallecula::engine

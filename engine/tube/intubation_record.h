// What the second half of the procedure takes in and leaves, one tick, as plain numbers: what is recorded and scored.
#pragma once

#include "engine/types.h"

namespace vallecula::engine {

/// What a hand asks for by keys or buttons; held down. Bits of StepInput::actions and TickRecord::buttons.
enum Action : std::uint32_t {
  /// A breath as it goes down, 40 a minute while held: by mask while blade and tube are out of the mouth, by the tube
  /// once its tip is past the inlet or in the oesophagus. The stylet, if it is still in, is drawn for it.
  kActionBreath = 1u << 16,
  kActionSuction = 1u << 17,    ///< with the catheter in the second hand
  kActionPress = 1u << 18,      ///< the assistant presses on the larynx
  kActionStyletOut = 1u << 19,  ///< once it goes down the stylet is out for good
  kActionCatheter = 1u << 20,   ///< while set the second hand has the catheter; it changes outside the mouth only
  // Helps of every scene, with an intubation or without (engine/posture.h).
  kActionEyeRight = 1u << 21,  ///< while set the operator's eye is kEyeMove to that side of his standing place,
  kActionEyeLeft = 1u << 22,   ///< in his own axes: right is the patient's right, up is anterior
  kActionEyeUp = 1u << 23,
  kActionEyeDown = 1u << 24,
  kActionExtend = 1u << 25,  ///< while set the head is extended on the neck by kExtension more: a shoulder roll
  // An instructor's, of the infant: nothing without an intubation.
  kInstructorSaturationDown = 1u << 26,  ///< while set: kDrivenSaturation of the true and the displayed value
  kInstructorSaturationUp = 1u << 27,
  kInstructorHeartDown = 1u << 28,  ///< while set: kDrivenHeart
  kInstructorHeartUp = 1u << 29,
  kInstructorSpasm = 1u << 30,  ///< while set the cords are closed as in a laryngospasm; no effect on relaxed cords
  /// While set the operator is shown an expert's hands, and for a second when an instructor has told a line: recorded,
  /// also in a pause, and nothing to the engine.
  kActionAided = 1u << 31,
};
constexpr std::uint32_t kAllActions = 0x7fffu << 16;  ///< that the engine acts on
constexpr std::uint32_t kEyeActions = kActionEyeRight | kActionEyeLeft | kActionEyeUp | kActionEyeDown;
constexpr std::uint32_t kInstructorActions =
    kInstructorSaturationDown | kInstructorSaturationUp | kInstructorHeartDown | kInstructorHeartUp | kInstructorSpasm;

/// Where the tip of what the second hand holds is. `larynx`: from the inlet to the cricoid.
enum class TipPlace : std::uint8_t { outside, mouth, larynx, trachea, main_bronchus, oesophagus };
enum class InHand : std::uint8_t { tube_with_stylet, tube, catheter };

/// Named faults of the second half, bits.
enum IntubationFault : std::uint32_t {
  kIntubationFaultNone = 0,
  kIntubationFaultHand = 1u << 0,  ///< the second hand's device reports itself unusable: both tools stay where they are
  kIntubationFaultHandPose = 1u << 1,  ///< its pose was not finite or no rotation
  kIntubationFaultTube = 1u << 2,      ///< the tube became non-finite and was put back to rest in the hand
  kIntubationFaultInfant = 1u << 3,    ///< infant, cords, secretions or press became non-finite: back at their start
  kIntubationFaultForce = 1u << 4,     ///< the second hand's force was not finite; zero was sent
  /// Some of what the tube touches was left out: there was no room for it (the shallowest of the tissue's points go
  /// first), or it or the blade's pose was no number.
  kIntubationFaultContacts = 1u << 5,
};

/// Of one tick, as plain numbers: what is recorded.
struct IntubationRecord {
  Pose hand_pose;  ///< second hand's device: where it grips; +x from the tip to the grip, +z concave
  bool hand_valid = true;
  InHand in_hand = InHand::tube;
  Vec3 tip_m = Vec3::Zero();
  Vec3 tip_direction = Vec3::UnitZ();  ///< unit, the way the tip points
  TipPlace place = TipPlace::outside;
  std::int8_t side = -1;  ///< main bronchus that the tip is in: 0 right, 1 left; -1: in none
  /// Of the tip along the airway from the cords, at most 0 above them; in the oesophagus from its mouth.
  double past_cords_m = 0.0;
  double at_mouth_m = 0.0;            ///< the tube's mark at the lips: its length inside of them; 0: outside
  double buckled_m = 0.0;             ///< farthest of its axis from where it would be undeformed in the hand
  Vec3 model_force_n = Vec3::Zero();  ///< on the second hand, world
  Vec3 displayed_force_n = Vec3::Zero();
  /// On the walls by part (AirwayPart's order), then surfaces above: pharynx and mouth, tongue, epiglottis, blade; sums
  /// of magnitudes, N.
  std::array<double, 11> loads_n{};
  double tip_load_n = 0.0;         ///< along the tube, of what stands before its tip
  std::uint8_t tip_against = 255;  ///< index into loads_n of the largest part of it; 255: nothing
  double glottis_opening = 0.0;    ///< 0..1
  bool spasm = false;
  double secretions_ml = 0.0;
  double sao2 = 0.0, spo2 = 0.0;  ///< 0..1; true, displayed
  double heart_per_min = 0.0;
  bool detector_yellow = false;
  std::int32_t breaths_given = 0;
  double given_per_min = 0.0;
  std::uint32_t faults = kIntubationFaultNone;
};
constexpr int kAirwayParts = 7;
enum TubeLoad : int { kLoadPharynx = kAirwayParts, kLoadTongue, kLoadEpiglottis, kLoadBlade, kTubeLoads };

}  // namespace vallecula::engine

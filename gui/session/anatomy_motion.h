// How a patient's surfaces go along with what gives way: the lower jaw's hinge and the larynx below the hyoid. The
// engine's obstacles, what the operator's eye meets and what is drawn take their shares from here. Millimetres, LPS.
#pragma once

#include <optional>

#include "engine/mesh/triangle_bvh.h"
#include "engine/types.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// The larynx' surfaces and the glottis follow the hyoid by this share of its way (assumed: DESIGN has it follow
/// slightly).
constexpr double kLarynxShare = 0.3;

/// Indices of SoftBodyDescription::bodies in a patient's scene.
enum SceneBody { kMandibleBody = 0, kHyoidBody = 1, kLarynxBody = 2, kFloorBody = 3 };

class AnatomyMotion {
 public:
  /// Throws std::runtime_error when the package lacks a surface or landmark that is needed.
  explicit AnatomyMotion(const pipeline::PatientPackage& package);

  /// Share of the mandible's motion that a point of skin, lip, gum or mucosa takes part in: 1 at the bone, the lower
  /// lip and the chin, falling to 0 at the upper lip, the cheeks and the throat.
  double with_jaw(const engine::Vec3& p) const;
  /// Share of the larynx' motion, itself kLarynxShare of the hyoid's: 1 about the glottis, falling to 0 at the back
  /// wall, the tongue's base and down the trachea.
  double with_larynx(const engine::Vec3& p) const;

  /// Where a point of those shares is (mm), for the bodies' displacements of a snapshot.
  engine::Vec3 displaced(const engine::Vec3& p, double with_jaw, double with_larynx,
                         const std::vector<engine::Vec3>& bodies) const;

  /// Lips and the skin about them (mm): the surface whose points the engine's LipDescription has, in its order. Empty
  /// where the package names no lip.
  const engine::TriangleMesh& lips() const { return lips_; }
  /// The place on it within `limit` (mm) of p; triangle -1 where there is none.
  engine::TriangleBvh::Hit on_lips(const engine::Vec3& p, double limit) const;

 private:
  engine::TriangleMesh lips_;
  std::optional<engine::TriangleBvh> lips_bvh_;
  engine::TriangleBvh mandible_, upper_jaw_;
  engine::Vec3 condyles_, glottis_;
  double back_ = 0.0;  ///< y of the glottis' hindmost point
  double size_ = 1.0;  ///< over the term manikin's
};

/// Upper gum to vallecula over the term manikin's: what springs and lengths scale with.
double size_of(const pipeline::PatientPackage& package);

}  // namespace vallecula::gui

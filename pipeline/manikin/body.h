// The manikin's shapes put together: what lies at a point, asked point by point or for a whole block at once.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "pipeline/manikin/shapes.h"
#include "pipeline/package/label_map.h"

namespace vallecula::pipeline::manikin {

/// What a point is made of: finer than the labels, for bone differs from bone and fat from skin.
enum class Matter : std::uint8_t {
  outside,
  airway,
  skin,
  fat,
  skull,
  mandible,
  spine,
  hyoid,
  tongue,
  epiglottis,
  soft_palate,
  larynx,
  oesophagus
};

Label label_of(Matter matter);
/// Hounsfield units at 120 kV; soft tissues lie within 20 of each other.
double hounsfield_of(Matter matter);

class Body {
 public:
  explicit Body(const Variation& variation);

  /// Questions asked in order; the first shape that holds the point says what it is, and skin is what is left.
  static constexpr int kTests = 14;
  using Open = std::bitset<kTests>;  ///< questions not yet settled

  Matter at(const Vec& p, const Open& open = Open().set()) const;
  /// Settles what it can for all points within `radius` of `centre`. Returns true, and the matter, when all are alike.
  bool settle(const Vec& centre, double radius, Open& open, Matter& matter) const;

  const Variation& variation() const { return variation_; }
  const FaceShapes& face() const { return face_; }
  const MouthShapes& mouth() const { return mouth_; }
  const LarynxShapes& larynx() const { return larynx_; }
  const BoneShapes& bones() const { return bones_; }
  const Shape& tongue() const { return tongue_; }
  const Shape& epiglottis() const { return epiglottis_; }

 private:
  struct Test {
    Shape shape;
    Matter matter;
  };
  Variation variation_;
  FaceShapes face_;
  MouthShapes mouth_;
  LarynxShapes larynx_;
  BoneShapes bones_;
  Shape tongue_;
  Shape epiglottis_;
  std::vector<Test> tests_;
};

}  // namespace vallecula::pipeline::manikin

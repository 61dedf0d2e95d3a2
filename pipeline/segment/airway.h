// The airway: lumen, its course from the trachea upwards, carina and glottis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/segment/head.h"
#include "pipeline/segment/section.h"

namespace vallecula::pipeline {

struct Airway {
  Mask lumen;                   ///< from the lips' and nostrils' planes to the end of the scan or the bronchi
  Mask other_gas;               ///< air inside the head that is not airway: sinuses cut off, gas in the oesophagus
  std::vector<Section> course;  ///< from below upwards, across the airway's own direction
  Vector3 carina{};
  bool carina_seen = false;  ///< else continued from the trachea by the length usual for the head's size
  Section glottis;           ///< the narrowest cut between trachea and pharynx; its normal looks to the head
  Vector3 front_commissure{};
  std::vector<Vector3> glottis_outline;
};

/// Positive in air, about mm near a wall (the scanner's blur spreads the step over about a millimetre).
Volume<float> air_field(const Hounsfield& hu, const Thresholds& t);

/// What a person said of it, mm LPS.
struct AirwayHints {
  std::optional<Mask> lumen;          ///< stands instead of what is found; `air` is then to have its border
  std::optional<Vector3> seed;        ///< in the air of the way, where not the largest piece of gas is it
  std::optional<Vector3> cords_near;  ///< the glottis is the narrowest place near this point
  std::optional<Vector3> cords_at;    ///< found otherwise (a tube held them apart): the glottis is here, however wide
};

/// Throws std::runtime_error naming what is missing when there is no air way through the neck.
Airway find_airway(const Volume<float>& air, const Head& head, const Frame& frame, const AirwayHints& hints = {});

/// The glottis at a place and across a direction given by a person. Throws std::runtime_error when there is no lumen.
void place_glottis(Airway& airway, const Volume<float>& air, const Vector3& centre, const Vector3& normal,
                   double scale);

}  // namespace vallecula::pipeline

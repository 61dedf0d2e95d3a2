// The shapes of the manikin at term scale (mm, LPS, origin at the upper gum's midline), region by region. The points
// and half widths are those of the mid-sagittal design; what it leaves open (how wide, how round) is chosen here.
#pragma once

#include "pipeline/manikin/field.h"
#include "pipeline/manikin/variation.h"

namespace vallecula::pipeline::manikin {

/// Lift of the tongue base along the handle, at term scale (mm), and where it points in (y, z): to the ceiling and the
/// feet.
constexpr Flat kLiftDirection{-0.788, -0.616};

struct FaceShapes {
  Shape head;      ///< skin surface with the mouth and nostrils not yet cut
  Shape aperture;  ///< the opening between the lips
  Shape eyelids;   ///< slit between the closed lids, cut from the skin
};
FaceShapes face_shapes(const Variation& v);

struct BoneShapes {
  Shape skull;  ///< brain case, orbits' rim, cheek bones, hard palate, upper alveolar ridge
  Shape mandible;
  Shape spine;
  Shape hyoid;
};
/// `nasal` and `gums` are cut out of, and used for, the bones around them.
BoneShapes bone_shapes(const Variation& v, const Shape& nasal);

struct MouthShapes {
  Shape cavity;     ///< mouth, pharynx and nose together, before tongue, palate and larynx are put in
  Shape nasal;      ///< nostrils and nasal passages alone
  Shape upper_gum;  ///< the ridges, which stand into the cavity
  Shape lower_gum;
  Shape soft_palate;
  Shape oesophagus;
};
MouthShapes mouth_shapes(const Variation& v, const FaceShapes& face);

struct LarynxShapes {
  Shape lumen;       ///< vestibule, glottis, subglottis, trachea and the first part of the bronchi
  Shape arytenoids;  ///< stand in the lumen's back wall
  Shape body;        ///< the tower with the aryepiglottic folds, lumen not cut
};
LarynxShapes larynx_shapes(const Variation& v);

/// The two that move when the tongue base is lifted by `lift` mm: the dorsum by fixed shares of it from tip to
/// vallecula, the epiglottis' base by a fifth of it while it turns forward 6 degrees a millimetre.
Shape tongue_shape(const Variation& v, double lift);
Shape epiglottis_shape(const Variation& v, double lift);

/// Plan of the gum arches (x, y) and the height of their crest.
std::vector<Flat> upper_arch(const Variation& v);
std::vector<Flat> lower_arch(const Variation& v);
double upper_crest(double y);
double lower_crest(const Variation& v, double y);

// Glottis: a triangle in its own plane, from the anterior commissure backwards.
constexpr Flat kAnteriorCommissure{29.6, -48.9};
constexpr Flat kPosteriorCommissure{36.4, -47.1};
constexpr double kGlottisHalfWidth = 2.0;  ///< behind; in front it runs to 0
constexpr Flat kGlottisCentre{33.0, -48.0};
constexpr Flat kGlottisNormal{-0.259, 0.966};  ///< cranial
constexpr Flat kSubglottis{34.8, -53.7};
constexpr Flat kTracheaAxis{0.292, -0.956};
constexpr double kTracheaLength = 44.05;  ///< from the subglottis to the carina at (47.6, -95.8)
Flat carina(const Variation& v);

}  // namespace vallecula::pipeline::manikin

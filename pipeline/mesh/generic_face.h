// The shipped infant's face in place of the patient's: the surface of a face made from a CT can be recognised.
#pragma once

#include "pipeline/segment/segment.h"

namespace vallecula::pipeline {

/// Replaces the outside of the head above the larynx by that of the unvaried manikin, scaled to this head and laid onto
/// its upper gum; the lips' surroundings (10 mm, term) stay the patient's, for the blade touches them, and so does
/// everything within: bone, airway and soft tissue keep at least 2.5 mm (term) of skin over them. Changes `hu`, `head`
/// and the skin in `labels`. The bones of the face under it are still the patient's.
void give_generic_face(Segmentation& s);

/// A label map without a face: skin is all that lies within 3 mm (times `scale`) of what is in the head, were it skin
/// or air, and nothing else. So no border of it is the patient's own, where the skin is thinner than that neither.
Labels without_face(const Labels& labels, double scale);

}  // namespace vallecula::pipeline

// The last look at a new patient: the scripted expert plays it before it is written.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

/// The least share of the glottis that the expert must see for the check to be content: the shipped course asks for it.
constexpr double kSeenEnough = 0.5;

/// Plays the scripted expert's approach on the engine, without a window, a log or the clock, until the glottis is in
/// sight or the lift is over; where it is not seen, up to five times again with the tip a little elsewhere. What saw
/// most is kept as the package's `approach`, which the scripted expert then takes. Two items: the share of the glottis
/// seen at rest, and when lifted; the latter is the verdict, and comes first and says what in the anatomy stands in the
/// way where it is not as it should be. About 5 s of one core for a term infant. A package that no scene can be built
/// from is an item too: nothing is thrown for the anatomy's faults. `progress` gets 0..1 and may throw to end the work.
std::vector<pipeline::QualityItem> check_by_playing(pipeline::PatientPackage& package,
                                                    const std::function<void(double)>& progress = {});

}  // namespace vallecula::gui

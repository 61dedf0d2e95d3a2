// The built-in patient of a scenario: the manikin's CT, imported like any other, kept for the next time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "curricula/scenario.h"

namespace vallecula::gui {

/// What is being done and the share done, 0..1.
using PatientProgress = std::function<void(const std::string& stage, double fraction)>;

/// Writes the manikin's CT series to FOLDER/ct and imports it as FOLDER/manikin.patient; returns the package.
/// Throws std::runtime_error with one message.
std::filesystem::path make_manikin_patient(const curricula::ManikinSpec& manikin, const std::filesystem::path& folder,
                                           const PatientProgress& progress = {});

/// The same from the user's cache ($VALLECULA_HOME/cache, else $XDG_CACHE_HOME/vallecula, else ~/.cache/vallecula):
/// made at first use by this build, whole or not at all; a damaged one is made anew.
std::filesystem::path builtin_patient(const curricula::ManikinSpec& manikin, const PatientProgress& progress = {});

/// The cached package's name without .patient: weight, seed, and a hash over the program and every number of the shape.
std::string builtin_patient_name(const curricula::ManikinSpec& manikin);

/// Where builtin_patient keeps them; empty when no folder for the user's cache is known.
std::filesystem::path builtin_patients_folder();

}  // namespace vallecula::gui

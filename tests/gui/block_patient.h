// A patient of plain blocks: a tongue whose dorsum is the plane z = 0, and a hard palate far above it. Small enough to
// be written, simulated and replayed within a second, so that commands are tested without an import.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui::test {

/// Tongue 20 x 30 x 12 mm (x, y, z), 540 tetrahedra, fastened along its underside; mm, LPS.
pipeline::PatientPackage block_patient();

/// Writes it as FOLDER/block.patient and returns that path.
std::filesystem::path write_block_patient(const std::filesystem::path& folder);

/// FOLDER/press.csv: in 1.2 s the blade, tongue-side face down, comes from 6 mm above the dorsum, presses 2.5 mm into
/// it and goes back.
std::filesystem::path write_press(const std::filesystem::path& folder);

/// What the tests' scenarios ask for where it does not matter, from `manikin` to the last pass limit, as lines of a
/// scenario in a list.
std::string usual_demands(int max_attempt_s = 40);

/// FOLDER/plain.yaml with one scenario, "plain".
std::filesystem::path write_curriculum(const std::filesystem::path& folder);

void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace vallecula::gui::test

// The term infant with a coarse tongue, imported once for all tests that play many trials on it: a tick of it costs two
// thirds of the shipped mesh's.
#pragma once

#include <filesystem>

namespace vallecula::gui::test {

/// The package (3.2 kg, seed 1, 1000 tetrahedra), kept in the build folder: made at first use by this build, whole or
/// not at all. Throws std::runtime_error with what the program said.
std::filesystem::path coarse_infant();

}  // namespace vallecula::gui::test

// Where the application finds what was shipped and keeps what it writes for its user.
#pragma once

#include <filesystem>

namespace vallecula::gui {

/// What the environment says for the name; null where it says nothing or an empty word.
const char* set_variable(const char* name);
/// The user's data folder: $VALLECULA_HOME, else $XDG_DATA_HOME/vallecula, else ~/.local/share/vallecula. Not created
/// here. Throws std::runtime_error when none of the three is known.
std::filesystem::path user_data_folder();
/// The database of finished trials in it; creates the folder. Throws std::runtime_error with the folder's name.
std::filesystem::path records_database();
/// The shipped curricula: $VALLECULA_CURRICULA, else ../share/vallecula/curricula beside the program (installed), else
/// the source tree this program was built from. Throws std::runtime_error when none exists.
std::filesystem::path curricula_folder();
/// The shipped curriculum that is meant when none is named: first-steps.yaml, or where it is not the first by file name.
std::filesystem::path default_curriculum();

}  // namespace vallecula::gui

// What the window's program did, kept in the user's data folder so that it can be sent when something went wrong. It
// names nobody: no person, no patient, no folder. What may hold a name goes through without_identity().
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vallecula::gui::program_log {

/// Forgets what was hidden, and opens FOLDER/vallecula.log, at most 256 kB, with two older ones. False: the folder cannot be written, and nothing
/// will be kept. Lines are written by a thread of their own.
bool begin(const std::filesystem::path& folder);
void end();

/// From now on no line holds this: a person's or patient's name, or a folder (of which its own name is hidden as well).
void hide(const std::string& words);
void hide(const std::filesystem::path& path);
/// `text` without what is hidden and without anything else that looks like a path.
std::string without_identity(const std::string& text);

/// One line; goes through without_identity(). Nothing happens before begin().
void note(const std::string& line);

/// Writes `head` and all that is kept into one text file. Throws std::runtime_error. Waits for lines on their way, a
/// second at most: not for the window's thread.
void save(const std::filesystem::path& to, const std::vector<std::string>& head);

}  // namespace vallecula::gui::program_log

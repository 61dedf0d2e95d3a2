// Of what the program is made: for the About box and for a log that is sent.
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace vallecula::gui {

struct Part {
  QString name, version, licence;
};
/// The program itself first. Asks no disk and no network.
std::vector<Part> program_parts();
/// What draws: OpenGL's own name and version. Makes a context of its own, some 50 ms on software rendering; empty where
/// there is none. The window's thread only.
QString opengl_renderer();
/// What a log begins with, a line each: program, parts, system, screens, OpenGL.
std::vector<std::string> system_lines();

}  // namespace vallecula::gui

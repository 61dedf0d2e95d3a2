// A scanned or modelled laryngoscope put into the tool frame by its tip and its handle, and kept with a trial.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "curricula/trial_log.h"
#include "engine/scene.h"
#include "gui/session/tool_mesh.h"

namespace vallecula::gui {

/// m off the line from tip to handle point: wider than any blade and its curve, nearer than any handle's end.
constexpr double kHandleStands = 0.030;
/// True when `tool` (m, tool frame) stands so far out of its axis, to whichever side: it has a handle of its own.
bool has_handle(const engine::TriangleMesh& tool);

/// Points of the mesh as it was read, m.
struct ToolPlacement {
  engine::Vec3 tip = engine::Vec3::Zero();     ///< of the blade
  engine::Vec3 handle = engine::Vec3::Zero();  ///< where the blade meets the handle
  std::optional<engine::Vec3> face;            ///< a direction out of the tongue side; left out: the handle's
};

struct PlacedTool {
  engine::TriangleMesh surface;      ///< m, tool frame
  double blade_m = 0.0;              ///< from tip to handle point
  double handle_m = 0.0;             ///< how far the surface stands out of the blade's axis
  std::vector<std::string> notices;  ///< what may be a mistake, one sentence each
};

/// Into the tool frame of the engine: origin at the tip; +x from the tip to the handle point; +z out of the tongue
/// side, which is the way the handle stands out of that line unless `face` says otherwise (made square to +x); +y = z
/// cross x. The handle's way is the mean over the surface of the offset from that line, weighted by the distance's
/// square: a handle is far longer than a blade is wide or curved. `name` and `unit` ("m", "mm") are for messages.
/// Throws std::runtime_error: size not a laryngoscope's (30 to 250 mm), tip or handle off the mesh, too near each
/// other, the tool beyond the tip, a line that leaves the blade, no handle on one side to take the tongue side from.
PlacedTool place_tool(const engine::TriangleMesh& read, const ToolPlacement& placement, const std::string& name,
                      const std::string& unit);

/// Makes `tool` (m, tool frame) the scene's. Soft tissue meets it from 120 mm behind the tip on no more, nor what
/// stands more than 20 mm out of the tongue side, where the handle is; rigid anatomy meets all of it.
void use_own_tool(const engine::TriangleMesh& tool, engine::SceneDescription& scene);

/// The tool of a trial as it lies beside its log: binary PLY, double precision, metres, tool frame.
constexpr const char* kToolFile = "tool.ply";
std::string tool_to_ply(const engine::TriangleMesh& tool);

/// The file that keeps the tool for this log alone: NAME.tool.ply of NAME.vtrial.
std::filesystem::path own_tool_file(const std::filesystem::path& log_file);
/// Where the tool of a trial (its log or its folder) is: the log's own file if there is one, else tool.ply beside it.
std::filesystem::path tool_file_of_trial(const std::filesystem::path& log_file);

/// The own tool of a recorded trial, read from beside its log and proven to be the recorded one by its hash; nothing
/// where the trial was done with its scenario's blade. Throws std::runtime_error when it is missing or another.
std::optional<engine::TriangleMesh> tool_of_trial(const curricula::LogHeader& header,
                                                  const std::filesystem::path& log_file);

}  // namespace vallecula::gui

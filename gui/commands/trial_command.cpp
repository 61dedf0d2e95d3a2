// `vallecula trial`: one trial, in a window or headless.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "device/drivers/scripted_device.h"
#include "gui/commands/commands.h"
#include "gui/commands/headless_application.h"
#include "gui/commands/interruption.h"
#include "gui/commands/number_options.h"
#include "gui/commands/score_table.h"
#include "gui/lab/number_text.h"
#include "gui/session/curricula_files.h"
#include "gui/session/device_choice.h"
#include "gui/session/files.h"
#include "gui/session/patient_fit.h"
#include "gui/session/placed_tool.h"
#include "gui/session/user_paths.h"

namespace vallecula::gui {

namespace fs = std::filesystem;

namespace {

struct TrialOptions {
  std::string patient, scenario, curriculum, device, second, out, tool, tool_unit = "mm", tool_tip, tool_handle,
                                                                        tool_face, blade, tube;
  std::uint32_t attempt_seed = 0;
  bool assessment = false;
  bool headless = false, as_fast_as_possible = false, json = false;
};

/// The course that has this scenario: the default one, else the only other one, shipped or the user's own. Of several
/// none is chosen; where none has it the default one is given, whose refusal lists what it has.
fs::path course_of(const std::string& scenario) {
  const fs::path first = default_curriculum();
  std::vector<fs::path> having;
  for (const fs::path& file : curriculum_files()) try {
      if (curricula::load_curriculum(file).find(scenario) == nullptr) continue;
      if (file == first) return file;
      having.push_back(file);
    } catch (const std::exception&) {
      if (file == first) throw;
      continue;  // one that cannot be read has nothing to offer
    }
  if (having.empty()) return first;
  if (having.size() == 1) {
    spdlog::info("scenario {} is of {}", scenario, having.front().filename().string());
    return having.front();
  }
  std::string files;
  for (const fs::path& file : having) files += (files.empty() ? "" : " and ") + file.filename().string();
  throw CLI::ValidationError("--scenario",
                             "'" + scenario + "' is in " + files + "; name one of them with --curriculum");
}

/// ID, or FILE.yaml:ID.
void name_scenario(const TrialOptions& options, TrialSetup& setup) {
  const std::size_t colon = options.scenario.rfind(':');
  if (colon != std::string::npos) {
    if (!options.curriculum.empty())
      throw CLI::ValidationError("--scenario", "names a file, and so does --curriculum; give one of them");
    setup.curriculum = options.scenario.substr(0, colon);
    setup.scenario = options.scenario.substr(colon + 1);
    return;
  }
  setup.curriculum = options.curriculum.empty() ? course_of(options.scenario) : fs::path(options.curriculum);
  setup.scenario = options.scenario;
}

engine::Vec3 three_numbers(const std::string& option, const std::string& text) {
  engine::Vec3 values;
  std::size_t from = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = text.find(',', from);
    const std::optional<double> value = number_in(std::string_view(text).substr(from, comma - from));
    if (!value || (comma == std::string::npos) != (axis == 2))
      throw CLI::ValidationError(option, "'" + text + "' is not X,Y,Z: three finite numbers with commas between");
    values[axis] = *value;
    from = comma + 1;
  }
  return values;
}

/// The tool that the options name, in the tool frame; null: the scenario's blade.
std::shared_ptr<const engine::TriangleMesh> own_tool(const TrialOptions& o) {
  if (o.tool.empty()) {
    for (const auto& [option, value] :
         {std::pair{"--tool-tip", &o.tool_tip}, std::pair{"--tool-handle", &o.tool_handle},
          std::pair{"--tool-face", &o.tool_face}})
      if (!value->empty()) throw CLI::ValidationError(option, "places a --tool, and none is given");
    return nullptr;
  }
  if (o.tool_tip.empty() || o.tool_handle.empty())
    throw CLI::ValidationError("--tool",
                               "needs both --tool-tip X,Y,Z (the blade's tip) and --tool-handle X,Y,Z (where "
                               "the blade meets the handle), in the mesh file's coordinates");
  const double unit_m = o.tool_unit == "mm" ? 1e-3 : 1.0;
  ToolPlacement placement;
  placement.tip = unit_m * three_numbers("--tool-tip", o.tool_tip);
  placement.handle = unit_m * three_numbers("--tool-handle", o.tool_handle);
  if (!o.tool_face.empty()) {
    placement.face = three_numbers("--tool-face", o.tool_face);
    if (placement.face->isZero(0.0)) throw CLI::ValidationError("--tool-face", "is no direction: all three are 0");
  }
  ToolMesh read = read_tool_mesh(o.tool, unit_m, "--tool-unit");
  reduce_tool_mesh(read, o.tool);
  PlacedTool placed = place_tool(read.surface, placement, o.tool, o.tool_unit);
  for (const std::string& notice : read.notices) spdlog::warn("{}", notice);
  for (const std::string& notice : placed.notices) spdlog::warn("{}", notice);
  spdlog::info("tool: {:.1f} mm from tip to handle, stands {:.1f} mm out of that line, {} triangles",
               1e3 * placed.blade_m, 1e3 * placed.handle_m, placed.surface.triangles.size());
  return std::make_shared<const engine::TriangleMesh>(std::move(placed.surface));
}

int run_headless(const TrialSetup& setup, bool json) {
  const HeadlessApplication application;
  watch_for_interruption();
  TrialSession session(setup);
  const auto* script = dynamic_cast<const device::ScriptedDevice*>(&session.device());
  if (script != nullptr && script->faults_too_late() > 0)
    spdlog::warn("{} of the script's faults would begin after its last row, where the trial ends: give it a later row",
                 script->faults_too_late());
  for (const std::string& notice : session.notices()) spdlog::warn("{}", notice);
  for (const std::string& misfit : misfits(session.package(), session.scenario())) spdlog::warn("{}", misfit);
  spdlog::info("scene built; {} with {} begins", session.scenario().id, setup.device);
  session.start();
  const bool show_progress = isatty(STDERR_FILENO) != 0;
  std::string told;
  while (!session.finished() && !interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::string pause = session.pause();
    if (pause != told && !pause.empty()) spdlog::warn("paused: {}", pause);
    told = pause;
    if (show_progress) std::fprintf(stderr, "\rtrial: %5.1f s", session.latest().time_s);
  }
  if (show_progress) std::fputs("\r              \r", stderr);
  if (interrupted())
    throw std::runtime_error("the trial was interrupted; what was recorded until then is in " + setup.out.string());
  const TrialOutcome outcome = session.finish("ended");
  if (!outcome.fault.empty()) spdlog::warn("{}", outcome.fault);
  if (json) {
    std::cout << read_file(outcome.score_json);
  } else {
    print_score(std::cout, outcome.score, session.scenario());
    std::cout << "report: " << outcome.report.string() << "\n";
  }
  return 0;
}

}  // namespace

void add_trial_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("trial", "Do one trial, in the window or headless, and score it");
  auto options = std::make_shared<TrialOptions>();
  command->add_option("--patient", options->patient, "Patient package (NAME.patient)")->required();
  command->add_option("--scenario", options->scenario, "Scenario: its id in the curriculum, or FILE.yaml:ID")
      ->required();
  command->add_option("--curriculum", options->curriculum,
                      "Curriculum file (left out: the one, shipped or your own, that has the scenario)");
  command->add_flag(
      "--assessment", options->assessment,
      "As an assessment: the scenario as written, without helps on the screen, and in the window the own rating "
      "before the score");
  command
      ->add_option(
          "--attempt-seed", options->attempt_seed,
          "What the scenario's variation is drawn with; the same seed gives the same attempt, 0 what is written")
      ->check(whole_number_within(0, kLargestSeed));
  command->add_option("--blade", options->blade,
                      "Of the blades that the scenario offers; left out: the right one, unasked");
  command->add_option("--tube", options->tube, "Of the tubes that it offers, likewise");
  command->add_option("--device", options->device, device_names() + " (t,x,y,z[,qw,qx,qy,qz]; s, m)")->required();
  command->add_option("--second", options->second,
                      std::string("In a scenario with a tube, the device of the hand that has it: as --device, or ") +
                          kSameDevice +
                          " (the one device takes blade and tube in turn; so if left out, unless the "
                          "script or record of --device has two hands)");
  command->add_flag("--headless", options->headless, "No window; scripted and recorded hands only");
  command->add_flag("--asap", options->as_fast_as_possible, "Headless only: as fast as it goes instead of 1 kHz");
  command
      ->add_option(
          "--out", options->out,
          "Folder for trial.vtrial, tool.ply (with --tool), score.json, report.html, force.png, and fault.csv after "
          "a fault")
      ->required();
  command->add_option("--tool", options->tool,
                      "A laryngoscope of your own instead of the scenario's blade: a closed mesh .stl, .obj or .ply");
  command->add_option("--tool-unit", options->tool_unit, "Unit of that file and of the points below: m or mm")
      ->check(CLI::IsMember({"m", "mm"}))
      ->capture_default_str();
  command->add_option("--tool-tip", options->tool_tip, "X,Y,Z of its blade's tip, in the file's coordinates");
  command->add_option("--tool-handle", options->tool_handle, "X,Y,Z of where its blade meets the handle");
  command->add_option(
      "--tool-face", options->tool_face,
      "X,Y,Z, a direction out of the side that lies on the tongue (the way the handle stands if left out)");
  command->add_flag("--json", options->json, "Print the score as JSON (headless)");
  command->callback([options, &exit_code] {
    check_device_name(options->device);
    check_second_name(options->second);
    if (options->as_fast_as_possible && !options->headless) {
      throw CLI::ValidationError("--asap", "works with --headless only: a person needs real time");
    }
    if (options->headless && !is_scripted(options->device)) {
      throw CLI::ValidationError("--device", "'" + options->device +
                                                 "' is held by a person, who must see the scene in real time: leave "
                                                 "out --headless");
    }
    if (options->headless && !options->second.empty() && options->second != kSameDevice &&
        !is_scripted(options->second)) {
      throw CLI::ValidationError("--second", "'" + options->second + "' is held by a person: leave out --headless");
    }
    TrialSetup setup;
    name_scenario(*options, setup);
    if (options->assessment && options->attempt_seed != 0)
      throw CLI::ValidationError("--attempt-seed",
                                 "an assessment takes the scenario as written; leave out one of the two");
    setup.mode = options->assessment ? curricula::Mode::assessment : curricula::Mode::practice;
    setup.attempt_seed = options->attempt_seed;
    setup.taken = {options->blade, options->tube};
    setup.patient = options->patient;
    setup.device = options->device;
    setup.second = options->second;
    setup.out = options->out;
    setup.tool = own_tool(*options);
    setup.realtime = !options->as_fast_as_possible;
    exit_code = options->headless ? run_headless(setup, options->json) : run_window_trial(setup);
  });
}

}  // namespace vallecula::gui

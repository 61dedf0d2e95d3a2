// `vallecula lab`: the laboratory (DESIGN section 6).
#include <spdlog/spdlog.h>

#include <QJsonDocument>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "device/trajectory.h"
#include "engine/haptics/runner.h"
#include "engine/lab/experiment.h"
#include "engine/scene_data.h"
#include "gui/commands/commands.h"
#include "gui/commands/interruption.h"
#include "gui/lab/figures.h"
#include "gui/lab/lab_report.h"
#include "gui/lab/number_text.h"
#include "gui/lab/soft_body_file.h"
#include "gui/lab/tool_shape.h"
#include "gui/pages/window_application.h"
#include "gui/session/builtin_patient.h"
#include "gui/session/files.h"
#include "gui/session/user_paths.h"
#include "gui/session/virtual_display.h"

namespace vallecula::gui {

namespace {

struct LabOptions {
  std::string tet, tool, trajectory, fix, fix_nodes, json, csv, spheres, final_state, figure, out;
  std::string response = "compliant", collision = "aist", coverage = "full", force_limit = "none", length_unit = "m",
              sphere_constraints = "off";
  double young = 10000.0, poisson = 0.45, density = 1040.0, steps_per_second = 1000.0;
  double sphere_ratio = 10.0, friction = 0.0;
  std::string volume = "held";
  int levels = 2, serve_every = 1;
  bool realtime = false, as_fast_as_possible = false;
};

double force_limit(const std::string& word) {
  if (word == "none") return std::numeric_limits<double>::infinity();
  const std::optional<double> value = number_in(word);
  if (!value || !(*value > 0))
    throw CLI::ValidationError("--force-limit", "'" + word + "' is not a force in N above 0, or none");
  return *value;
}

engine::Pose pose_of(const device::Keyframe& k) {
  engine::Pose pose;
  pose.position = engine::Vec3(k.position_m[0], k.position_m[1], k.position_m[2]);
  pose.rotation = engine::Quat(k.rotation_wxyz[0], k.rotation_wxyz[1], k.rotation_wxyz[2], k.rotation_wxyz[3]);
  return pose;
}

QJsonObject settings_json(const LabOptions& o) {
  return {{"tet", QString::fromStdString(o.tet)},
          {"tool", QString::fromStdString(o.tool)},
          {"trajectory", QString::fromStdString(o.trajectory)},
          {"young_pa", o.young},
          {"poisson", o.poisson},
          {"density_kg_m3", o.density},
          {"fix", QString::fromStdString(o.fix.empty() ? o.fix_nodes : o.fix)},
          {"friction", o.friction},
          {"volume", QString::fromStdString(o.volume)},
          {"collision", QString::fromStdString(o.collision)},
          {"response", QString::fromStdString(o.response)},
          {"coverage", QString::fromStdString(o.coverage)},
          {"force_limit", QString::fromStdString(o.force_limit)},
          {"sphere_ratio", o.sphere_ratio},
          {"levels", o.levels},
          {"sphere_constraints", o.sphere_constraints == "on"},
          {"steps_per_second", o.steps_per_second},
          {"serve_every", o.serve_every},
          {"realtime", o.realtime},
          {"length_unit", QString::fromStdString(o.length_unit)},
          {"version", VALLECULA_VERSION},
          {"instruction_set", QString::fromStdString(engine::instruction_set())}};
}

/// The same run with one step where there were `serve_every`, its forces predicted in between.
QJsonValue multirate(const LabOptions& o, engine::SceneDescription d, const engine::ExperimentResult& full,
                     engine::ExperimentSettings settings, const std::function<engine::Pose(double)>& pose) {
  d.step_s *= o.serve_every;
  settings.measure_tissue = false;
  const engine::ExperimentResult coarse = engine::run_experiment(*engine::build_scene(d), pose, settings);
  if (!full.finite || !coarse.finite) return QJsonValue();
  QJsonObject json = prediction_json(engine::multirate_error(full, coarse, o.serve_every, engine::Prediction::contact),
                                     engine::multirate_error(full, coarse, o.serve_every, engine::Prediction::hold));
  json["serve_every"] = o.serve_every;
  std::vector<double> step_ms;
  for (const engine::ExperimentStep& s : coarse.steps) step_ms.push_back(1e3 * s.step_s);
  json["step_p999_ms"] = percentile(step_ms, 0.999);
  return json;
}

void run_lab(const LabOptions& o) {
  const double unit = o.length_unit == "mm" ? 1e-3 : 1.0;
  engine::ExperimentSettings settings;
  settings.force_limit_n = force_limit(o.force_limit);
  settings.realtime = o.realtime;
  settings.measure_tissue = !o.realtime;  // measuring would take the next step's time
  const device::Trajectory trajectory(device::read_trajectory_csv(o.trajectory));
  settings.duration_s = trajectory.end_s() - trajectory.start_s();

  SoftBodyFile body = read_soft_body(o.tet, unit);
  if (!o.fix.empty()) fix_nodes_by_rule(body.soft, o.fix);
  if (!o.fix_nodes.empty()) fix_nodes_by_file(body, o.fix_nodes);
  body.soft.materials = {{o.young, o.poisson, o.density}};

  engine::SceneDescription d;
  d.soft = std::move(body.soft);
  ToolMesh tool = tool_shape(o.tool, unit);
  for (const std::string& notice : tool.notices) spdlog::warn("{}", notice);
  d.tool.surface = std::move(tool.surface);
  d.step_s = 1.0 / o.steps_per_second;
  d.response = o.response == "compliant"    ? engine::Response::compliant
               : o.response == "projection" ? engine::Response::projection
                                            : engine::Response::penalty;
  d.collision = o.collision == "aist" ? engine::Collision::aist : engine::Collision::triangles;
  d.coverage = o.coverage == "full" ? engine::Coverage::full : engine::Coverage::paper;
  d.friction = o.friction;
  d.hold_volume = o.volume == "held";
  d.sphere_ratio = o.sphere_ratio;
  d.sphere_levels = o.levels;
  d.sphere_distances = o.sphere_constraints == "on";
  const auto scene = engine::build_scene(d);

  const auto pose = [&](double t) { return pose_of(trajectory.at(trajectory.start_s() + t)); };
  const engine::ExperimentResult result = engine::run_experiment(*scene, pose, settings);
  QJsonObject figures = lab_json(*scene, settings, result, settings_json(o));
  if (o.serve_every > 1) figures["multirate"] = multirate(o, d, result, settings, pose);
  const std::string json = QJsonDocument(figures).toJson(QJsonDocument::Indented).toStdString();
  if (!o.csv.empty()) write_file_whole(o.csv, lab_csv(result));
  if (!o.spheres.empty()) write_file_whole(o.spheres, spheres_csv(scene->tree));
  if (!o.final_state.empty() && result.finite)
    write_soft_body(o.final_state, result.final_nodes, scene->description.soft.tets);
  if (o.json.empty()) {
    std::cout << json;
  } else {
    write_file_whole(o.json, json);
  }
}

void tell(const std::string& line) { std::fprintf(stderr, "lab: %s\n", line.c_str()); }

/// On the built-in patient of the shipped curriculum's first scenario (a term infant).
void draw_figure(const std::string& figure, FigureSetting& setting) {
  const curricula::Curriculum curriculum = curricula::load_curriculum(default_curriculum());
  if (curriculum.scenarios.empty()) throw std::runtime_error(curriculum.file.string() + ": holds no scenario");
  setting.scenario = curriculum.scenarios.front();
  std::string stage;
  const std::filesystem::path patient =
      builtin_patient(setting.scenario.manikin, [&](const std::string& now, double fraction) {
        setting.pulse();
        if (now == stage) return;
        stage = now;
        std::fprintf(stderr, "lab:   %3.0f %%  %s\n", 100.0 * fraction, now.c_str());
      });
  setting.package = pipeline::read_package(patient);
  tell("running the experiment on " + setting.scenario.title);
  const FigureResult result = figure == "6"   ? write_figure_6(setting)
                              : figure == "7" ? write_figure_7(setting)
                              : figure == "8" ? write_figure_8(setting)
                                              : write_figure_spheres(setting);
  std::cout << result.seen.toStdString() << "\n";
  for (const std::string& file : result.files) std::cout << (setting.out / file).string() << "\n";
}

void run_figure(const LabOptions& o) {
  watch_for_interruption();
  FigureSetting setting;
  setting.out = o.out.empty() ? user_data_folder() / "lab" : std::filesystem::path(o.out);
  setting.pulse = [] { stop_when_interrupted("the figure"); };
  std::error_code error;
  const bool fresh = std::filesystem::create_directories(setting.out, error);
  if (error || !std::filesystem::is_directory(setting.out))
    throw std::runtime_error(setting.out.string() + ": cannot be a folder for the figure (" +
                             (error ? error.message() : "it is a file") + "); name another with --out");
  tell("figure " + o.figure + " will be in " + setting.out.string());

  std::unique_ptr<VirtualDisplay> display;  // before anything takes long: what is missing is said at once
  if (const std::string problem = display_problem(); !problem.empty()) {
    display = std::make_unique<VirtualDisplay>();
    tell(problem + "; drawing on a virtual one (" + display->name() + ")");
  }
  const WindowApplication application;
  try {
    draw_figure(o.figure, setting);
  } catch (...) {
    if (fresh) std::filesystem::remove(setting.out, error);  // only while it is empty
    throw;
  }
}

}  // namespace

void add_lab_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("lab", "One soft body, one tool, one trajectory: figures as JSON");
  auto o = std::make_shared<LabOptions>();
  command->add_option("--tet", o->tet, "Soft body: .vtu, or TetGen's .node or .ele");
  command->add_option(
      "--tool", o->tool,
      "box:LxWxH, paddle:LxWxH (a tongue depressor: round ends of radius W/2, round edges of radius H/2) or "
      "sphere:R (m, along x, y, z, centred at the pose), or a closed mesh .stl, .obj, .ply");
  command->add_option("--trajectory", o->trajectory, "Tool poses: CSV t,x,y,z[,qw,qx,qy,qz] (s, m)");
  command->add_option("--young", o->young, "Young's modulus, Pa")->capture_default_str();
  command->add_option("--poisson", o->poisson, "Poisson's ratio, 0 to below 0.5")->capture_default_str();
  command->add_option("--density", o->density, "kg/m3")->capture_default_str();
  auto* fix = command->add_option("--fix", o->fix, "Fixed nodes by a rule, for instance 'z<-0.003' (m)");
  command->add_option("--fix-nodes", o->fix_nodes, "Fixed nodes by number, one a line, numbered as the mesh file is")
      ->excludes(fix);
  command->add_option("--friction", o->friction, "Coulomb's coefficient of tool on tissue")->capture_default_str();
  command->add_option("--volume", o->volume, "held: the whole loses less than 1 %; or material: what Poisson's ratio allows")
      ->check(CLI::IsMember({"held", "material"}))
      ->capture_default_str();
  command->add_option("--response", o->response, "compliant, projection or penalty")
      ->check(CLI::IsMember({"compliant", "projection", "penalty"}))
      ->capture_default_str();
  command->add_option("--collision", o->collision, "aist, or triangles (direct tests of primitives, the baseline)")
      ->check(CLI::IsMember({"aist", "triangles"}))
      ->capture_default_str();
  command->add_option("--coverage", o->coverage, "Sphere tree: full, or paper (its rule and nothing else)")
      ->check(CLI::IsMember({"full", "paper"}))
      ->capture_default_str();
  command->add_option("--force-limit", o->force_limit, "The device's limit in N, or none")->capture_default_str();
  command->add_option("--sphere-ratio", o->sphere_ratio, "Coarse sphere's volume over the mean tetrahedron's")
      ->capture_default_str();
  command->add_option("--levels", o->levels, "Levels of the sphere grid")->capture_default_str();
  command->add_option("--sphere-constraints", o->sphere_constraints,
                      "With --response projection: neighbouring spheres resist being pressed together: on or off")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  command->add_option("--steps-per-second", o->steps_per_second, "Steps a second")->capture_default_str();
  command->add_option("--serve-every", o->serve_every,
                      "Runs it once more with one step where there were N, predicted in between: its error")
      ->check(CLI::Range(1, 10))
      ->capture_default_str();
  auto* realtime = command->add_flag("--realtime", o->realtime, "A step by the clock; reports late ones");
  command->add_flag("--asap", o->as_fast_as_possible, "As fast as it goes (the default)")->excludes(realtime);
  command->add_option("--length-unit", o->length_unit, "Unit of mesh files: m or mm")
      ->check(CLI::IsMember({"m", "mm"}))
      ->capture_default_str();
  command->add_option("--json", o->json, "Write the figures here (else they are printed)");
  command->add_option("--csv", o->csv, "Write one row a step here");
  command->add_option("--spheres", o->spheres, "Write the spheres at rest here (CSV)");
  command->add_option("--final", o->final_state, "Write the soft body after the last step here (.vtu)");
  const std::vector<const CLI::Option*> of_a_run = [command] {
    const CLI::App* const all = command;
    return all->get_options([](const CLI::Option* one) { return one->get_name() != "--help"; });
  }();
  auto* figure = command
                     ->add_option("--figure", o->figure,
                                  "The paper's experiment anew, on the built-in manikin: 6, 7, 8, or spheres (2 and 3)")
                     ->check(CLI::IsMember({"6", "7", "8", "spheres"}));
  command->add_option("--out", o->out, "Folder for a figure's files (lab/ in the user's data folder if left out)");
  command->callback([o, figure, of_a_run, &exit_code] {
    if (figure->count() > 0) {
      for (const CLI::Option* one : of_a_run)
        if (one->count() > 0)
          throw CLI::ValidationError("--figure", "brings its own scene: " + one->get_name() + " does not go with it");
      run_figure(*o);
      exit_code = 0;
      return;
    }
    if (!o->out.empty()) throw CLI::ValidationError("--out", "is the folder for a --figure; a run's are --json, --csv");
    if (o->tet.empty()) throw CLI::RequiredError("--tet");
    if (o->tool.empty()) throw CLI::RequiredError("--tool");
    if (o->trajectory.empty()) throw CLI::RequiredError("--trajectory");
    if (o->serve_every > 1 && (o->realtime || o->force_limit != "none"))
      throw CLI::ValidationError("--serve-every", "is measured without --realtime and --force-limit");
    if (!(o->steps_per_second >= 10) || !(o->steps_per_second <= 1e5))
      throw CLI::ValidationError("--steps-per-second",
                                 std::to_string(o->steps_per_second) + " does not lie between 10 and 100000");
    if (o->fix.empty() && o->fix_nodes.empty())
      throw CLI::ValidationError("--fix", "or --fix-nodes is needed: a body must be held somewhere");
    run_lab(*o);
    exit_code = 0;
  });
}

}  // namespace vallecula::gui

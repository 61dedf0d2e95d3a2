// `vallecula lab`: the laboratory (DESIGN section 6).
#include <QJsonDocument>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "device/trajectory.h"
#include "engine/haptics/runner.h"
#include "engine/lab/experiment.h"
#include "engine/scene_data.h"
#include "gui/commands/commands.h"
#include "gui/lab/lab_report.h"
#include "gui/lab/soft_body_file.h"
#include "gui/lab/tool_shape.h"
#include "gui/session/files.h"

namespace vallecula::gui {

namespace {

struct LabOptions {
  std::string tet, tool, trajectory, fix, fix_nodes, json, csv, spheres, final_state;
  std::string response = "compliant", collision = "aist", coverage = "full", force_limit = "none", length_unit = "m";
  double young = 10000.0, poisson = 0.45, density = 1040.0, steps_per_second = 1000.0;
  double sphere_ratio = 10.0, friction = 0.0;
  int levels = 2;
  bool realtime = false, as_fast_as_possible = false;
};

double force_limit(const std::string& word) {
  if (word == "none") return std::numeric_limits<double>::infinity();
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !(value > 0) || !std::isfinite(value))
    throw CLI::ValidationError("--force-limit", "'" + word + "' is not a force in N above 0, or none");
  return value;
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
          {"collision", QString::fromStdString(o.collision)},
          {"response", QString::fromStdString(o.response)},
          {"coverage", QString::fromStdString(o.coverage)},
          {"force_limit", QString::fromStdString(o.force_limit)},
          {"sphere_ratio", o.sphere_ratio},
          {"levels", o.levels},
          {"steps_per_second", o.steps_per_second},
          {"realtime", o.realtime},
          {"length_unit", QString::fromStdString(o.length_unit)},
          {"version", VALLECULA_VERSION},
          {"instruction_set", QString::fromStdString(engine::instruction_set())}};
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
  d.tool.surface = tool_shape(o.tool, unit);
  d.step_s = 1.0 / o.steps_per_second;
  d.response = o.response == "compliant"    ? engine::Response::compliant
               : o.response == "projection" ? engine::Response::projection
                                            : engine::Response::penalty;
  d.collision = o.collision == "aist" ? engine::Collision::aist : engine::Collision::triangles;
  d.coverage = o.coverage == "full" ? engine::Coverage::full : engine::Coverage::paper;
  d.friction = o.friction;
  d.sphere_ratio = o.sphere_ratio;
  d.sphere_levels = o.levels;
  const auto scene = engine::build_scene(d);

  const engine::ExperimentResult result = engine::run_experiment(
      *scene, [&](double t) { return pose_of(trajectory.at(trajectory.start_s() + t)); }, settings);
  const std::string json =
      QJsonDocument(lab_json(*scene, settings, result, settings_json(o))).toJson(QJsonDocument::Indented).toStdString();
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

}  // namespace

void add_lab_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("lab", "One soft body, one tool, one trajectory: figures as JSON");
  auto o = std::make_shared<LabOptions>();
  command->add_option("--tet", o->tet, "Soft body: .vtu, or TetGen's .node or .ele")->required();
  command->add_option("--tool", o->tool, "box:LxWxH or sphere:R (m), or a closed mesh .stl, .obj, .ply")->required();
  command->add_option("--trajectory", o->trajectory, "Tool poses: CSV t,x,y,z[,qw,qx,qy,qz] (s, m)")->required();
  command->add_option("--young", o->young, "Young's modulus, Pa")->capture_default_str();
  command->add_option("--poisson", o->poisson, "Poisson's ratio, 0 to below 0.5")->capture_default_str();
  command->add_option("--density", o->density, "kg/m3")->capture_default_str();
  auto* fix = command->add_option("--fix", o->fix, "Fixed nodes by a rule, for instance 'z<-0.003' (m)");
  command->add_option("--fix-nodes", o->fix_nodes, "Fixed nodes by number, one a line, numbered as the mesh file is")
      ->excludes(fix);
  command->add_option("--friction", o->friction, "Coulomb's coefficient of tool on tissue")->capture_default_str();
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
  command->add_option("--steps-per-second", o->steps_per_second, "Steps a second")->capture_default_str();
  auto* realtime = command->add_flag("--realtime", o->realtime, "A step by the clock; reports late ones");
  command->add_flag("--asap", o->as_fast_as_possible, "As fast as it goes (the default)")->excludes(realtime);
  command->add_option("--length-unit", o->length_unit, "Unit of mesh files: m or mm")
      ->check(CLI::IsMember({"m", "mm"}))
      ->capture_default_str();
  command->add_option("--json", o->json, "Write the figures here (else they are printed)");
  command->add_option("--csv", o->csv, "Write one row a step here");
  command->add_option("--spheres", o->spheres, "Write the spheres at rest here (CSV)");
  command->add_option("--final", o->final_state, "Write the soft body after the last step here (.vtu)");
  command->callback([o, &exit_code] {
    if (!(o->steps_per_second >= 10) || !(o->steps_per_second <= 1e5))
      throw CLI::ValidationError("--steps-per-second", "must lie between 10 and 100000");
    if (o->fix.empty() && o->fix_nodes.empty())
      throw CLI::ValidationError("--fix", "or --fix-nodes is needed: a body must be held somewhere");
    run_lab(*o);
    exit_code = 0;
  });
}

}  // namespace vallecula::gui

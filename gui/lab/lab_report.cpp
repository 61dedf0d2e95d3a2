#include "gui/lab/lab_report.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vallecula::gui {

namespace {

using engine::ExperimentStep;

constexpr int kCoverageSamples = 20000;

template <class Value>
std::vector<double> each_step(const engine::ExperimentResult& result, Value value) {
  std::vector<double> values;
  values.reserve(result.steps.size());
  for (const ExperimentStep& s : result.steps) values.push_back(value(s));
  return values;
}

const char* name_of(engine::HapticState state) {
  switch (state) {
    case engine::HapticState::tracking: return "tracking";
    case engine::HapticState::limited: return "limited";
    case engine::HapticState::lost: return "lost";
    case engine::HapticState::recovering: break;
  }
  return "recovering";
}

void append(std::string& out, const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  out += text;
}

}  // namespace

QJsonObject prediction_json(const engine::ForceError& predicted, const engine::ForceError& held) {
  return {{"rms_n", predicted.rms_n},      {"p99_n", predicted.p99_n},      {"max_n", predicted.max_n},
          {"hold_rms_n", held.rms_n},      {"hold_p99_n", held.p99_n},      {"hold_max_n", held.max_n}};
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::max(1.0, std::ceil(share * static_cast<double>(values.size())))) - 1;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

QJsonObject lab_json(const engine::Scene& scene, const engine::ExperimentSettings& asked,
                     const engine::ExperimentResult& result, const QJsonObject& settings) {
  const bool finite = result.finite;
  const auto unless_diverged = [finite](double v) { return finite ? QJsonValue(v) : QJsonValue(); };
  const auto measured = [&](double v) { return finite && asked.measure_tissue ? QJsonValue(v) : QJsonValue(); };

  const auto step = each_step(result, [](const ExperimentStep& s) { return 1e3 * s.step_s; });
  const QJsonObject step_ms{{"min", percentile(step, 0)},      {"p50", percentile(step, 0.5)},
                            {"p99", percentile(step, 0.99)},   {"p999", percentile(step, 0.999)},
                            {"max", percentile(step, 1)}};
  const auto share = [&](auto value) { return percentile(each_step(result, value), 0.5) * 1e3; };
  const QJsonObject share_ms{
      {"collision", share([](const ExperimentStep& s) { return s.stages.collision_s; })},
      {"response", share([](const ExperimentStep& s) { return s.stages.response_s; })},
      {"elasticity", share([](const ExperimentStep& s) { return s.stages.elasticity_s; })},
      {"solve", share([](const ExperimentStep& s) { return s.stages.solve_s; })},
      {"other", share([](const ExperimentStep& s) {
         return s.elapsed_s - s.stages.collision_s - s.stages.response_s - s.stages.elasticity_s - s.stages.solve_s;
       })}};

  QJsonArray per_level;
  for (int n : scene.tree.spheres_per_level) per_level.append(n);
  const engine::CoverageReport coverage =
      engine::measure_coverage(scene.tree, scene.description.soft, scene.surface, kCoverageSamples);
  const QJsonObject aist{{"spheres_per_level", per_level},
                         {"coarse_radius_m", scene.tree.coarse_radius},
                         {"uncovered_depth_m", coverage.uncovered_depth_m},
                         {"mean_gap_m", coverage.mean_gap_m},
                         {"covered_surface_fraction", coverage.covered_fraction}};

  const auto contacts = each_step(result, [](const ExperimentStep& s) { return double(s.contacts); });
  const auto force = each_step(result, [](const ExperimentStep& s) { return s.force_n.norm(); });
  double change = 0.0, volume = 0.0;
  int inverted = 0;
  for (std::size_t i = 0; i < result.steps.size(); ++i) {
    if (i > 0) change = std::max(change, (result.steps[i].force_n - result.steps[i - 1].force_n).norm());
    volume = std::max(volume, std::abs(result.steps[i].volume_change));
    inverted = std::max(inverted, result.steps[i].inverted);
  }
  const auto depth = each_step(result, [](const ExperimentStep& s) { return s.penetration_m; });
  const auto vertex_depth = each_step(result, [](const ExperimentStep& s) { return s.vertex_penetration_m; });
  const auto late = each_step(result, [](const ExperimentStep& s) { return 1e3 * s.late_s; });
  const auto iterations = each_step(result, [](const ExperimentStep& s) { return double(s.solver_iterations); });

  QJsonObject prediction;
  for (const int withheld : engine::kWithheldSteps)
    prediction[QString::number(withheld)] =
        prediction_json(engine::prediction_error(result, engine::Prediction::contact, withheld),
                        engine::prediction_error(result, engine::Prediction::hold, withheld));

  return QJsonObject{
      {"settings", settings},
      {"mesh", QJsonObject{{"nodes", static_cast<double>(scene.description.soft.nodes.size())},
                           {"tets", static_cast<double>(scene.description.soft.tets.size())},
                           {"mean_tet_volume_m3", scene.tree.mean_tet_volume}}},
      {"aist", aist},
      {"step_ms", step_ms},
      {"share_ms", share_ms},
      {"solver_iterations", QJsonObject{{"p50", percentile(iterations, 0.5)}, {"max", percentile(iterations, 1)}}},
      {"realtime", asked.realtime ? QJsonValue(QJsonObject{{"requested_hz", 1.0 / scene.description.step_s},
                                                           {"achieved_hz", result.achieved_hz},
                                                           {"deadline_misses", double(result.deadline_misses)},
                                                           {"ticks", double(result.steps.size())},
                                                           {"late_p999_ms", percentile(late, 0.999)}})
                                  : QJsonValue()},
      {"contacts", QJsonObject{{"p50", percentile(contacts, 0.5)}, {"max", percentile(contacts, 1)}}},
      {"force_n", QJsonObject{{"p50", unless_diverged(percentile(force, 0.5))},
                              {"max", unless_diverged(percentile(force, 1))},
                              {"max_change_per_tick", unless_diverged(change)}}},
      {"tissue", QJsonObject{{"volume_change_max", measured(volume)},
                             {"inverted_max", measured(inverted)},
                             {"residual_m", unless_diverged(result.residual_m)},
                             {"finite", finite}}},
      {"penetration_m", QJsonObject{{"p50", measured(percentile(depth, 0.5))},
                                    {"max", measured(percentile(depth, 1))},
                                    {"vertex_p50", measured(percentile(vertex_depth, 0.5))},
                                    {"vertex_max", measured(percentile(vertex_depth, 1))}}},
      {"prediction", finite ? QJsonValue(prediction) : QJsonValue()},
      {"limit", QJsonObject{{"entered", result.limit_entered},
                            {"time_limited_s", result.time_limited_s},
                            {"time_lost_s", result.time_lost_s}}}};
}

std::string lab_csv(const engine::ExperimentResult& result) {
  std::string out = "t_s,step_ms,contacts,fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm,state,proxy_x_m,proxy_y_m,proxy_z_m\n";
  for (const ExperimentStep& s : result.steps) {
    append(out, "%.6f,", s.time_s);
    append(out, "%.6f,", 1e3 * s.step_s);
    out += std::to_string(s.contacts) + ",";
    for (double v : {s.force_n.x(), s.force_n.y(), s.force_n.z(), s.torque_nm.x(), s.torque_nm.y(), s.torque_nm.z()})
      append(out, "%.9g,", v);
    out += name_of(s.state);
    for (double v : {s.proxy_m.x(), s.proxy_m.y(), s.proxy_m.z()}) append(out, ",%.9g", v);
    out += "\n";
  }
  return out;
}

std::string spheres_csv(const engine::SphereTree& tree) {
  std::string out = "level,x_m,y_m,z_m,radius_m,tet,w0,w1,w2,w3,tied\n";
  for (const engine::InnerSphere& s : tree.spheres) {
    out += std::to_string(s.level);
    for (double v : {s.centre.x(), s.centre.y(), s.centre.z(), s.radius}) append(out, ",%.9g", v);
    out += "," + std::to_string(s.tet);
    for (double w : s.weight) append(out, ",%.9g", w);
    out += "," + std::to_string(s.tied) + "\n";
  }
  return out;
}

}  // namespace vallecula::gui

// The laboratory's figures as JSON and CSV (the keys are others' to read: add, do not rename).
#pragma once

#include <QJsonObject>
#include <string>

#include "engine/aist/sphere_tree.h"
#include "engine/lab/experiment.h"
#include "engine/lab/prediction.h"
#include "engine/scene_data.h"

namespace vallecula::gui {

/// All figures of a run. `settings`: what was asked for, word by word. Quantities of a run that diverged are null.
QJsonObject lab_json(const engine::Scene& scene, const engine::ExperimentSettings& asked,
                     const engine::ExperimentResult& result, const QJsonObject& settings);

/// rms_n, p99_n, max_n; of the same forces held instead of predicted as hold_rms_n, ...
QJsonObject prediction_json(const engine::ForceError& predicted, const engine::ForceError& held);

/// One row a step: t_s,step_ms,contacts,fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm,state,proxy_x_m,proxy_y_m,proxy_z_m.
std::string lab_csv(const engine::ExperimentResult& result);

/// Every sphere at rest: level,x_m,y_m,z_m,radius_m,tet,w0,w1,w2,w3,tied.
std::string spheres_csv(const engine::SphereTree& tree);

/// The value below which `share` of the values lie (nearest rank); 0 for none.
double percentile(std::vector<double> values, double share);

}  // namespace vallecula::gui

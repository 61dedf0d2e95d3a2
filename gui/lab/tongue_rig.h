// The bench of the paper's figures 6 and 7: a patient's tongue without the rest of the mouth, and a blade laid flat on
// the middle of its dorsum, as in a laryngoscopy.
#pragma once

#include <QJsonObject>
#include <array>
#include <memory>
#include <vector>

#include "engine/scene.h"
#include "engine/scene_data.h"
#include "gui/lab/figures.h"
#include "gui/lab/tissue_picture.h"

namespace vallecula::gui {

class TongueRig {
 public:
  /// With the scenario's blade, or with a box (`box:LxWxH`, m) over the middle of the dorsum instead. Throws
  /// std::runtime_error when the tongue has no free dorsum.
  explicit TongueRig(const FigureSetting& setting, const std::string& box = {});

  std::shared_ptr<const engine::Scene> scene(engine::Response response, engine::Collision collision) const;
  const engine::SceneDescription& description() const { return description_; }
  /// The blade `depth` m deep in the dorsum (negative: off it), moved `along` itself towards the handle and `across` to
  /// the patient's left.
  engine::Pose pose(double depth, double along = 0.0, double across = 0.0) const;
  /// The tissue's skin; indices into the nodes.
  const std::vector<std::array<int, 3>>& skin() const { return skin_; }
  /// The patient's right side and a little from above and in front; `across` m wide, the tongue's middle `raised` m
  /// above the picture's.
  void aim(TissuePicture& picture, double across, double raised = 0.0) const;
  /// To be called at every step: the setting's pulse.
  void pulse() const {
    if (pulse_) pulse_();
  }
  /// What was stepped: patient, mesh, blade, build.
  QJsonObject about() const;

 private:
  engine::SceneDescription description_;
  std::string blade_;
  std::function<void()> pulse_;
  std::vector<std::array<int, 3>> skin_;
  engine::Vec3 spot_ = engine::Vec3::Zero(), normal_ = engine::Vec3::UnitZ(), along_ = engine::Vec3::UnitX(),
               across_ = engine::Vec3::UnitY();
  double ahead_ = 0.0, half_ = 0.0;  ///< from the tool's origin to the middle of the dorsum; to its side at the tongue
};

/// Writes `json` to `file` and adds its name to `result`.
void write_figure_json(const FigureSetting& setting, const std::string& name, const QJsonObject& json,
                       FigureResult& result);
void write_figure_png(const FigureSetting& setting, const std::string& name, const QImage& image, FigureResult& result);

}  // namespace vallecula::gui

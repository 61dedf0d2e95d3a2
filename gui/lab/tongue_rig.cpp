#include "gui/lab/tongue_rig.h"

#include <QJsonDocument>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "engine/haptics/runner.h"
#include "engine/mesh/soft_mesh.h"
#include "gui/lab/plot.h"
#include "gui/lab/tool_shape.h"
#include "gui/session/files.h"
#include "gui/session/scene_from_package.h"

namespace vallecula::gui {

namespace {

using engine::Vec3;

constexpr double kMidline = 0.004;    // m to its side: still the middle of the dorsum
constexpr double kFacesUp = 0.6;      // cosine between a dorsal face's normal and the way to the palate
constexpr double kAround = 0.005;     // m: the dorsum's slope is taken from this far around
constexpr double kTipBeyond = 0.008;  // m of blade beyond the middle of the dorsum, towards the throat

Vec3 landmark(const pipeline::PatientPackage& package, const char* name) {
  const auto found = package.landmarks.find(name);
  if (found == package.landmarks.end())
    throw std::runtime_error("patient '" + package.name + "': it has no landmark '" + name + "'; import it again");
  return 1e-3 * Vec3(found->second[0], found->second[1], found->second[2]);
}

}  // namespace

TongueRig::TongueRig(const FigureSetting& setting, const std::string& box)
    : description_(scene_from_package(setting.package, setting.scenario)),
      blade_(setting.scenario.blade),
      pulse_(setting.pulse) {
  description_.rigid = {};
  description_.sight = {};
  ahead_ = kTipBeyond;
  if (!box.empty()) {
    blade_ = box;
    description_.tool.surface = tool_shape(box, 1.0).surface;
    ahead_ = 0.0;
    for (const Vec3& p : description_.tool.surface.points) half_ = std::max(half_, p.z());
  }
  const auto& soft = description_.soft;
  const engine::SoftSurface surface = engine::extract_surface(soft.tets);
  skin_ = surface.triangles;
  const Vec3 throat = landmark(setting.package, "vallecula"), front = landmark(setting.package, "lower_gum_midline");
  const Vec3 forward = (front - throat).normalized();
  Vec3 up = landmark(setting.package, "upper_gum_midline") - 0.5 * (throat + front);
  up = (up - up.dot(forward) * forward).normalized();

  struct Face {
    Vec3 centre, normal;  // the normal as long as the face is large
  };
  std::vector<Face> dorsum;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (std::size_t t = 0; t < skin_.size(); ++t) {
    const auto& k = skin_[t];
    if (soft.tet_structure[surface.tet[t]] != engine::Structure::tongue) continue;
    if (soft.node_anchor[k[0]] >= 0 || soft.node_anchor[k[1]] >= 0 || soft.node_anchor[k[2]] >= 0) continue;
    const Vec3 &a = soft.nodes[k[0]], &b = soft.nodes[k[1]], &c = soft.nodes[k[2]];
    const Face face{(a + b + c) / 3, 0.5 * (b - a).cross(c - a)};
    if (std::abs(face.centre.x()) > kMidline || face.normal.dot(up) < kFacesUp * face.normal.norm()) continue;
    dorsum.push_back(face);
    low = std::min(low, face.centre.dot(forward));
    high = std::max(high, face.centre.dot(forward));
  }
  if (dorsum.empty())
    throw std::runtime_error("patient '" + setting.package.name + "': no free dorsum was found on the tongue");
  const double middle = 0.5 * (low + high);
  const auto spot = std::min_element(dorsum.begin(), dorsum.end(), [&](const Face& a, const Face& b) {
    return std::abs(a.centre.dot(forward) - middle) < std::abs(b.centre.dot(forward) - middle);
  });
  spot_ = spot->centre;
  spot_.x() = 0.0;
  Vec3 normal = Vec3::Zero();
  for (const Face& f : dorsum)
    if ((f.centre - spot_).norm() < kAround) normal += f.normal;
  normal.x() = 0.0;
  normal_ = normal.normalized();
  along_ = (forward - forward.dot(normal_) * normal_).normalized();
  across_ = (-normal_).cross(along_);
}

std::shared_ptr<const engine::Scene> TongueRig::scene(engine::Response response, engine::Collision collision) const {
  engine::SceneDescription d = description_;
  d.response = response;
  d.collision = collision;
  return engine::build_scene(d);
}

engine::Pose TongueRig::pose(double depth, double along, double across) const {
  engine::Mat3 axes;  // the blade's own: x to the handle, z to the tongue
  axes << along_, across_, -normal_;
  engine::Pose pose;
  pose.position = spot_ - (depth - half_) * normal_ + (along - ahead_) * along_ + across * across_;
  pose.rotation = engine::Quat(axes);
  return pose;
}

void TongueRig::aim(TissuePicture& picture, double across, double raised) const {
  Vec3 low = description_.soft.nodes.front(), high = low;
  for (const Vec3& p : description_.soft.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  picture.look(0.5 * (low + high) - raised * normal_, Vec3(-1, 0, 0) + 0.45 * normal_ + 0.35 * along_, normal_, across);
}

QJsonObject TongueRig::about() const {
  return {{"patient", "built-in manikin of the scenario"},
          {"nodes", static_cast<double>(description_.soft.nodes.size())},
          {"tets", static_cast<double>(description_.soft.tets.size())},
          {"young_pa", description_.soft.materials[0].young_pa},
          {"poisson", description_.soft.materials[0].poisson},
          {"tool", QString::fromStdString(blade_)},
          {"step_s", description_.step_s},
          {"version", VALLECULA_VERSION},
          {"instruction_set", QString::fromStdString(engine::instruction_set())}};
}

void write_figure_json(const FigureSetting& setting, const std::string& name, const QJsonObject& json,
                       FigureResult& result) {
  write_file_whole(setting.out / name, QJsonDocument(json).toJson(QJsonDocument::Indented).toStdString());
  result.files.push_back(name);
}

void write_figure_png(const FigureSetting& setting, const std::string& name, const QImage& image,
                      FigureResult& result) {
  write_png(setting.out / name, image);
  result.files.push_back(name);
}

}  // namespace vallecula::gui

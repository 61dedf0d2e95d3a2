#include "gui/session/contact_heat.h"

#include <algorithm>
#include <chrono>

#include "engine/mesh/triangle_bvh.h"

namespace vallecula::gui {
namespace {

constexpr double kSpacing_m = 0.0005, kBand_m = 0.0015;
constexpr double kLeastForce_n = 0.02;  // less is no pressing
constexpr auto kBetweenLooks = std::chrono::milliseconds(30);

engine::SignedDistanceGrid blade_field(const engine::ToolDescription& tool) {
  engine::Vec3 low = engine::Vec3::Constant(1e9), high = -low;
  for (const engine::Vec3& p : tool.surface.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const engine::Vec3 margin = engine::Vec3::Constant(kBand_m);
  return {tool.surface, (low - margin).cwiseMax(tool.tissue_low), (high + margin).cwiseMin(tool.tissue_high), kSpacing_m,
          kBand_m};
}

const engine::StructureLoad& load(const engine::Snapshot& snapshot, engine::Structure structure) {
  return snapshot.loads[static_cast<std::size_t>(structure)];
}

}  // namespace

ContactPressure::ContactPressure(const pipeline::TetMesh& mesh, const engine::ToolDescription& tool)
    : boundary_(soft_boundary(mesh)), blade_(blade_field(tool)) {
  std::vector<char> tongue(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    if (i >= mesh.tissue.size() || mesh.tissue[i] == 0)
      for (int node : mesh.tets[i]) tongue[static_cast<std::size_t>(node)] = 1;
  for (int node : boundary_.node) epiglottis_.push_back(tongue[static_cast<std::size_t>(node)] == 0);
  area_m2_.assign(boundary_.node.size(), 0.0);
  const auto at = [&](int point) {
    const auto& p = mesh.points[static_cast<std::size_t>(boundary_.node[static_cast<std::size_t>(point)])];
    return engine::Vec3(1e-3 * p[0], 1e-3 * p[1], 1e-3 * p[2]);
  };
  for (const auto& t : boundary_.triangles) {
    const double third = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).norm() / 6.0;
    for (int corner : t) area_m2_[static_cast<std::size_t>(corner)] += third;
  }
}

std::vector<ContactPressure::At> ContactPressure::in(const engine::Snapshot& snapshot) const {
  std::vector<At> found;
  const engine::Mat3 to_tool = snapshot.proxy_pose.rotation.conjugate().toRotationMatrix();
  for (const engine::Structure structure : {engine::Structure::tongue, engine::Structure::epiglottis}) {
    const engine::StructureLoad& its = load(snapshot, structure);
    const double force_n = its.force_n.norm();
    if (!(force_n >= kLeastForce_n)) continue;
    const std::size_t first = found.size();
    double area = 0.0, nearest = 1e9;
    int nearest_point = -1;
    for (std::size_t i = 0; i < boundary_.node.size(); ++i) {
      if ((epiglottis_[i] != 0) != (structure == engine::Structure::epiglottis)) continue;
      const float* p = snapshot.soft_points.data() + 3 * static_cast<std::size_t>(boundary_.node[i]);
      const engine::Vec3 point(p[0], p[1], p[2]);
      const double from_centre = (point - its.centre_m).squaredNorm();
      if (from_centre < nearest) {
        nearest = from_centre;
        nearest_point = static_cast<int>(i);
      }
      if (blade_.distance(to_tool * (point - snapshot.proxy_pose.position)) > kTouch_m) continue;
      found.push_back({static_cast<int>(i), 0.0f});
      area += area_m2_[i];
    }
    if (found.size() == first && nearest_point >= 0) {
      found.push_back({nearest_point, 0.0f});
      area = area_m2(nearest_point);
    }
    for (std::size_t i = first; i < found.size(); ++i)
      found[i].kpa = area > 0.0 ? static_cast<float>(1e-3 * force_n / area) : 0.0f;
  }
  return found;
}

ContactHeat::ContactHeat(const ReplayFilm& film, const pipeline::TetMesh& mesh, const engine::ToolDescription& tool)
    : film_(film), pressure_(mesh, tool), frames_(film.plan().frames), peaks_(pressure_.boundary().node.size(), 0.0f) {
  worker_ = std::thread([this] { compute(); });
}

ContactHeat::~ContactHeat() {
  stop_ = true;
  worker_.join();
}

void ContactHeat::compute() {
  for (std::size_t i = 0; i < frames_.size() && !stop_;) {
    if (const engine::Snapshot* frame = film_.frame(i)) {
      frames_[i] = pressure_.in(*frame);
      for (const auto& at : frames_[i])
        if (at.kpa > highest_.load(std::memory_order_relaxed)) highest_.store(at.kpa, std::memory_order_relaxed);
      computed_.store(++i, std::memory_order_release);
    } else if (film_.finished() && film_.frame(i) == nullptr) {
      return;  // it was stopped before this one
    } else {
      std::this_thread::sleep_for(kBetweenLooks);
    }
  }
}

const std::vector<float>& ContactHeat::peaks_until(std::size_t frame) {
  const std::size_t wanted = std::min(frame + 1, computed());
  if (wanted < peaks_of_) {
    std::fill(peaks_.begin(), peaks_.end(), 0.0f);
    peaks_of_ = 0;
  }
  for (; peaks_of_ < wanted; ++peaks_of_)
    for (const auto& at : frames_[peaks_of_]) {
      float& peak = peaks_[static_cast<std::size_t>(at.point)];
      peak = std::max(peak, at.kpa);
    }
  return peaks_;
}

}  // namespace vallecula::gui

#include "tests/gui/arc_patient.h"

#include <algorithm>
#include <cmath>

#include "pipeline/package/label_map.h"
#include "tests/gui/block_patient.h"

namespace vallecula::gui::test {

namespace fs = std::filesystem;
using engine::Vec3;

namespace {

double blend(double from, double to, double s, double a, double b) {
  const double t = std::clamp((s - from) / (to - from), 0.0, 1.0);
  return a + t * t * (3 - 2 * t) * (b - a);
}

}  // namespace

Vec3 ArcAirway::at(double s) const {
  return Vec3(0, 50 + kRadius * (1 - std::cos(s / kRadius)), -40 - kRadius * std::sin(s / kRadius));
}
Vec3 ArcAirway::along(double s) const { return Vec3(0, std::sin(s / kRadius), -std::cos(s / kRadius)); }
Vec3 ArcAirway::front(double s) const { return along(s).cross(Vec3::UnitX()); }
double ArcAirway::half_left(double s) const { return s < 5 ? blend(0, 4.2, s, 1.6, 2.25) : blend(7, 15, s, 2.25, 2.6); }
double ArcAirway::half_front(double s) const { return s < 5 ? blend(0, 4.2, s, 3.5, 2.73) : blend(7, 15, s, 2.73, 2.6); }

pipeline::PatientPackage ArcAirway::patient(double end, double carina) const {
  pipeline::PatientPackage package = block_patient();
  const auto point = [](const Vec3& p) { return pipeline::Point{p.x(), p.y(), p.z()}; };
  package.landmarks["upper_gum_midline"] = {0, 0, 0};
  package.landmarks["vallecula"] = {0, 30.18, -40.24};  // 50.3 mm off
  package.landmarks["glottis_centre"] = point(at(0));
  package.landmarks["glottis_normal"] = point(-along(0));
  package.landmarks["carina"] = point(at(carina));
  package.surfaces["glottis"].points = {{-1.6, at(0).y() + 3.5, at(0).z()}, {1.6, at(0).y() + 3.5, at(0).z()},
                                        {0, at(0).y() - 3.5, at(0).z()}};
  package.surfaces["glottis"].triangles = {{0, 1, 2}};
  pipeline::Surface& airway = package.surfaces["airway"];
  airway = {};
  constexpr int kAround = 96;
  const int rows = static_cast<int>(std::lround((end + kAbove) / 0.4));
  for (int row = 0; row <= rows; ++row) {
    const double s = -kAbove + (end + kAbove) * row / rows;
    for (int i = 0; i < kAround; ++i) {
      const double a = 2 * M_PI * i / kAround;
      airway.points.push_back(point(at(s) + half_left(s) * std::cos(a) * Vec3::UnitX() + half_front(s) * std::sin(a) * front(s)));
    }
  }
  const int top = static_cast<int>(airway.points.size()), bottom = top + 1;
  airway.points.push_back(point(at(-kAbove)));
  airway.points.push_back(point(at(end)));
  for (int i = 0; i < kAround; ++i) {
    const int j = (i + 1) % kAround, last = rows * kAround;
    airway.triangles.push_back({top, j, i});
    airway.triangles.push_back({bottom, last + i, last + j});
    for (int row = 0; row < rows; ++row) {
      const int a = row * kAround;
      airway.triangles.push_back({a + i, a + j, a + kAround + i});
      airway.triangles.push_back({a + j, a + kAround + j, a + kAround + i});
    }
  }
  package.name = "arc";
  return package;
}

fs::path write_arc_patient(const fs::path& folder) {
  pipeline::Grid grid;
  grid.size = {12, 16, 8};
  grid.spacing = {2.0, 2.0, 2.0};
  grid.origin = {-11.0, -15.0, -13.0};
  const fs::path package = folder / "arc.patient";
  pipeline::write_package(ArcAirway().patient(), pipeline::Labels(grid, pipeline::kSkin), package);
  return package;
}

fs::path write_tube_curriculum(const fs::path& folder) {
  write_text(folder / "tube.yaml", R"(schema: 1
id: test-tubes
title: Test tubes
scenarios:
  - id: tube
    title: A tube
    briefing: Hold it.
    debriefing: It was held.
)" +
         usual_demands() +
         R"(    intubation:
      tube: "3.5"
      course: term
      gestation_weeks: 40
      pass:
        outcomes: [abandoned]
)");
  return folder / "tube.yaml";
}

}  // namespace vallecula::gui::test

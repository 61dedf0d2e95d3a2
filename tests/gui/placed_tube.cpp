#include "tests/gui/placed_tube.h"

#include <algorithm>

namespace vallecula::gui::window_test {
namespace {

using engine::Vec3;

Vec3 mm(const pipeline::PatientPackage& package, const char* name) {
  const auto& p = package.landmarks.at(name);
  return {p[0], p[1], p[2]};
}

/// Catmull and Rom's curve through the points, densely, with the length up to each.
struct Way {
  std::vector<Vec3> points;
  std::vector<double> length;
  double zero = 0.0;
};
Way dense(const std::vector<Vec3>& through, std::size_t zero) {
  Way way;
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const Vec3 &b = through[i], &c = through[i + 1];
    const Vec3 a = i > 0 ? through[i - 1] : 2.0 * b - c, d = i + 2 < through.size() ? through[i + 2] : 2.0 * c - b;
    for (int k = 0; k < 60; ++k) {
      const double t = k / 60.0;
      way.points.push_back(0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                                  t * t * t * (3.0 * b - a - 3.0 * c + d)));
    }
  }
  way.points.push_back(through.back() + 200.0 * (through.back() - way.points.back()).normalized());
  way.length = {0.0};
  for (std::size_t i = 1; i < way.points.size(); ++i)
    way.length.push_back(way.length.back() + (way.points[i] - way.points[i - 1]).norm());
  way.zero = way.length[60 * zero];
  return way;
}

Vec3 at(const Way& way, double length) {
  const auto next = std::upper_bound(way.length.begin() + 1, way.length.end() - 1, length);
  const auto i = static_cast<std::size_t>(next - way.length.begin());
  const double t = (length - way.length[i - 1]) / (way.length[i] - way.length[i - 1]);
  return way.points[i - 1] + t * (way.points[i] - way.points[i - 1]);
}

engine::AirwayRing ring(const Vec3& centre_mm, const Vec3& along, engine::AirwayPart part, double half_mm) {
  engine::AirwayRing r;
  r.centre = 1e-3 * centre_mm;
  r.along = along.normalized();
  r.to_left_m = r.to_right_m = r.to_front_m = r.to_back_m = 1e-3 * half_mm;
  r.part = part;
  return r;
}

}  // namespace

engine::IntubationDescription plain_intubation(const pipeline::PatientPackage& package) {
  using engine::AirwayPart;
  engine::IntubationDescription intubation;
  intubation.tube = engine::tube_design("3.5");
  intubation.stylet.emplace();
  const Vec3 glottis = mm(package, "glottis_centre"), cranial = mm(package, "glottis_normal"),
             carina = mm(package, "carina");
  auto& course = intubation.course;
  course.airway.push_back(ring(glottis + 3.0 * cranial, -cranial, AirwayPart::vestibule, 4.0));
  course.airway.push_back(ring(glottis, -cranial, AirwayPart::cords, 2.0));
  course.airway.back().to_front_m = course.airway.back().to_back_m = 0.5 * intubation.glottis.length_m;
  const Vec3 way = carina - glottis;
  for (int k = 1; 3.0 * k < way.norm(); ++k)
    course.airway.push_back(ring(glottis + 3.0 * k * way.normalized(), way,
                                 3 * k < 5   ? AirwayPart::subglottis
                                 : 3 * k < 8 ? AirwayPart::cricoid
                                             : AirwayPart::trachea,
                                 2.5));
  course.airway.push_back(ring(carina, way, AirwayPart::trachea, 2.6));
  const Vec3 mouth = glottis + Vec3(0.0, 9.0, -4.0);
  for (int k = 0; k < 13; ++k)
    course.oesophagus.push_back(ring(mouth + 3.0 * k * way.normalized(), way, AirwayPart::oesophagus, 2.0));
  intubation.secretions.floor = 1e-3 * (glottis + Vec3(0.0, 8.0, 12.0));
  return intubation;
}

void lay_tube(engine::Snapshot& snapshot, const engine::IntubationDescription& intubation,
              const std::vector<Vec3>& way_mm, std::size_t zero, double tip_mm) {
  const Way way = dense(way_mm, zero);
  const double segment = 1e3 * engine::usual_grip_from_tip(intubation.tube) / engine::kTubeSegments;
  snapshot.has_intubation = true;
  for (int i = 0; i < engine::kTubeNodes; ++i) snapshot.tube_axis[i] = 1e-3 * at(way, way.zero - tip_mm + segment * i);
  for (int i = 0; i < engine::kTubeSegments; ++i) {
    engine::Mat3 axes;
    axes.col(0) = (snapshot.tube_axis[i + 1] - snapshot.tube_axis[i]).normalized();
    axes.col(1) = (-Vec3::UnitY()).cross(axes.col(0)).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    snapshot.tube_frames[i] = engine::Quat(axes);
  }
  auto& record = snapshot.intubation;
  record.tip_m = snapshot.tube_axis[0];
  record.tip_direction = (snapshot.tube_axis[0] - snapshot.tube_axis[1]).normalized();
  record.past_cords_m = 1e-3 * tip_mm;
  record.glottis_opening = 0.55;
  record.sao2 = 0.97;
  record.spo2 = 0.97;
  record.heart_per_min = 150.0;
}

std::vector<Vec3> way_to_trachea(const pipeline::PatientPackage& package) {
  const Vec3 glottis = mm(package, "glottis_centre"), out = (mm(package, "operator_eye") - glottis).normalized();
  const Vec3 right = -Vec3::UnitX();
  return {mm(package, "carina"),
          glottis,
          glottis + 25.0 * out + 2.0 * right,
          glottis + 48.0 * out + 7.0 * right,
          glottis + 70.0 * out + 15.0 * right,
          glottis + 95.0 * out + 33.0 * right,
          glottis + 115.0 * out + 60.0 * right};
}

std::vector<Vec3> way_to_oesophagus(const pipeline::PatientPackage& package) {
  auto way = way_to_trachea(package);
  way[0] += Vec3(0.0, 9.0, -4.0);
  way[1] += Vec3(0.0, 9.0, -4.0);
  way[2] += Vec3(0.0, 4.0, 0.0);
  return way;
}

}  // namespace vallecula::gui::window_test

#include <gtest/gtest.h>
#include <cstdio>
#include <cstdlib>
#include <cmath>
#include "gui/session/airway_course.h"
#include "gui/session/anatomy_motion.h"
#include "pipeline/manikin/manikin.h"
#include "pipeline/manikin/manikin_data.h"
namespace vallecula::gui::test {
TEST(BiasDump, Dump) {
  const double w = std::atof(std::getenv("W")); const int seed = std::atoi(std::getenv("SEED"));
  const auto package = pipeline::read_package(std::getenv("PKG"));
  const pipeline::Manikin m(w, seed);
  const double wide = m.scale() * m.data().body.variation().lumen;
  const auto a = airway_of(package);
  double sl = 0, sf = 0; int n = 0;
  const engine::AirwayRing* c = nullptr;
  for (auto& r : a.course.airway) {
    if (r.part == engine::AirwayPart::cricoid) c = &r;
    if (r.part != engine::AirwayPart::trachea) continue;
    const double below = 1e3 * (r.centre - c->centre).norm() / m.scale();
    if (below < 10 || below > 34) continue;
    sl += 1e3 * r.to_left_m; sf += 1e3 * r.to_front_m; ++n;
  }
  std::printf("BIAS w %.1f seed %d wide %.3f: trachea %.3f %.3f truth %.3f bias %.3f %.3f | cricoid %.3f %.3f truth %.3f %.3f bias %.3f %.3f\n", w, seed, wide, sl / n, sf / n, 2.6 * wide, sl / n - 2.6 * wide, sf / n - 2.6 * wide, 1e3 * c->to_left_m, 1e3 * c->to_front_m, 2.25 * wide, 2.73 * wide, 1e3 * c->to_left_m - 2.25 * wide, 1e3 * c->to_front_m - 2.73 * wide);
}
}
